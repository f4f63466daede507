/* A page of JSON, to be read by people too. */
#ifndef PAGE_H
#define PAGE_H

#include "../number/number.h"

struct page {
	char *at; /* where it goes on, in room enough */
	struct number_style style;
	const char *between; /* what the next value follows */
};

void put_text(struct page *, const char *);

/* Brackets, with values between them. */
void enter(struct page *, const char *bracket);
void leave(struct page *, const char *bracket);

/* A member's name; member puts each on a line of its own. */
void put_name(struct page *, const char *name);
void member(struct page *, const char *name);

void put_word(struct page *, const char *word);
void put_number(struct page *, double v); /* null where it is nan */
void put_numbers(struct page *, const double *v, int n);

#endif
