/* Points through a transform, block by block: each by the fastest loop that
 * its accuracy allows, and by point_exact where that loop gives up. */
#ifndef POINTS_H
#define POINTS_H

#include <stddef.h>

#include "point.h"

/* Chooses the kernels: the best for this processor, or those named. False
 * where it cannot run them. */
bool points_choose(const char *name);
const struct kernels *points_kernels(void);

enum { POINTS_BLOCK = 1024 };

/* What points are computed in. With a tolerance above 0, for each point from
 * that point alone, the cheapest precision whose proven bound is at most that
 * in every coordinate. */
struct accuracy {
	enum precision precision;
	double tolerance;
};

/* Images of n <= POINTS_BLOCK points, a column of POINTS_BLOCK each for x, y,
 * z, w. What has no image, or one beyond the range of doubles, is nan.
 * single[i] says that the numbers of point i are floats. */
void points_carry(const struct transform *, const struct accuracy *,
    const double *const in[4], double *const out[4], bool *single, size_t n);

#endif
