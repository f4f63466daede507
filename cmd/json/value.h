/* SPDX-License-Identifier: MIT */
/* Values of a JSON document. Only value.c includes cJSON. Each function that refuses a
 * value adds to the list of the document's refusals, with the JSON pointer to the
 * value, such as /camera/eye/0, and returns false. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "../../core/refusal/refusal.h"
#include "../message/message.h"
#include "../message/utf8.h"
#include "../message/words.h"

enum { JSON_LEVELS_MAX = 200 };

/* What a document is read for, which decides the members that it may lack: fit finds
 * some of them, and --plane needs neither near nor far. */
enum task { TASK_WHOLE, TASK_FIT, TASK_PLANE };

/* The text of a document, and what the functions that read its values need. */
struct json_source {
	const char *name;    /* of the file, for messages */
	long lines_before;   /* lines of the file before the text */
	size_t bytes_before; /* bytes before the text on its first line */
	const char *begin;   /* of the text in memory */
	/* A copy of the text, because cutting the points changes the text itself; NULL
	 * if messages give no line and column. */
	const char *text, *end;
	/* the value of the text, if it is a document that is JSON */
	const struct cJSON *root;
	/* For messages: the rows of a scene, and the row of the document itself, which
	 * is a scene or one object of it. */
	const struct member *scene_members, *row;
	struct refusals *faults;

	/* What the call asks for. */
	enum task task;
	unsigned implied_type;        /* type of a projection without "type"; or 0 */
	const char *two_numbers_hint; /* for points of two numbers; or NULL */

	/* What the members that were read say of the others. */
	unsigned unit;            /* of angles: an enum angle_unit */
	bool column_vectors;      /* matrices are for column, not row, vectors */
	bool has_convention;      /* the document or the call names one */
	bool is_convention_wrong; /* it was refused */
	bool flat;                /* the document is of two dimensions */
	bool is_camera;           /* the camera is read, which needs a convention */
};

/* The types of values; cJSON writes a type as 1 << an enum json_type. */
enum json_type {
	JSON_FALSE,
	JSON_TRUE,
	JSON_NULL,
	JSON_NUMBER,
	JSON_STRING,
	JSON_ARRAY,
	JSON_OBJECT,
};

struct value {
	const struct json_source *source;
	const struct value *parent; /* the array or object around it, or NULL */
	const char *name;           /* of a member, or NULL */
	size_t index;               /* of an element or member, from 0 */
	/* The command does not use the value: its numbers may be out of range. */
	bool unused;
	const struct cJSON *item; /* NULL: the value is missing */
};

/* The range that the number of a value must be in. */
struct value_range {
	double min, max;
	const char *wanted;         /* as "a number from 0 to 1 is wanted" */
	const char *wanted_radians; /* for angles in radians; or NULL */
	bool min_excluded, max_excluded;
};

/* range_any: numbers of at most 1e150 in magnitude; range_positive: 1e-150 to 1e150. */
extern const struct value_range range_any, range_positive;

/* Parses a document and sets *root to its value, or refuses text that is not JSON. The
 * values are valid until the next document is parsed. The elements of the array
 * `points` of the outermost object are not parsed: *points becomes the array's text,
 * from [ to ], or its s becomes NULL. A byte order mark in text becomes blanks. */
bool value_parse_document(struct json_source *, char *text, size_t size,
    struct value *root, struct span *points);

/* Returns the value of a JSON text, such as a default, until the next call. */
struct value value_literal(const char *text);

/* Returns the first element or member of a value, with item NULL if there is none. */
struct value value_child(const struct value *);

/* Replaces *v by the next element or member; after the last, v->item becomes NULL. */
void value_next(struct value *v);

/* A member of an object, which may lack it, by its name: for messages alone. */
#define VALUE_NAMED(object, label)                    \
	(&(struct value){ .source = (object)->source, \
	    .parent = (object),                       \
	    .name = (label) })

/* Returns whether the value exists and has the type. */
bool value_is(const struct value *, enum json_type);

/* Returns the text of a string, or NULL for other values. */
const char *value_string(const struct value *);

size_t value_count(const struct value *); /* elements of an array; else 0 */

/* Refuses a value: adds what is wrong with it and what would be right, which may be
 * NULL, to the list of the source. Returns false. */
bool value_refuse(const struct value *, const char *what, const char *remedy);

/* Refuses a value of the wrong type: "is a string; a number is wanted". */
bool value_refuse_type(const struct value *, const char *wanted);
bool value_refuse_as(const struct value *, enum json_type, const char *wanted);

/* Refuses an array of n elements: "has 2 elements". */
bool value_refuse_count(const struct value *, size_t n, const char *remedy);

/* Read a number, or an array of exactly n numbers. Refuse other types, and numbers out
 * of range. */
bool value_number(const struct value *, const struct value_range *, double *);
bool value_in_range(const struct value *, const struct value_range *, double);
bool value_numbers(const struct value *, const struct value_range *, size_t n,
    double *);

/* Sets *index to that of a string in words[], or of an alias of it (struct member).
 * Refuses other values. */
bool value_word(const struct value *, const char *const *words,
    const char *const *aliases, unsigned *index);
