/* SPDX-License-Identifier: MIT */
/* The coordinates among the fields of a line: by place, name or pointer. */
#ifndef CHOOSE_H
#define CHOOSE_H

#include "cut.h"
#include "line.h"

struct chosen {
	struct field field[4]; /* of those that were found */
	int times[4];          /* how often each was found; 0: it is missing */
	bool mixed; /* in text, some separators have a comma, others have not */
};

/* Finds the coordinates in one pass over the fields. */
void choose(const struct layout *, struct cut, struct chosen *);

/* Returns whether one coordinate stands in another, as pointers can say. */
bool choose_overlaps(const struct layout *, const struct chosen *);

/* Returns whether a column of a header or a member of an object has a name that
 * --append adds; says which then. */
bool choose_clashes(const struct layout *, struct cut, char reason[REASON_MAX]);

/* Returns whether an object may have such a member: false is sure. */
bool choose_may_clash(const struct layout *, struct span line);

/* Returns the number of fields that are left of a cut. */
size_t choose_count(struct cut);

#endif
