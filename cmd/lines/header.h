/* SPDX-License-Identifier: MIT */
/* Decides whether the first line of csv is a header, and finds the coordinates by its
 * names. */
#ifndef HEADER_H
#define HEADER_H

#include "line.h"

/* Returns whether the first line, which begins with #, is a header or a row and not a
 * comment: # is a field alone, or the names of all coordinates follow. */
bool header_in_comment(const struct layout *, struct span text);

/* Reads the first line, whose text has no byte order mark. Returns false if the line is
 * a row. Else sets its kind to LINE_HEADER, and the layout's columns and fields; or to
 * LINE_REFUSED, with the reason. */
bool header_read(struct layout *, struct span text, struct line *,
    char reason[REASON_MAX]);

/* Returns whether the first row has more fields than the header has names, and coordinates
 * are found by name; if so, writes the reason. An empty last field does not count. R
 * writes such tables: its column of row names has no name in the header, so that each
 * name is one column too far to the left. */
bool header_is_short(const struct layout *, struct cut row,
    char reason[REASON_MAX]);

/* Returns the header without a byte order mark and the # of a comment. */
struct span header_names(struct dialect, struct span text);

#endif
