/* SPDX-License-Identifier: MIT */
/* Prints JSON, in lines for people or in one line without blanks. */
#ifndef PRINT_H
#define PRINT_H

#include <stdbool.h>

#include "../number/number.h"

struct printer {
	char *at; /* the next byte; there must be room */
	struct number_style style;
	bool single;  /* numbers are floats */
	bool compact; /* no blanks after commas and colons */
	bool on_line; /* members stay on their object's line */
	bool column;  /* rows of a matrix are for column vectors */
	/* The text before the next value: "" for the first one of all, or in an array
	 * or object; else a comma. */
	const char *between;
};

/* Prints text as it is, without a comma before it. */
void put_text(struct printer *, const char *);

/* Print the brackets around the values of an array or the members of an object. */
void put_open(struct printer *, const char *bracket);
void put_close(struct printer *, const char *bracket);

/* Print the name of a member, which needs no escapes; a value has to follow. The second
 * begins a new line, unless on_line is set. */
void put_name(struct printer *, const char *name);
void put_name_on_new_line(struct printer *, const char *name);

void put_string(struct printer *, const char *);
void put_literal(struct printer *, const char *word); /* null, true, false */
void put_number(struct printer *, double v); /* null where not finite */
void put_numbers(struct printer *, const double *v, int n);

#endif
