/* SPDX-License-Identifier: MIT */
/* Values of a JSON document, and messages that say with a pointer, such as
 * /camera/eye/0, where in it they stand. No other file knows cJSON. */
#ifndef VALUE_H
#define VALUE_H

#include <stdbool.h>
#include <stddef.h>

#include "../message/message.h"
#include "check.h"

/* Where values come from, and what their readers have to know. */
struct source {
	const char *name; /* of the file, for messages */
	long line;        /* of the file, before the text */
	size_t before;    /* bytes of its first line before the text */
	/* A copy of the text, as points change it; NULL where no message tells a line
	 * and a column. */
	const char *text, *end;
	bool column;      /* nested rows of a matrix: for column vectors */
	unsigned unit;    /* of angles */
	unsigned implied; /* the type of a projection without one; or 0 */
	bool fit;         /* what the command fit finds may be missing */
	bool flat;        /* the document is of two dimensions */
	bool axes;        /* a convention says which way the axes of view go */
	const char *two;  /* what to do with points of two numbers; or NULL */
	bool operand;     /* what is wrong with it ends the program */
	const struct member *scene; /* a scene's members, to suggest one */
};

struct value {
	const struct source *source;
	const struct value *in; /* NULL: the document itself */
	const char *name;       /* of a member, else NULL */
	size_t index;           /* its place in the array or object, from 0 */
	/* It stands in a member that the command doesn't use: its numbers may
	 * be out of range. */
	bool unused;
	const struct cJSON *item;
};

/* The numbers that a member may be. */
struct value_range {
	double min, max;
	const char *says;  /* for a message: which they are */
	const char *by_pi; /* the same in radians, where the limits are too */
	bool above, below; /* min, or max, is not among them */
	bool angle;        /* the limits are degrees */
};

/* Numbers up to 1e150 in magnitude, and angles; sizes, from 1e-150 to 1e150. */
extern const struct value_range range_any, range_turn, range_positive;

/* Parses a document; refuses what is no JSON. The values are there until the next is
 * parsed. But an array to which the pointer leads, large perhaps, is an empty one
 * among the values, and *array is its text, which does not change; else array->s is
 * NULL. */
struct value value_parse_without(struct source *, const char *pointer,
    char *text, size_t size, struct span *array);

/* Makes of *v, whose text was left out so, the value that it is. */
void value_parse_part(struct value *v, const char *s, const char *end);

/* Returns the value of a literal of the program, of which there are at most
 * LITERALS. Each is parsed once and kept. */
enum { LITERALS = 64 };
struct value value_literal(const struct source *, const char *text);

/* The first element or member, and the next; item is NULL if there is none. */
struct value value_child(const struct value *);
void value_next(struct value *);

/* A member that an object lacks, for a message with its pointer. */
struct value value_missing(const struct value *in, const char *name);

/* Finds the member of that name; false if an object has none. */
bool value_member(const struct value *object, const char *name, struct value *);

bool value_is_object(const struct value *);
bool value_is_array(const struct value *);
bool value_is_null(const struct value *);
const char *value_string(const struct value *); /* or NULL */
size_t value_count(const struct value *);

/* Returns the place of the value to which a pointer leads, or that lacks it. */
struct place source_place(const struct source *, const char *pointer);

/* Prints "projcalc: NAME: /pointer: ..." and exits with 1, or where another scene may
 * follow goes on to that. */
_Noreturn void value_refuse(const struct value *, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Refuses a value of the wrong type: "is a string; a number is wanted". */
_Noreturn void value_wrong(const struct value *, const char *wanted);

/* What is not of that type, or out of range, is refused. */
void value_want_object(const struct value *);
double value_number(const struct value *, const struct value_range *);
bool value_flag(const struct value *);

/* An array of exactly n numbers. */
void value_numbers(const struct value *, const struct value_range *, size_t n,
    double *);

/* The index of a string in words, which NULL ends; another is refused. */
int value_word(const struct value *, const char *const *words);

/* Writes words, which NULL ends, each between two of quote, as "a", "b" or "c" where
 * last, which stands before the last one, is " or ". Returns out. */
enum { LISTED = 512 };
const char *list_words(char out[LISTED], const char *const *words,
    const char *last, const char *quote);

#endif
