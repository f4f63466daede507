/* SPDX-License-Identifier: MIT */
/* The transform of one point in exact arithmetic: the accurate phase, for the points that
 * the kernels cannot round with certainty. */
#ifndef POINT_H
#define POINT_H

#include "transform.h"

/* Computes the double nearest to each coordinate of the exact image. A coordinate beyond the
 * range of doubles is nan; so are all where the point has no image. */
void point_exact(const struct transform *, const double in[4], double out[4]);

/* Returns the float nearest to coordinate j of the exact image, whose nearest double is
 * image. */
float point_single(const struct transform *, const double in[4], int j,
    double image);

/* Returns coordinate j of the undivided image of the point, times the map's divisor. */
struct sum point_column(const struct transform *, int j, const double in[4]);

#endif
