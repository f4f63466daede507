/* SPDX-License-Identifier: MIT */
/* Prints JSON, in lines for people or in one line without blanks. */
#ifndef PRINT_H
#define PRINT_H

#include <stdbool.h>

#include "../number/number.h"

struct printer {
	char *at; /* the next byte; there must be room */
	struct number_style style;
	bool single; /* numbers are floats */
	bool column; /* matrices are for column vectors, not row vectors */
	/* Everything is in one line, without blanks after commas and colons. Else each
	 * member of the outermost object begins a line. */
	bool compact;
	int level; /* the number of open brackets */
	/* The text before the next value: "" before the first value of the output, of
	 * an array or of an object; else a comma. */
	const char *between;
};

/* Prints text as it is, without a comma before it. */
void put_text(struct printer *, const char *);

/* Print the brackets around the values of an array or the members of an object. */
void put_open(struct printer *, const char *bracket);
void put_close(struct printer *, const char *bracket);

/* Prints the name of a member, which needs no escapes; a value has to follow. */
void put_name(struct printer *, const char *name);

void put_string(struct printer *, const char *);
void put_literal(struct printer *, const char *word); /* null, true, false */
void put_number(struct printer *, double v); /* null where not finite */
void put_numbers(struct printer *, const double *v, int n);

#endif
