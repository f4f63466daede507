/* SPDX-License-Identifier: MIT */
/* A line cut into fields, one after the other. */
#ifndef CUT_H
#define CUT_H

#include "formats.h"

/* Returns the cut of a line. JSON must be checked text that begins with an array or
 * object. */
struct cut cut_line(struct dialect, struct span line);

/* Returns the cut of a value inside a line of JSON, an array or object. */
struct cut cut_value(struct span value, const char *end);

/* Passes the fields up to that whose value ends at s. */
void cut_behind(struct cut *, const char *s);

/* Takes the next field. Returns false where there is none. */
bool cut_next(struct cut *, struct field *);

/* Returns what goes with the field: the separator before it, or after it if it is
 * the first. */
struct span cut_out(const struct field *);

#endif
