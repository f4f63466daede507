/* SPDX-License-Identifier: MIT */
/* What is said of bad lines. */
#ifndef SAY_H
#define SAY_H

#include "line.h"

/* Says that v, coordinate i, is beyond the range, if it is. Returns whether it is
 * within. */
bool say_range(int i, double v, char reason[REASON_MAX]);

/* Says why f is not coordinate i. */
void say_field(const struct layout *, int i, struct span f,
    char reason[REASON_MAX]);

/* Writes "; did you mean 'x'? it has x, y, z" to the end of the reason: the names in
 * a csv header, or of the members of an object. Where no name is wanted, as the header
 * lacks x, y, z or w, "; say --columns lon,lat,h; it has h, lat, lon". */
void say_names(const struct layout *, struct cut, const char *wanted,
    char reason[REASON_MAX]);

/* Says that the first line of text looks like a header, if it has no number where
 * coordinates should be. */
void say_text_header(const struct layout *, struct span line,
    char reason[REASON_MAX]);

#endif
