/* SPDX-License-Identifier: MIT */
/* Writing JSON: lines for people to read, or one line without blanks. */
#ifndef PRINT_H
#define PRINT_H

#include <stdbool.h>

#include "../number/number.h"

struct printer {
	char *at; /* where to write next; there must be room enough */
	struct number_style style;
	bool single;  /* numbers are floats */
	bool compact; /* no blanks after commas and colons */
	bool on_line; /* members stay on their object's line */
	bool column;  /* rows of a matrix are for column vectors */
	/* What stands before the next value: "" before the first of an array
	 * or object and at the beginning, else a comma. */
	const char *between;
};

/* Puts text as it is, without a comma before it. */
void put_text(struct printer *, const char *);

/* The brackets around an array's values, or an object's members. */
void put_open(struct printer *, const char *bracket);
void put_close(struct printer *, const char *bracket);

/* A member's name, which needs no escapes, on this line or a new one, unless all is
 * on_line; its value is to be put next. */
void put_name(struct printer *, const char *name);
void put_name_on_new_line(struct printer *, const char *name);

void put_string(struct printer *, const char *);
void put_literal(struct printer *, const char *word); /* null, true or false */
void put_number(struct printer *, double v);       /* null where not finite */
void put_numbers(struct printer *, const double *v, int n);

#endif
