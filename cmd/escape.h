/* The user's words in messages. */
#ifndef ESCAPE_H
#define ESCAPE_H

#include <stddef.h>

enum { ESCAPED_MAX = 64 };

/* Copies s[0..n) so that it can be printed: control characters and what is
 * not UTF-8 as escapes, a long text cut. Returns out. */
const char *escaped(char out[ESCAPED_MAX], const char *s, size_t n);

#endif
