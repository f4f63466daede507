/* SPDX-License-Identifier: MIT */
/* Rotations about a vector, and that which is nearest to a matrix. */
#ifndef ROTATION_H
#define ROTATION_H

#include "map.h"

/* The rotation about a vector by its length, in radians: row i of r is axis i of the
 * turned space in the other. False where that is beyond 2 pi. */
bool rotation_about(const double vector[3], struct sum r[3][3]);

/* None where the determinant is not positive, many where two directions have all but
 * vanished. */
enum rotation { ROTATION_FOUND, ROTATION_NONE, ROTATION_MANY };

/* The quaternion x y z w, of any norm and within 2^-250 of it, of the rotation
 * nearest to the upper 3x3 of a matrix: its polar factor. */
enum rotation nearest_rotation(const double matrix[4][4], struct sum q[4]);

#endif
