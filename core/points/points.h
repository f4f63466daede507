/* SPDX-License-Identifier: MIT */
/* Points through a transform, block by block: each by the fastest loop that
 * its precision allows, and by point_exact where that loop gives up. */
#ifndef POINTS_H
#define POINTS_H

#include <stddef.h>

#include "point.h"

/* Chooses the kernels: the best for this processor, or those named. False
 * where it cannot run them. */
bool points_choose(const char *name);
const struct kernels *points_kernels(void);

/* Images of n <= POINTS_BLOCK points, a column of POINTS_BLOCK each for x, y,
 * z, w. What has no image, or one beyond the range of doubles, is nan. In
 * PRECISION_SINGLE they are floats, unless beyond the range of these. */
void points_map(const struct transform *, enum precision,
    const double *const in[4], double *const out[4], size_t n);

/* From rows of floats to rows of floats, in PRECISION_SINGLE; false where one has no
 * image, or the whole needs points_map: then what out holds is no matter. */
bool points_map_floats(const struct transform *, const char *in, char *out,
    size_t n);

#endif
