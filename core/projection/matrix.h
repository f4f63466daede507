/* SPDX-License-Identifier: MIT */
/* Projections of no parameters: a given matrix, which may be of any kind, or none. */
#pragma once

#include "type.h"

bool matrix_check(const struct projection *, struct refusals *);
bool matrix_check_map(const struct projection *, bool inverse, struct refusals *);
bool matrix_map(const struct projection *, const struct convention *, bool inverse,
    struct map *, struct refusals *);
bool matrix_is_reversed(const struct projection *, const struct convention *);

bool none_map(const struct projection *, const struct convention *, bool inverse,
    struct map *, struct refusals *);
bool none_is_reversed(const struct projection *, const struct convention *);
