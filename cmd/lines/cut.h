/* SPDX-License-Identifier: MIT */
/* A cut goes over the fields of a line, one after another. */
#ifndef CUT_H
#define CUT_H

#include "formats.h"

/* Returns a cut before the first field of a line. JSON must be checked text that begins
 * with an array or object. */
struct cut cut_line(struct dialect, struct span line);

/* Returns a cut before the first element or member of a JSON value; end is that of the
 * line. */
struct cut cut_value(struct span value, const char *end);

/* Moves the cut to the field after the one whose value ends at s. */
void cut_behind(struct cut *, const char *s);

/* Sets the next field and moves behind it. Returns false after the last field. */
bool cut_next(struct cut *, struct field *);

/* Returns the text that has to be deleted with a field: the field and the separator
 * before it, or after it if it is the first. */
struct span cut_out(const struct field *);

#endif
