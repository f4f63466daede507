/* SPDX-License-Identifier: MIT */
/* Writes any line, field by field, with other numbers in the place of its coordinates.
 * All other bytes of the line stay, unless the format changes. */
#pragma once

#include "line.h"
#include "put.h"

/* Returns the room for `lines` lines of `bytes` bytes in all, also
 * as binary records. */
size_t splice_room(const struct layout *, size_t lines, size_t bytes);

/* Writes the line with the numbers and, by --flags, their word in the place of its
 * coordinates or, by --append, after the line. A LINE_LOST becomes the numbers alone. A
 * header loses the names of coordinates that are not written, and gets those of added
 * values; in FORMAT_TEXT it becomes a comment. Leaves out blank lines, comments and
 * headers from or to JSON. Returns the end of the output. */
char *splice_line(const struct layout *, const struct line *,
    const struct image_numbers *, const struct flags *flags, char *out);

/* Writes all fields that hold no coordinate, each after a separator, or from text to
 * text the rest of the line. Returns the end of the output: at most six bytes for each
 * byte of the line plus three for each field. */
char *splice_rest(const struct layout *, const struct line *, char *out);
