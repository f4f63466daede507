/* SPDX-License-Identifier: MIT */
/* Prints JSON to memory, in lines for people or in one line without blanks. */
#pragma once

#include <stdbool.h>

#include "../number/number.h"

struct printer {
	char *at; /* where the next byte is put; the caller provides room */
	struct number_style style;
	bool floats;         /* numbers are printed as floats */
	bool column_vectors; /* matrices are for column, not row, vectors */
	/* If set, everything is in one line, without blanks after commas and colons. If
	 * not, each member of the outermost object begins a line. */
	bool compact;
	int level; /* the number of open brackets */
	/* What is put before the next value: NULL before the first value of the output,
	 * "" before that of an array or of an object, else a comma and perhaps
	 * blanks. */
	const char *separator;
};

void put_text(struct printer *, const char *); /* without the separator before it */

/* put_open begins an array or object with a bracket; put_close ends it with another. */
void put_open(struct printer *, const char *bracket);
void put_close(struct printer *, const char *bracket);

/* Prints the name of a member, whose value is to follow. Returns the same printer. */
struct printer *put_name(struct printer *, const char *name);

void put_string(struct printer *, const char *);      /* NULL: null */
void put_literal(struct printer *, const char *word); /* such as null */
void put_number(struct printer *, double v);          /* null if v is not finite */
void put_distance(struct printer *, double v);        /* or "infinity" */

/* Prints an array of `rows` arrays of n numbers. */
void put_rows(struct printer *, const double *v, int rows, int n);

/* Prints the number *v if n is 0, otherwise an array of n numbers;
 * null if *v is nan. */
void put_numbers(struct printer *, const double *v, int n);
