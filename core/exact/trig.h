/* SPDX-License-Identifier: MIT */
/* Sines, cosines and cotangents, and the arc tangent. Angles in degrees are reduced
 * exactly, and rational results, such as the sine of 30 degrees, are exact. */
#pragma once

#include "sum.h"

/* The bound of the relative error of a sine, cosine or cotangent that is not exact. */
#define TRIG_ERROR 0x1p-314

/* The double nearest to pi; it is below pi. */
#define PI 0x1.921fb54442d18p+1

enum angle_unit { ANGLE_DEGREES, ANGLE_RADIANS };

/* Computes the sine and cosine of any angle in degrees, or of up to 2^500 radians. */
void trig_sin_cos(double angle, enum angle_unit, struct sum *sine, struct sum *cosine);

/* Returns the cotangent of an angle above 0 and up to 90 degrees. */
struct sum trig_cot(double angle, enum angle_unit);

/* Computes the factors of Rodrigues' formula, a = sin x / x and b = (1 - cos x) / x^2,
 * of x radians from square, which is exactly x^2. Returns false if x is above 2 pi. */
bool trig_rodrigues(struct sum square, struct sum *a, struct sum *b);

/* Returns atan2(y, x), from 0 to pi or 180; y must be >= 0, and not both are 0. Its
 * relative error is that of x and y and at most 2^-245 more. */
struct sum trig_angle(struct sum y, struct sum x, enum angle_unit);

/* Returns the double nearest to atan2(y, x), from 0 to 180 degrees; y must be >= 0.
 * Returns nan if x and y are 0. */
double trig_atan2(struct sum y, struct sum x, enum angle_unit);
