/* SPDX-License-Identifier: MIT */
/* Where the parts of JSON text (RFC 8259) begin and end. Checked text is text
 * that has passed json_check, as either kind; where that is not asked for, text
 * may be anything. Bytes at end and after it are not read. */
#ifndef JSON_TEXT_H
#define JSON_TEXT_H

#include <stdbool.h>

#include "../message/utf8.h"

/* Reads the number that begins at s, as number_read does, and returns where it
 * ends. NULL where none begins, or one that JSON doesn't have: +1, 01, 1., .5,
 * 1e, inf. */
const char *json_number(const char *s, const char *end, double *v);

/* Where the number that begins at s ends, which is not read; NULL where
 * json_number says so. */
const char *json_number_end(const char *s, const char *end);

/* Past the white space at s of checked text, between whose tokens no other
 * character up to ' ' can stand. */
static inline const char *json_space(const char *s, const char *end)
{
	while (s < end && (unsigned char)*s <= ' ')
		s++;
	return s;
}

/* Past the string whose opening quote is at s; end if it isn't closed. */
const char *json_string(const char *s, const char *end);

/* Where the value or member that begins at s ends: at the comma after it or
 * at the bracket, of either kind, that closes what it is in, else at end. In
 * unchecked text, quotes and brackets alone say what belongs together. */
const char *json_skip(const char *s, const char *end);

/* Past the hexadecimal digits that begin at s, four at most. */
const char *json_hex4(const char *s, const char *end, unsigned *code);

/* Writes the character for which the escape at s stands, in a string of checked
 * text, as *n bytes of UTF-8, and returns where the escape ends. Half of a
 * surrogate pair becomes U+FFFD. Of text that is not checked, fewer than four
 * digits may follow \u. */
const char *json_unescape(const char *s, const char *end, char out[4], int *n);

/* Returns whether a string of JSON, with its quotes, is the name, which may be of a
 * pointer: ~1 is /, ~0 is ~. */
bool json_is_name(struct span string, struct span name, bool pointer);

#endif
