/* The user's own words in messages. */
#ifndef ESCAPE_H
#define ESCAPE_H

#include <stddef.h>

enum { ESCAPED_MAX = 64 };

/* Copies s[0..n) as a string that can be printed: with escapes for control
 * characters and what is not UTF-8, and if it is long, cut and with "..." at
 * its end. Returns out. */
const char *escaped(char out[ESCAPED_MAX], const char *s, size_t n);

#endif
