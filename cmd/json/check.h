/* SPDX-License-Identifier: MIT */
/* Whether a text is JSON (RFC 8259), and if not, where and why. On the way a value
 * is found in it, and a copy is made that takes less memory. */
#ifndef JSON_CHECK_H
#define JSON_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "../message/utf8.h"

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
	const char *at;   /* the next character; at the end the error, if any */
	char reason[256]; /* the message about the error */
	int level;        /* of nested arrays and objects */
};

/* Returns whether the text is one JSON value of at most 100 levels. */
bool json_check(struct json_check *);

/* Adds the newlines from text to at to *line. Without a newline adds the bytes to
 * *column; else sets *column to the bytes from the last newline to at. */
void json_count(const char *text, const char *at, long long *line,
    size_t *column);

#endif
