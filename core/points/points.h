/* SPDX-License-Identifier: MIT */
/* Applies a transform to blocks of points, in one of three precisions. The kernels
 * compute most images; points.c completes what they leave open. */
#pragma once

#include "transform.h"

/* Computes the images of n <= POINTS_BLOCK points. in and out are columns of
 * POINTS_BLOCK numbers for x, y, z and w. Coordinates beyond the range of doubles, and
 * those of points without an image, are nan in PRECISION_EXACT, but may be infinite in
 * other precisions. In PRECISION_SINGLE coordinates are floats, infinite beyond their
 * range. Returns true if all coordinates are finite. */
bool points_map(const struct transform *, enum precision, const double *const in[4],
    double *const out[4], size_t n);

/* Computes the images of rows of floats as rows of floats, in PRECISION_SINGLE. Returns
 * false, and leaves the rows of out undefined, if points_map has to compute the images,
 * for example because a point has no image. */
bool points_map_floats(const struct transform *, const char *in, char *out, size_t n);
