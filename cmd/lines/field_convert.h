/* SPDX-License-Identifier: MIT */
/* Fields that are no coordinates, from one format to another. */
#ifndef FIELD_CONVERT_H
#define FIELD_CONVERT_H

#include "field.h"

/* Writes f, a field of dialect in, for dialect out: as it stands if that means
 * the same there, else in quotes. Returns where it ends. Takes at most six
 * bytes for each of f, as in \u0001, and two for the quotes. */
char *field_convert(struct dialect in, struct dialect out, struct span f,
    char *at);

#endif
