/* SPDX-License-Identifier: MIT */
/* A line cut into fields, one after the other: nothing is kept of those that
 * were passed, so that a line may have any number of them. */
#ifndef CUT_H
#define CUT_H

#include "field.h"

/* A field: what separators stand around, an element of an array, or a member. */
struct field {
	struct span value; /* without blanks, quotes of csv, or name */
	struct span whole; /* with quotes or name */
	struct span name;  /* a member's, with its quotes; else s is NULL */
	const char *from;  /* the separator before it begins here; NULL: none */
	const char *next;  /* the next field begins here; NULL: none */
	bool comma;        /* in text, the separator before it has a comma */
	bool closed;       /* in csv, its quote is closed */
};

struct cut {
	struct dialect in;
	const char *s, *end; /* the next field, or NULL; the line's end */
	const char *from;    /* the end of the field before */
	const char *bracket; /* in JSON, behind the one that opens */
	bool members;        /* of a JSON object */
	bool words;          /* text whose commas may be decimal points */
	bool comma;
};

/* The cut of a line: past its leading blanks, and in JSON the
 * bracket. JSON must be checked text that begins with one. */
struct cut cut_line(struct dialect, struct span text);

/* The cut of a value inside a line of JSON, an array or object. */
struct cut cut_value(struct span value, const char *end);

/* The cut from behind the field whose value ends at s. */
struct cut cut_behind(struct cut, const char *s);

/* Takes the next field. Returns false where there is none. */
bool cut_next(struct cut *, struct field *);

/* Returns what has to go so that the line has the field no more: also the separator
 * before it, or after it if it is the first. */
struct span field_drop(const struct field *);

#endif
