/* SPDX-License-Identifier: MIT */
/* Rotations: the matrix of a rotation vector, and the rotation nearest to a matrix. */
#pragma once

#include "map.h"

/* Computes the matrix, for column vectors, of the rotation about a vector by its length
 * in radians. Returns false if the length is above 2 pi. */
bool rotation_about(const double vector[3], struct sum r[3][3]);

/* ROTATION_NONE: the determinant is not positive, as in a matrix that mirrors.
 * ROTATION_MANY: two singular values are so near 0 that no one rotation is nearest. */
enum rotation_result { ROTATION_FOUND, ROTATION_NONE, ROTATION_MANY };

/* Computes the rotation nearest to the upper left 3x3 of a matrix, its polar factor, as
 * a quaternion x y z w of any norm. The error is within 2^-250 of the norm. */
enum rotation_result rotation_nearest(const double matrix[4][4], struct sum q[4]);
