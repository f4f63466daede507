/* SPDX-License-Identifier: MIT */
/* Checks that a text is JSON (RFC 8259), finds the value to which a pointer leads, and
 * makes the values of a document. */
#ifndef JSON_CHECK_H
#define JSON_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "../message/span.h"

enum json_type {
	JSON_FALSE,
	JSON_TRUE,
	JSON_NULL,
	JSON_NUMBER,
	JSON_STRING,
	JSON_ARRAY,
	JSON_OBJECT,
};

struct json_value {
	enum json_type type;
	size_t
	    size; /* values in it, itself included: its sibling is v + size */
	double number;
	const char *string;
	const char *name; /* of a member of an object, else NULL */
};

/* The values of a text. An array or object stands before its elements or members. A
 * struct of zeros has no values; it can be used again for another text. */
struct json_values {
	struct json_value *value;
	size_t n, room;
	char *strings,
	    *end; /* names and strings without escapes, each with a NUL */
};

/* Two kinds of text are checked. A document is UTF-8, and its strings hold neither
 * \u0000 nor half of a surrogate pair. A line of points has no newline, and its strings
 * hold any bytes but control characters, and any \u: they are copied and not read. */
enum json_kind { JSON_DOCUMENT, JSON_LINE };

struct json_check {
	enum json_kind kind;
	const char *text, *end; /* bytes at end and after it are not read */
	long line;              /* on which the text begins, for reasons */
	/* A pointer (RFC 6901) or NULL; found is the value to which it leads, or else the
	 * last value on its path. */
	const char *pointer;
	struct span found;
	/* The values of a document are made here, unless it is NULL, but for members whose
	 * names begin with _, and the elements of an array to which the pointer leads. */
	struct json_values *made;
	const char *at; /* the first wrong character, else the text's end */
	char reason[256];
	int level;
};

/* Returns whether the text is one JSON value of at most 100 levels; else sets at and
 * reason. Exits with 3 if there is no memory for the values. */
bool json_check(struct json_check *);

/* Adds to *line the newlines from text to at. Adds to *column the bytes from text to at,
 * or sets it to the number of bytes after the last newline, counted from 1. */
void json_count(const char *text, const char *at, long long *line,
    size_t *column);

#endif
