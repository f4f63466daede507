/* SPDX-License-Identifier: MIT */
/* Finds the ends of the parts of JSON text (RFC 8259). Checked text has passed
 * json_check, as a document or as a line. A function takes any text unless its comment
 * asks for checked text. Bytes at end and after it are not read. */
#ifndef JSON_TEXT_H
#define JSON_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "../message/utf8.h"

/* Returns the end of the number at s, and reads it to *v unless v is NULL. Returns NULL
 * if there is no number, or one that JSON does not have: +1, 01, 1., .5, 1e, inf. */
const char *json_number(const char *s, const char *end, double *v);

static inline bool json_is_blank(char c)
{
	return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/* Returns the end of the blanks at s. */
static inline const char *json_space(const char *s, const char *end)
{
	while (s < end && json_is_blank(*s))
		s++;
	return s;
}

/* Returns the end of the string whose opening quote is at s; end if none closes it. */
const char *json_string(const char *s, const char *end);

/* Returns the end of the value or member at s: the comma after it, or the ] or } that
 * closes its array or object; else end. In text that is not checked, ] closes { too. */
const char *json_skip(const char *s, const char *end);

/* Reads the hexadecimal digits at s, four at most, and returns their end. */
const char *json_hex4(const char *s, const char *end, unsigned *code);

/* Writes the character of the escape at s, in a string, as *n bytes of UTF-8. Returns
 * the end of the escape. Half of a surrogate pair becomes U+FFFD. In text that is not
 * checked, \u may have fewer than four digits. */
const char *json_unescape(const char *s, const char *end, char out[4], int *n);

/* Returns whether a string of JSON, with its quotes, is the name. If pointer is set,
 * the name is a token of a pointer (RFC 6901), in which ~1 is / and ~0 is ~. */
bool json_is_name(struct span string, struct span name, bool pointer);

/* json_check decides whether a text is JSON, and if not, says where and why. It also
 * finds a value in the text, and makes a copy that takes cJSON less memory. */

/* Two kinds of text are checked. A document is UTF-8, and its strings hold
 * neither \u0000 nor half of a surrogate pair. A line of points has no newline. As
 * its strings are copied and not read, they may hold any bytes but control
 * characters, and any \u. */
enum json_kind { JSON_DOCUMENT, JSON_LINE };

struct json_check {
	enum json_kind kind;
	const char *text, *end; /* bytes at end and after it are not read */
	long line;              /* on which the text begins, for reasons */
	/* A pointer (RFC 6901) or NULL. found becomes the value to which it leads; if
	 * there is none, the last value on its path. */
	const char *pointer;
	struct span found;
	/* NULL, or room for a copy, as large as the text; json_check moves it to the
	 * copy's end. The copy has no blanks, no members whose names begin with _, no
	 * elements of an array to which the pointer leads, and no number that is too
	 * long for cJSON. */
	char *copy;
	const char *at;   /* the next character; in a refusal the wrong one */
	char reason[256]; /* the message of a refusal */
	int level;        /* the number of open brackets */
};

/* Returns whether the text is one JSON value of at most 100 levels. */
bool json_check(struct json_check *);

/* Returns the end of true, false, null or the number at p; NULL if none begins at p. */
const char *json_scalar_end(const char *p, const char *end);

/* Adds the newlines from text to at to *line. Without a newline adds the bytes to
 * *column; else sets *column to the bytes from the last newline to at. */
void json_count(const char *text, const char *at, long long *line,
    size_t *column);

#endif
