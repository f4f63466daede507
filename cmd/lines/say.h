/* SPDX-License-Identifier: MIT */
/* Words what is wrong with a line. */
#ifndef SAY_H
#define SAY_H

#include "line.h"

/* Returns whether v, coordinate i, is nan or at most MAGNITUDE_MAX in magnitude; writes
 * the reason if not. */
bool say_range(int i, double v, char reason[REASON_MAX]);

/* Writes why the field f cannot be coordinate i; if f is empty, that it is missing. */
void say_field(const struct layout *, int i, struct span f,
    char reason[REASON_MAX]);

/* Returns whether f is an empty field of csv between blanks that separate; writes what
 * to do. */
bool say_blanks(const struct layout *, const struct field *f,
    char reason[REASON_MAX]);

/* Adds to the reason the names of the columns or members of the cut, and if one of them
 * is near the name typed, asks for it: "; did you mean 'x'? it has x, y, z". If typed is
 * NULL, as --columns is not given, guesses the option: "; say --columns lon,lat,h; it has
 * h, lat, lon". */
void say_names(const struct layout *, struct cut, const char *typed,
    char reason[REASON_MAX]);

/* Writes that the first line of text looks like a header, if none of its first fields
 * is a number. */
void say_text_header(const struct layout *, struct span line,
    char reason[REASON_MAX]);

#endif
