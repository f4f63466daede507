/* SPDX-License-Identifier: MIT */
/* Applies a transform to one point, by the numbers of core/exact. */
#pragma once

#include "transform.h"

/* Computes the doubles nearest to the coordinates of the exact image, for a point that
 * the kernels cannot round with certainty. A coordinate beyond the range of doubles is
 * nan; all coordinates are nan if the point has no image. */
void point_exact(const struct transform *, const double in[4], double out[4]);

/* Returns the float nearest to exact coordinate j; `image` is the nearest double. */
float point_exact_float(const struct transform *, const double in[4], int j,
    double image);

/* Returns coordinate j of the undivided image of the point, times the map's divisor. */
struct sum point_column(const struct transform *, int j, const double in[4]);
