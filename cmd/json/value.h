/* Values of a JSON document, and messages that say where in it they stand. */
#ifndef VALUE_H
#define VALUE_H

#include <stdbool.h>
#include <stddef.h>

struct source {
	const char *name; /* of the file, for messages */
	bool column;      /* nested rows of a matrix: for column vectors */
	bool fit;         /* what the command fit finds may be missing */
	const struct member *scene; /* a scene's members, to suggest one */
};

struct value {
	const struct source *source;
	const struct value *in; /* NULL: the document itself */
	const char *name;       /* of a member, else NULL */
	size_t index;           /* in what it is in */
	/* It is in a member that the command doesn't use: its numbers may be
	 * of any size. */
	bool unused;
	const struct cJSON *item;
};

struct range {
	double min, max;
	const char *wanted;
};

/* Numbers up to 1e150 in magnitude; sizes, from 1e-150 to 1e150. */
extern const struct range range_any, range_positive;

/* Parses a document; refuses what is no JSON. */
struct value value_parse(const struct source *, char *text, size_t size);
void value_free(const struct value *document);

/* The first element or member and those after it; ends with item NULL. */
struct value value_child(const struct value *);
void value_next(struct value *);

/* A member that an object lacks, to be refused with its pointer. */
struct value value_missing(const struct value *in, const char *name);

bool value_is_object(const struct value *);
bool value_is_array(const struct value *);
bool value_is_null(const struct value *);
const char *value_string(const struct value *); /* or NULL */
size_t value_count(const struct value *);

/* Prints "projcalc: NAME: /pointer: ..." and exits. */
_Noreturn void value_refuse(const struct value *, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* "is a string; a number is wanted" */
_Noreturn void value_wrong(const struct value *, const char *wanted);

void value_want_object(const struct value *);
double value_number(const struct value *, const struct range *);
bool value_flag(const struct value *);

/* An array of exactly n numbers. */
void value_numbers(const struct value *, const struct range *, size_t n,
    double *);

/* Which of words (NULL ends them) a string is; refuses another. */
int value_word(const struct value *, const char *const *words);

/* Writes "a", "b" or "c": words (NULL ends them) in quotes, with last, such as
 * " or ", before the last one. */
enum { LISTED = 512 };
const char *list_words(char out[LISTED], const char *const *words,
    const char *last);

#endif
