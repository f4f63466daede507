/* SPDX-License-Identifier: MIT */
/* The first line of csv: whether it is a header, and where it says that the
 * coordinates are. */
#ifndef HEADER_H
#define HEADER_H

#include "line.h"

/* Whether the first line is a comment that is a header, too, or only: it is to be
 * one, or has all the names that are looked for. */
bool header_in_comment(struct layout *, struct span text);

/* Returns false where the line, which text is but for a byte order mark, is one of
 * points. Else its kind is LINE_HEADER, or LINE_LOST with the reason, and the
 * layout's columns are found; or -1, where it has none of that name. */
bool header_read(struct layout *, struct span text, struct line *,
    char reason[REASON_MAX]);

/* The names on the line: past the mark of a text and that of a comment. */
struct span header_names(struct dialect, struct span text);

/* Finds the names of the coordinates in a header; s is NULL where there is none. */
void header_places(const struct layout *, struct span text, struct span at[4]);

#endif
