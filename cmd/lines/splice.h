/* SPDX-License-Identifier: MIT */
/* Writes any line, field by field, with other numbers in the place of its coordinates.
 * All other bytes of the line stay, unless the format changes. */
#pragma once

#include "line.h"
#include "put.h"

/* Returns the room that splice_line needs for `lines` lines of `bytes` bytes in all. */
size_t splice_room(const struct layout *, size_t lines, size_t bytes);

/* Writes the line with the numbers in the place of its coordinates, or by --append
 * after the line. If `flags` of the layout is set, the word of --flags follows the
 * numbers. A LINE_LOST becomes the numbers alone. Blank lines and comments are copied.
 * A header loses the names of coordinates that are not written, and gets the names of
 * added values; in FORMAT_TEXT the header becomes a comment. From JSON or to JSON,
 * leaves out blank lines, comments and headers. Returns the end of the output. */
char *splice_line(const struct layout *, const struct line *,
    const struct image_numbers *, const struct flags *flags, char *out);

/* Writes all fields that hold no coordinate, each after a separator of the output's
 * format. If both formats are FORMAT_TEXT and --columns is not given, writes a blank
 * and the text after the coordinates. Returns the end of the output, which has at most
 * six bytes for each byte of the line plus three for each field. */
char *splice_rest(const struct layout *, const struct line *, char *out);
