/* SPDX-License-Identifier: MIT */
/* Sine, cosine and cotangent within TRIG_BOUND, the arc tangent as a double, and
 * rotations. Degrees are reduced exactly, and rational results are exact. */
#ifndef TRIG_H
#define TRIG_H

#include "map.h"

/* The bound of the relative error, where a result is not exact. */
#define TRIG_BOUND 0x1p-313

/* The double nearest to pi; it is below pi. */
#define PI 0x1.921fb54442d18p+1

enum angle_unit { DEGREES, RADIANS };

/* Take any angle in degrees, or an angle up to 2^500 in radians. */
struct sum trig_sin(double angle, enum angle_unit);
struct sum trig_cos(double angle, enum angle_unit);

/* Returns the cotangent of an angle above 0 and up to 90 degrees. */
struct sum trig_cot(double angle, enum angle_unit);

/* Computes sinc = sin x / x and versinc = (1 - cos x) / x^2 of x radians. square = x^2
 * must be exact. Returns false if x is above 2 pi. */
bool trig_sinc(struct sum square, struct sum *sinc, struct sum *versinc);

/* Returns the double nearest to the angle in degrees whose tangent is y / x, from 0 to
 * 180, for y >= 0. Returns nan if both are 0. */
double trig_degrees(struct sum y, struct sum x);

/* Computes the rotation about a vector by its length in radians. Row i of r is axis i
 * of the rotated space. Returns false if the length is above 2 pi. */
bool rotation_about(const double vector[3], struct sum r[3][3]);

/* The results of rotation_nearest. ROTATION_NONE: the determinant is not positive, as
 * of a matrix that mirrors. ROTATION_MANY: two singular values are too near 0, so many
 * rotations are equally near. */
enum rotation { ROTATION_FOUND, ROTATION_NONE, ROTATION_MANY };

/* Computes the rotation nearest to the upper 3x3 of a matrix, its polar factor, as a
 * quaternion x y z w of any norm. The error is within 2^-250 of the norm. */
enum rotation rotation_nearest(const double matrix[4][4], struct sum q[4]);

#endif
