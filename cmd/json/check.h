/* SPDX-License-Identifier: MIT */
/* Checks whether text is JSON (RFC 8259), and says what is wrong where it is not. All
 * other readers of JSON in the program, cJSON too, get text that json_check accepted.
 * The caller owns the text; struct json_check points into it, and may be discarded at
 * any time. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "../message/utf8.h"

/* A document is UTF-8, and its strings hold neither \u0000 nor half of a surrogate
 * pair. A line of points has no newline; its strings, which are only copied, may hold
 * any \u escape, and any bytes but control characters. */
enum { JSON_LEVELS_MAX = 200, CJSON_NUMBER_MAX = 63 };

struct json_check {
	bool is_line;           /* the text is a line of points */
	const char *text, *end; /* the bytes from text to end - 1 are checked */
	long line;              /* the number of the first line of text */
	/* A JSON pointer (RFC 6901) or NULL. `found` becomes the value to which the
	 * pointer leads or, if there is none, the last value on the way there. */
	const char *pointer;
	struct span found;
	const char *at;   /* the next character; after an error, the wrong one */
	char reason[256]; /* what is wrong, after an error */
	int level;        /* the number of open brackets */
	/* A number has more than CJSON_NUMBER_MAX bytes, or the name of a member
	 * begins with _. */
	bool needs_edit;
};

/* Returns whether the text is one JSON value with at most JSON_LEVELS_MAX levels of
 * brackets. */
bool json_check(struct json_check *);

/* Returns the end of true, false, null or the number at p; NULL if none begins at p. */
const char *json_scalar_end(const char *p, const char *end);

/* Changes *line and *column, which say where `text` is in its file, so that they say
 * where `at` is. Columns are counted in bytes from 1. */
void json_count_lines(const char *text, const char *at, long long *line,
    size_t *column);
