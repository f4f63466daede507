/* Points through a transform, block by block: each by the fastest loop that
 * its accuracy allows, and by point_exact where that loop gives up. */
#ifndef POINTS_H
#define POINTS_H

#include <stddef.h>

#include "point.h"

/* Chooses the kernels: the best for this processor, or those named. False
 * where it cannot run them. */
bool points_choose(const char *name);

enum { POINTS_BLOCK = 1024 };

/* What points are computed in: a precision; or, with tolerances above 0, double
 * for each point of which that alone says that its error is at most tolerance[j] in
 * every coordinate j, else exact. Four coordinates are exact then. */
struct accuracy {
	enum precision precision;
	double tolerance[3];
};

/* Images of n <= POINTS_BLOCK points, a column of POINTS_BLOCK each for x, y,
 * z, w. What has no image, or one beyond the range of doubles, is nan. In
 * PRECISION_SINGLE they are floats, unless beyond the range of these. */
void points_carry(const struct transform *, const struct accuracy *,
    const double *const in[4], double *const out[4], size_t n);

/* The same in PRECISION_SINGLE for columns of floats; false where that is not all
 * done, and points_carry has to. */
bool points_carry_floats(const struct transform *, const float *const in[3],
    float *const out[3], size_t n);

#endif
