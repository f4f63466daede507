/* SPDX-License-Identifier: MIT */
/* The transform of blocks of points by the fastest loop that the precision allows. The loop
 * leaves points that it cannot decide to point_exact. */
#ifndef POINTS_H
#define POINTS_H

#include <stddef.h>

#include "transform.h"

/* Chooses the kernels of this name or, if NULL, the best ones for this processor. Returns
 * false where the processor cannot run them. */
bool points_choose(const char *name);

/* Returns the kernels chosen. */
const struct kernels *points_kernels(void);

/* Computes the images of n <= POINTS_BLOCK points. x, y, z and w are columns of POINTS_BLOCK
 * numbers each. A point without an image is nan, and so is a coordinate beyond the range
 * of doubles. In PRECISION_SINGLE the coordinates are floats, or infinite beyond the
 * floats' range. */
void points_map(const struct transform *, enum precision,
    const double *const in[4], double *const out[4], size_t n);

/* Computes the images of rows of floats as rows of floats, in PRECISION_SINGLE. Returns false
 * where the rows need points_map, as when a point has no image; out is then undefined. */
bool points_map_floats(const struct transform *, const char *in, char *out,
    size_t n);

/* The transform of one point in exact arithmetic: the accurate phase, for the points that
 * the kernels cannot round with certainty. */

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
