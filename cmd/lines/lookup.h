/* SPDX-License-Identifier: MIT */
/* Looks up coordinates among fields by index, or by names of columns or members. */
#pragma once

#include "line.h"

/* Elements of struct lookup: 4 coordinates, then added fields. */
enum { SOUGHT_MAX = 4 + COORDINATES_MAX + 1 };

/* The fields that lookup_fields finds: elements 0 to 3 of each array for coordinates,
 * element 4 + k for name k of the layout, if the output adds a field with this name. */
struct lookup {
	const struct layout *l;
	struct cursor c;                /* before the fields of the line */
	struct field field[SOUGHT_MAX]; /* the first field that is found */
	int times[SOUGHT_MAX];          /* the number of fields found */
	/* the indexes, from 0, of the first and the second field found */
	long index[SOUGHT_MAX], second_index[SOUGHT_MAX];
	bool mixed_commas; /* FORMAT_TEXT: only some separators have a comma */

	/* for lookup_fields alone */
	int n;                  /* how many elements are sought */
	bool text;              /* FORMAT_TEXT, whose fields are found by index */
	long last;              /* the index of the last field that is looked at */
	int separators, commas; /* counted separators; those with a comma */
};

void lookup_fields(struct lookup *, const struct layout *, struct cursor);

void lookup_set_parts(const struct lookup *, struct line *);

/* Returns the first coordinate whose value overlaps that of an earlier one; 0: none. */
int lookup_find_overlap(const struct lookup *);

/* Returns whether a column or member has an added name; if so, writes why. */
bool lookup_clashes(const struct lookup *, char reason[REASON_MAX]);

/* Returns whether a token of a JSON pointer is k in decimal, without leading zeros. */
bool field_is_index(struct span token, long k);

/* Returns whether f is a name: no digit or decimal point precedes its first letter.
 * Underscores and other alphabets count as letters; signs such as U+2212 do not. */
bool field_is_name(struct span f);

/* Returns whether the fields where coordinates should be have a name and no number. */
bool lookup_is_header(const struct layout *, struct cursor);
