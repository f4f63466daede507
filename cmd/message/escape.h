/* SPDX-License-Identifier: MIT */
/* Messages show text of the user with escapes: control characters and invisible
 * characters become \u001b, and bytes that are not UTF-8 become \xff. So the text can't
 * move a terminal's cursor, end the line, or change the direction of writing. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { JSON_ESCAPE_MAX = 6 }; /* bytes that one character may become */

/* Copies s[0..n) to out[0..room) with escapes. If json is true, also escapes quotes and
 * backslashes, as between the quotes of a JSON string, and writes U+FFFD for a byte
 * that is not UTF-8. A copy that does not fit is cut and ends in the string ellipsis.
 * Returns the length of the copy. */
size_t escape_copy(char *out, size_t room, const char *s, size_t n, bool json,
    const char *ellipsis);

/* escape_short copies s[0..n) to out with escapes; a cut copy ends in "...". Returns
 * out. */
enum { ESCAPED_MAX = 64 };
const char *escape_short(char out[ESCAPED_MAX], const char *s, size_t n);
