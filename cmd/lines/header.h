/* SPDX-License-Identifier: MIT */
/* The first line of csv: whether it is a header, and where it says that the
 * coordinates are. */
#ifndef HEADER_H
#define HEADER_H

#include "line.h"

/* Returns whether the first line, which begins with #, is no comment: # is its first
 * field, or it has all the names that are looked for. */
bool header_in_comment(const struct layout *, struct span text);

/* Returns false where the line, which text is but for a byte order mark, is one of
 * points. Else its kind is LINE_HEADER, and the layout's columns are found; or
 * LINE_REFUSED with the reason. */
bool header_read(struct layout *, struct span text, struct line *,
    char reason[REASON_MAX]);

/* Returns the names on the line: what follows the mark of a text and that of a
 * comment. */
struct span header_names(struct dialect, struct span text);

/* Finds the names of the coordinates in a header; s is NULL where there is none. */
void header_places(const struct layout *, struct span text, struct span at[4]);

#endif
