/* SPDX-License-Identifier: MIT */
/* The first line of csv: whether it is a header, and where it says that the
 * coordinates are. */
#ifndef HEADER_H
#define HEADER_H

#include "cut.h"
#include "line.h"

/* Returns whether the first line, which begins with #, is no comment: # is its first
 * field, or it has all the names that are looked for. */
bool header_in_comment(const struct layout *, struct span text);

/* Returns false where the line, which text is but for a byte order mark, is one of
 * points. Else its kind is LINE_HEADER, and the layout's columns are found; or
 * LINE_REFUSED with the reason. */
bool header_read(struct layout *, struct span text, struct line *,
    char reason[REASON_MAX]);

/* Returns whether the first row has more fields, but for an empty last one, than the
 * header before it has names, by which coordinates are found: names may then stand above
 * other columns than they mean. Writes the reason. */
bool header_is_short(const struct layout *, struct cut row,
    char reason[REASON_MAX]);

/* Returns the names on the line: what follows the mark of a text and that of a
 * comment. */
struct span header_names(struct dialect, struct span text);

#endif
