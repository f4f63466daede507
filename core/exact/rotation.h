/* SPDX-License-Identifier: MIT */
/* Rotations: the matrices of a rotation vector, of an axis and an angle, and of a
 * quaternion; and the rotation nearest to a matrix. */
#pragma once

#include "map.h"
#include "trig.h"

/* Computes the matrix, for column vectors, of the rotation about a vector by its length
 * in radians. Returns false if the length is above 2 pi. */
bool rotation_about(const double vector[3], struct sum r[3][3]);

/* Computes the matrix, for column vectors, of the rotation by an angle about an axis,
 * as r / *d with d = |axis|^2. It is exact if sine, cosine and |axis| are. Returns
 * false if the axis is 0. */
bool rotation_by_angle(const double axis[3], double angle, enum angle_unit,
    struct sum r[3][3], struct sum *d);

/* Computes the matrix, for column vectors, of a quaternion x y z w of any norm, as
 * r / *d, where d is the square of the norm. */
void rotation_of_quaternion(const struct sum q[4], struct sum r[3][3], struct sum *d);

/* Computes the unit quaternion x y z w of a rotation's matrix for column vectors. w is
 * positive or, if it is 0, the first number that is not 0 is. A number whose magnitude
 * is at most its error becomes 0. */
void rotation_quaternion(const struct sum r[3][3], struct sum q[4]);

/* ROTATION_NONE: the determinant is not positive, as in a matrix that mirrors.
 * ROTATION_MANY: two singular values are so near 0 that no one rotation is nearest. */
enum rotation_result { ROTATION_FOUND, ROTATION_NONE, ROTATION_MANY };

/* The bound of the error of each element of the nearest rotation. */
#define ROTATION_BOUND 0x1p-245

/* Computes the rotation nearest to the upper left 3x3 of a matrix, its polar factor, as
 * a quaternion x y z w of any norm. The elements of its rotation have errors of at most
 * ROTATION_BOUND, also if the elements of the matrix have errors: two singular values
 * near 0 then count as such earlier. */
enum rotation_result rotation_nearest(const struct sum matrix[4][4], struct sum q[4]);
