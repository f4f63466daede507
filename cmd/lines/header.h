/* SPDX-License-Identifier: MIT */
/* Reads the first line of csv, which may be a header that names the columns. */
#pragma once

#include "lookup.h"

/* Returns whether a line that begins with # is a comment. In csv a first line is none
 * if # is a whole field or, without --no-header, the names of all coordinates follow #.
 * A later line such as #N/A,2,3 is none if it has as many fields as the first line. */
bool header_is_comment(const struct layout *, struct span text, bool first);

/* Reads the first line, without byte order mark. Returns false if it is a row. A header
 * sets the columns, header_fields and max_fields, or gets LINE_REFUSED and a reason. */
bool header_read(struct layout *, struct span text, struct line *,
    char reason[REASON_MAX]);

/* Returns whether a row is longer than max_fields below a header; if so, writes why. An
 * empty last field does not count. A longer first row raises max_fields, but not below
 * a header that names a coordinate, or if it has one field more: R leaves out the name
 * of the column of row names, so that each name is one column off. */
bool header_row_is_long(struct layout *, struct cursor row, enum next_part,
    char reason[REASON_MAX]);

/* Returns a cursor over the names of a header, without byte order mark. */
struct cursor header_cursor(struct dialect, struct span text);
