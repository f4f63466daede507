/* Values of a JSON document, the way to each, and what is wrong with it. */
#ifndef VALUE_H
#define VALUE_H

#include <stdbool.h>
#include <stddef.h>

struct source {
	const char *name;           /* of the file, for messages */
	bool column;                /* how nested rows of a matrix are read */
	bool fit;                   /* what fit finds may be missing */
	const struct member *scene; /* all there is in a document */
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

/* Magnitudes up to 1e150; and sizes, which are at least 1e-150. */
extern const struct range range_any, range_positive;

/* The document; refuses what is no JSON. */
struct value value_parse(const struct source *, char *text, size_t size);
void value_free(const struct value *document);

/* The first element or member and those after it; ends with item NULL. */
struct value value_child(const struct value *);
void value_next(struct value *);

/* Something in an object that isn't there, to be refused. */
struct value value_missing(const struct value *in, const char *name);

bool value_is_object(const struct value *);
bool value_is_array(const struct value *);
bool value_is_null(const struct value *);
const char *value_string(const struct value *); /* NULL: is none */
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

/* Which of words (their end is NULL) a string is. */
int value_word(const struct value *, const char *const *words);

/* Words in quotes, in a row. */
enum { LISTED = 512 };
const char *list_words(char out[LISTED], const char *const *words,
    const char *last);

#endif
