/* A page of JSON, to be read by people too. */
#ifndef PRINT_H
#define PRINT_H

#include "../number/number.h"

struct printer {
	char *at; /* where it goes on, in room enough */
	struct number_style style;
	const char *between; /* what the next value follows */
};

void put_text(struct printer *, const char *);

/* Brackets, with values between them. */
void enter(struct printer *, const char *bracket);
void leave(struct printer *, const char *bracket);

/* A member's name; member puts each on a line of its own. */
void put_name(struct printer *, const char *name);
void member(struct printer *, const char *name);

void put_word(struct printer *, const char *word);
void put_number(struct printer *, double v); /* null where it is nan */
void put_numbers(struct printer *, const double *v, int n);

#endif
