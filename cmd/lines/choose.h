/* SPDX-License-Identifier: MIT */
/* Finds the coordinates among the fields of a line by place, name or pointer. */
#ifndef CHOOSE_H
#define CHOOSE_H

#include "line.h"

struct chosen {
	struct field
	    field[4]; /* the fields of the coordinates that were found */
	int times[4]; /* the number of times each was found; 0: missing */
	bool mixed;   /* only some separators of text have a comma */
};

/* Finds the coordinates in one pass over the fields of the cut. */
void choose(const struct layout *, struct cut, struct chosen *);

/* Returns whether a coordinate lies inside the value of another, as pointers allow. */
bool choose_overlaps(const struct layout *, const struct chosen *);

/* Returns whether a column of a header or a member of an object has a name that
 * --append adds, and writes the reason. */
bool choose_clashes(const struct layout *, struct cut, char reason[REASON_MAX]);

/* Returns true if choose_clashes could return true for the object; takes less time. */
bool choose_may_clash(const struct layout *, struct span line);

/* Returns whether the token is the decimal number k without leading zeros. */
bool is_index(struct span token, long k);

/* Returns the number of fields after the cut. */
size_t choose_count(struct cut);

#endif
