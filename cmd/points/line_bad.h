/* SPDX-License-Identifier: MIT */
/* Bad lines: what is said of them, and where their coordinates would stand. */
#ifndef LINE_BAD_H
#define LINE_BAD_H

#include "line.h"

/* The name of coordinate i: x, y, z or w. */
const char *axis(int i);

/* How a line of JSON is to find coordinate i in an object. */
static inline const char *path_of(const struct layout *l, int i)
{
	return l->columns.n > 0 ? l->columns.name[i] : axis(i);
}

/* Says why f is not coordinate i. */
void say_bad_field(const struct layout *, int i, struct span f,
    char reason[REASON_MAX]);

/* Whether the first line of text, from s on, has no number where coordinates
 * should be; says so then. */
bool say_header_of_text(const struct layout *, struct span,
    char reason[REASON_MAX]);

/* Whether a coordinate of an object stands in another, as pointers can say. */
bool places_overlap(const struct layout *, const struct line *);

/* Finds where the coordinates of the line stand, of which text is what is read,
 * whatever stands there: its kind is LINE_BAD then, or LINE_LOST. */
void line_take_apart(const struct layout *, struct span text, struct line *);

/* Whether what separates the coordinates of text from each other, and two of them
 * from a number after them, has a comma everywhere or nowhere, and none alone is
 * between others and a number; else it may be a decimal point. The first of them
 * begins at s. */
bool commas_agree(const struct layout *, const char *s, const char *end);

/* Whether each quote that opens a field of csv is closed on the line. */
bool quotes_are_closed(struct dialect, struct span text);

#endif
