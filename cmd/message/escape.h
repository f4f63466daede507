/* SPDX-License-Identifier: MIT */
/* What the user wrote, in messages: nothing of it moves a terminal's cursor, ends
 * the line, turns the direction in which the rest is shown, or is not seen. */
#ifndef ESCAPE_H
#define ESCAPE_H

#include <stdbool.h>
#include <stddef.h>

enum { JSON_ESCAPE_MAX = 6 }; /* bytes of one */

/* Copies s[0..n) to out[0..room) as a string that can be printed, with escapes for such
 * characters and what is not UTF-8; or as what stands between the quotes of a JSON
 * string, which reads as what was written, but for U+FFFD in place of what is not UTF-8.
 * If it is long, it is cut and has more at its end. Returns how long the copy is. */
size_t escape_copy(char *out, size_t room, const char *s, size_t n, bool json,
    const char *more);

/* The same as a string that can be printed, with "..." where it is cut. Returns out. */
enum { ESCAPED_MAX = 64 };
const char *escaped(char out[ESCAPED_MAX], const char *s, size_t n);

/* The code of the first character that looks like a blank or nothing, in a string with
 * such escapes; else 0. */
unsigned escape_unseen(const char *);

#endif
