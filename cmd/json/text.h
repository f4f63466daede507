/* SPDX-License-Identifier: MIT */
/* Finds the ends of the parts of JSON text (RFC 8259). Checked text has passed json_check,
 * as either kind; a function that does not ask for it takes any text. Bytes at end and
 * after it are not read. */
#ifndef JSON_TEXT_H
#define JSON_TEXT_H

#include <stdbool.h>

#include "../message/utf8.h"

/* Reads the number at s and returns its end; returns NULL if there is none, or one that
 * JSON does not have: +1, 01, 1., .5, 1e, inf. */
const char *json_number(const char *s, const char *end, double *v);

/* Returns the end of the number as json_number does, without its value. */
const char *json_number_end(const char *s, const char *end);

/* Returns the end of the blanks at s of checked text, whose only characters up to ' ' are
 * blanks. */
static inline const char *json_space(const char *s, const char *end)
{
	while (s < end && (unsigned char)*s <= ' ')
		s++;
	return s;
}

/* Returns the end of the string whose opening quote is at s; end if it is not closed. */
const char *json_string(const char *s, const char *end);

/* Returns the end of the value or member at s: the comma after it, or the bracket of
 * either kind that closes its array or object; else end. In text that is not checked only
 * quotes and brackets count. */
const char *json_skip(const char *s, const char *end);

/* Reads the hexadecimal digits at s, four at most, and returns their end. */
const char *json_hex4(const char *s, const char *end, unsigned *code);

/* Writes the character of the escape at s, in a string of checked text, as *n bytes of
 * UTF-8, and returns the end of the escape. Half of a surrogate pair becomes U+FFFD. In
 * text that is not checked \u may have fewer than four digits. */
const char *json_unescape(const char *s, const char *end, char out[4], int *n);

/* Returns whether a string of JSON, with its quotes, is the name; in a token of a pointer
 * ~1 is / and ~0 is ~. */
bool json_is_name(struct span string, struct span name, bool pointer);

#endif
