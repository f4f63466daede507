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
	/* A pointer (RFC 6901) or NULL; and what is found: the value to which it
	 * leads, or else the last one on the way there. */
	const char *pointer;
	struct span found;
	/* NULL, or room for the text's size, to whose end it goes. The copy has no
	 * blanks, no members whose names begin with _, no elements of an array to
	 * which the pointer leads, and no number that is too long for cJSON. */
	char *copy;
	const char *at; /* where the text goes wrong, else its end */
	char reason[256];
	int level;
};

/* Returns whether the text is one JSON value of at most 100 levels. */
bool json_check(struct json_check *);

/* Adds to *line the newlines from text to at, and to *column the bytes; or behind a
 * newline sets *column to the bytes from there, counted from 1. */
void json_count(const char *text, const char *at, long long *line,
    size_t *column);

#endif
