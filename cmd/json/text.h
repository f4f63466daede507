/* SPDX-License-Identifier: MIT */
/* Reads the parts of JSON text (RFC 8259): numbers, strings, names, and the ends of
 * values. The functions take any text. They keep nothing and own nothing: each gets a
 * pointer into the caller's text, and returns one. No byte at or after `end` is read,
 * except by json_unescape, which reads the byte after the backslash. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "../message/utf8.h"

/* Returns the end of the number at s, and reads the number to *v unless v is NULL.
 * Returns NULL if JSON has no such number, for example +1, 01, 1., .5, 1e or inf. */
const char *json_number(const char *s, const char *end, double *v);

static inline bool json_is_blank(char c)
{
	return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/* Returns the end of the blanks at s. */
static inline const char *json_skip_blanks(const char *s, const char *end)
{
	while (s < end && json_is_blank(*s))
		s++;
	return s;
}

/* Returns the end of the string that the quote at s opens; `end` if none closes it. */
const char *json_string_end(const char *s, const char *end);

/* Returns the end of the value or member at s: the comma after it, the ] or } that
 * closes the array or object around it, or `end`. In unchecked text ] can close {. */
const char *json_item_end(const char *s, const char *end);

/* Reads at most four hexadecimal digits at s to *code, and returns their end. */
const char *json_hex4(const char *s, const char *end, unsigned *code);

/* Writes to out the character for which the escape at s stands, as *n bytes of UTF-8,
 * and returns the end of the escape. One half of a surrogate pair without the other
 * becomes U+FFFD. In unchecked text, \u may have fewer than four digits. */
const char *json_unescape(const char *s, const char *end, char out[4], int *n);

/* Returns whether a JSON string with its quotes stands for `name`. If `pointer` is set,
 * `name` is a token of a JSON pointer (RFC 6901), in which ~1 is / and ~0 is ~. */
bool json_is_name(struct span string, struct span name, bool pointer);

/* Returns the end of true, false, null or the number at p; NULL if none begins at p. */
const char *json_scalar_end(const char *p, const char *end);

/* Changes *line and *column, which say where `text` is in its file, so that they say
 * where `at` is. Columns are counted in bytes from 1. */
void json_count_lines(const char *text, const char *at, long long *line,
    size_t *column);
