/* Words of the user's in messages. */
#ifndef SHOW_H
#define SHOW_H

#include <stddef.h>

enum { SHOWN = 64 };

/* Copies s[0..n) so that it can be printed: control characters and what is
 * not UTF-8 as escapes, a long text cut. Returns out. */
const char *show(char out[SHOWN], const char *s, size_t n);

/* The length of the UTF-8 character at s; 0 where it is none. */
int utf8_length(const char *s, const char *end);

#endif
