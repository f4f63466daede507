/* SPDX-License-Identifier: MIT */
/* The rotation about a vector, and the rotation nearest to a matrix. */
#ifndef ROTATION_H
#define ROTATION_H

#include "map.h"

/* Computes the rotation about a vector by its length in radians: row i of r is axis i of
 * the rotated space. Returns false where the length is above 2 pi. */
bool rotation_about(const double vector[3], struct sum r[3][3]);

/* ROTATION_NONE: the determinant is not positive, so no rotation is nearest.
 * ROTATION_MANY: two singular values are too near 0, so many rotations are. */
enum rotation { ROTATION_FOUND, ROTATION_NONE, ROTATION_MANY };

/* Computes the rotation nearest to the upper 3x3 of a matrix, its polar factor, as a
 * quaternion x y z w of any norm. The error is within 2^-250 of the norm. */
enum rotation rotation_nearest(const double matrix[4][4], struct sum q[4]);

#endif
