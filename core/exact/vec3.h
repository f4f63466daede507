/* SPDX-License-Identifier: MIT */
/* Vectors of three sums. */
#ifndef VEC3_H
#define VEC3_H

#include <stdbool.h>

#include "sum.h"

struct sum vec3_dot(const struct sum a[3], const struct sum b[3]);
void vec3_cross(const struct sum a[3], const struct sum b[3], struct sum r[3]);
struct sum vec3_length(const struct sum a[3]);
bool vec3_is_zero(const struct sum a[3]);

#endif
