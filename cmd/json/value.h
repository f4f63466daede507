/* SPDX-License-Identifier: MIT */
/* Values of a JSON document, and messages with the pointer to a value, such as
 * /camera/eye/0. No other file knows cJSON. */
#ifndef VALUE_H
#define VALUE_H

#include <stdbool.h>
#include <stddef.h>

#include "../message/message.h"
#include "text.h"

/* The text that values come from, and what their readers have to know. */
struct source {
	const char *name; /* of the file, for messages */
	long line;        /* lines of the file before the text */
	size_t before;    /* bytes before the text on its first line */
	/* A copy of the text, whose bytes the reader of points may change; NULL if
	 * messages give no line and column. */
	const char *text, *end;
	bool column;      /* matrices are for column vectors, not row vectors */
	unsigned unit;    /* of angles: an enum angle_unit */
	unsigned implied; /* the type of a projection without a type; or 0 */
	bool fit;  /* the members that the command fit finds may be missing */
	bool flat; /* the document is of two dimensions */
	bool axes; /* a convention gives the view axes */
	const char *two; /* a hint for points of two numbers; or NULL */
	bool
	    operand; /* an operand, not a scene: a refusal ends --scenes, too */
	const struct member *scene; /* the scene's members, for suggestions */
};

/* In the order of the bits of cJSON's types. */
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
	const struct source *source;
	const struct value
	    *in;          /* the array or object with the value; NULL: none */
	const char *name; /* of a member, else NULL */
	size_t index;     /* of an element or member, from 0 */
	/* The command does not use the member: its numbers may be out of range. */
	bool unused;
	const struct cJSON *item; /* NULL: there is no such value */
};

/* The numbers that are allowed as a member. */
struct value_range {
	double min, max;
	const char *wanted; /* for a message: "a number ... is wanted" */
	/* as wanted, for angles in radians; NULL: the range has no unit */
	const char *by_radians;
	bool above, below; /* min is excluded; max is excluded */
};

/* Any number; a number greater than 0, which the manual calls a size. */
extern const struct value_range range_any, range_positive;

/* Parses a document and returns its value; refuses text that is not JSON. The values
 * are valid until the next call. An array to which the pointer leads has no elements in
 * the values, and *array is its text; otherwise array->s is NULL. A byte order mark in
 * text becomes blanks. */
struct value value_parse_without(struct source *, const char *pointer,
    char *text, size_t size, struct span *array);

/* Makes *v the value at s of checked text, with type and number alone, until the next
 * call. Returns the end of the value, but only if it is no array or object. */
const char *value_peek(struct value *v, const char *s, const char *end);

/* Returns the value of a literal of the program, which is parsed once and kept. There
 * are at most LITERALS. */
enum { LITERALS = 64 };
struct value value_literal(const char *text);

/* Returns the first element or member; its item is NULL if there is none. */
struct value value_child(const struct value *);

/* Replaces *v by the next element or member of v->in; after the last, item is NULL. */
void value_next(struct value *v);

/* A member that an object lacks, for a message with its pointer. */
#define VALUE_MISSING(object, label)                  \
	(&(struct value){ .source = (object)->source, \
	    .in = (object),                           \
	    .name = (label) })

/* Finds the first member of that name; returns false if there is none. */
bool value_member(const struct value *object, const char *name,
    struct value *member);

/* Returns whether there is a value and it has the type. */
bool value_is(const struct value *, enum json_type);

/* Returns the string that a value is, else NULL. */
const char *value_string(const struct value *);

/* Returns the number of elements or members. */
size_t value_count(const struct value *);

/* Returns the place of the value to which a pointer leads, or of the object or array
 * that lacks it. */
struct place source_place(const struct source *, const char *pointer);

/* Prints "projcalc: NAME: /pointer: ..." and exits with 1, or goes on to the next of
 * --scenes. */
_Noreturn void value_refuse(const struct value *, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Refuses a value of the wrong type: "is a string; a number is wanted". */
_Noreturn void value_wrong(const struct value *, const char *wanted);

/* Returns the number that a value is; refuses other types, and numbers out of range. */
double value_number(const struct value *, const struct value_range *);

/* Reads an array of exactly n numbers; refuses other values. */
void value_numbers(const struct value *, const struct value_range *, size_t n,
    double *);

/* Returns the index of a string in words, which end with NULL; refuses other values. */
int value_word(const struct value *, const char *const *words);

/* Writes a list of words, which end with NULL, with quote before and after each word:
 * "a", "b" or "c" if last is " or ". A list is cut at LISTED bytes. Returns out. */
enum { LISTED = 512 };
const char *list_words(char out[LISTED], const char *const *words,
    const char *last, const char *quote);

#endif
