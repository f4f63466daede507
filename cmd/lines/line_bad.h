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

#endif
