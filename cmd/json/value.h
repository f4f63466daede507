/* SPDX-License-Identifier: MIT */
/* Values of a JSON document, and messages with the JSON pointer to a value, such as
 * /camera/eye/0. Only value.c includes cJSON. */
#pragma once

#include <setjmp.h>
#include <stdbool.h>
#include <stddef.h>

#include "../message/message.h"
#include "../message/utf8.h"
#include "../message/words.h"
#include "check.h"

/* What a document is read for, which decides the members that it may lack: fit finds
 * some of them, and --plane needs neither near nor far. */
enum task { TASK_WHOLE, TASK_FIT, TASK_PLANE };

/* The text of a document, and what the functions that read its values need. */
struct json_source {
	const char *name;    /* of the file, for messages */
	long lines_before;   /* lines of the file before the text */
	size_t bytes_before; /* bytes before the text on its first line */
	/* A copy of the text, because reading the points may change the text itself;
	 * NULL if messages give no line and column. */
	const char *text, *end;
	bool column_vectors;   /* matrices are for column, not row, vectors */
	unsigned unit;         /* of angles: an enum angle_unit */
	unsigned implied_type; /* type of a projection without "type"; or 0 */
	enum task task;
	bool flat;                    /* the document is of two dimensions */
	bool has_axes;                /* a convention gives the view axes */
	bool is_operand;              /* is POINTS, which --keep-going never skips */
	const char *two_numbers_hint; /* for points of two numbers; or NULL */
	/* For hints in messages: the rows of a scene, and as bits those of the members
	 * that the command uses. */
	const struct member *scene_members;
	unsigned used;
	const struct member *row; /* of the document: a scene or one object */
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
	const char *wanted;         /* ends a message: "a number ... is wanted" */
	const char *wanted_radians; /* for angles in radians; or NULL */
	bool min_excluded, max_excluded;
};

/* range_any: numbers of at most 1e150 in magnitude; range_positive: 1e-150 to 1e150. */
extern const struct value_range range_any, range_positive;

/* Parses a document and returns its value; refuses text that is not JSON. The values
 * are valid until the next document that is no operand. If the pointer leads to an
 * array, its elements are not parsed, and *array becomes its text; otherwise array->s
 * becomes NULL. A byte order mark in text becomes blanks. */
struct value value_parse_document(struct json_source *, const char *pointer, char *text,
    size_t size, struct span *array);

/* Sets v->item to the type and, for a number, the number of the value at s. The other
 * members of *v stay. The item is valid until the next call. json_check must accept the
 * text. Returns the end of the value, but a wrong end for an array or object. */
const char *value_peek(struct value *v, const char *s, const char *end);

/* Returns the value of a JSON text, such as a default, until a document is parsed. */
struct value value_literal(const char *text);

/* Returns the first element or member of a value, with item NULL if there is none. */
struct value value_child(const struct value *);

/* Replaces *v by the next element or member; after the last, v->item becomes NULL. */
void value_next(struct value *v);

/* A member that an object lacks, for a message that shows the member's pointer. */
#define VALUE_MISSING(object, label)                  \
	(&(struct value){ .source = (object)->source, \
	    .parent = (object),                       \
	    .name = (label) })

/* Sets *member to the first member with the name. Returns false if there is none, as of
 * an array. */
bool value_member(const struct value *object, const char *name, struct value *member);

/* Returns whether the value exists and has the type. */
bool value_is(const struct value *, enum json_type);

/* Returns the text of a string, or NULL for other values. */
const char *value_string(const struct value *);

size_t value_count(const struct value *); /* elements of an array; else 0 */

/* Returns the place of the value to which a pointer leads or, if the value is missing,
 * of the object or array that lacks it. */
struct place json_source_place(const struct json_source *, const char *pointer);

/* Writes the pointer to a value, and returns the value's place. The pointer has a token
 * for each level of brackets. A token with its / has at most TOKEN_MAX bytes: a longer
 * name is cut. */
enum { TOKEN_MAX = 64, POINTER_ROOM = JSON_LEVELS_MAX * TOKEN_MAX + 1 };
struct place value_place(const struct value *, char pointer[POINTER_ROOM]);

/* The faults of the document that was parsed last. All are told before it is refused:
 * object_attempt sets `next`, to which the reading of a member jumps after a fault, and
 * restores it. NULL: nothing is attempted, and the first fault refuses the document. */
extern struct json_faults {
	size_t n, unknown; /* `unknown` of the n are unknown members */
	jmp_buf *next;
} json_faults;

/* A document of more than ten unknown members is meant for another program: from the
 * eleventh on faults are only counted. */
enum { UNKNOWN_TOLD_MAX = 10 };

/* Prints "projcalc: NAME: /pointer: ..." for a fault after which reading goes on. */
void value_fault(const struct value *, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Goes on after faults: where a member is attempted, else exits with 1 or, by
 * --keep-going, goes on with the next document of --scenes. */
_Noreturn void value_give_up(const struct value *);

/* Does what value_fault and then value_give_up do. */
_Noreturn void value_refuse(const struct value *, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Refuses a value of the wrong type: "is a string; a number is wanted". */
_Noreturn void value_refuse_type(const struct value *, const char *wanted);

/* Returns the number of a value; refuses other types, and numbers out of range. */
double value_number(const struct value *, const struct value_range *);

/* Reads an array of exactly n numbers; refuses other values by a message that ends with
 * the hint. */
void value_numbers(const struct value *, const struct value_range *, size_t n,
    const char *hint, double *);

/* Return the index of a string in words[], which NULL ends. Of other values
 * value_find_word returns -1, and value_word refuses them. */
int value_find_word(const struct value *, const char *const *words);
int value_word(const struct value *, const char *const *words);
