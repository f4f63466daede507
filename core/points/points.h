/* SPDX-License-Identifier: MIT */
/* The transform of blocks of points by the fastest loop that the precision allows. The loop
 * leaves points that it cannot decide to point_exact. */
#ifndef POINTS_H
#define POINTS_H

#include <stddef.h>

#include "point.h"

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

#endif
