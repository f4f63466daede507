/* SPDX-License-Identifier: MIT */
/* What the user wrote, in messages: nothing of it moves a terminal's cursor, ends
 * the line, turns the direction in which the rest is shown, or is not seen. */
#ifndef ESCAPE_H
#define ESCAPE_H

#include <stddef.h>

enum { ESCAPED_MAX = 64 };

/* Copies s[0..n) as a string that can be printed: with escapes for such characters
 * and what is not UTF-8, and if it is long, cut and with "..." at its end.
 * Returns out. */
const char *escaped(char out[ESCAPED_MAX], const char *s, size_t n);

/* The same to out[0..room), cut without a word. Returns how long it is. */
size_t escape_text(char *out, size_t room, const char *s, size_t n);

enum { JSON_ESCAPE_MAX = 6 }; /* bytes of one */

/* The same as what stands between the quotes of a JSON string, which reads as what
 * was written, but for U+FFFD in place of what is not UTF-8. */
size_t escape_json(char *out, size_t room, const char *s, size_t n);

/* The code of the first character that looks like a blank or nothing, escaped or
 * not; else 0. */
unsigned escape_unseen(const char *);

#endif
