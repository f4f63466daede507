/* SPDX-License-Identifier: MIT */
/* One point through a transform: the accurate phase, for what the kernels leave
 * undecided. */
#ifndef POINT_H
#define POINT_H

#include "transform.h"

/* The nearest double to each coordinate of the exact image; nan where there is
 * none, or it is beyond the range of doubles. */
void point_exact(const struct transform *, const double in[4], double out[4]);

/* Coordinate j of the point's image, whose nearest double is image, as the nearest
 * float. */
float point_single(const struct transform *, const double in[4], int j,
    double image);

/* Column j of the map at a point, exactly, times the map's divisor. */
struct sum point_column(const struct transform *, int j, const double in[4]);

#endif
