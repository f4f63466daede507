/* SPDX-License-Identifier: MIT */
/* Sine, cosine and cotangent, with more digits than are printed of what is made of
 * them. Of degrees, which are reduced exactly, what is rational is exact. */
#ifndef TRIG_H
#define TRIG_H

#include "sum.h"

/* Relative, where the result is not exact. */
#define TRIG_BOUND 0x1p-313

/* The double nearest to pi, and the largest below it. */
#define PI 0x1.921fb54442d18p+1

enum angle_unit { DEGREES, RADIANS };

/* Any angle of degrees; radians up to 2^500. */
struct sum sin_of(double angle, enum angle_unit);
struct sum cos_of(double angle, enum angle_unit);

/* Cotangent of an angle above 0 and up to a right one. */
struct sum cot_of(double angle, enum angle_unit);

/* sin x / x and (1 - cos x) / x^2 of radians x, from x^2, which is exact. False where x is
 * beyond 2 pi. */
bool sinc_of_square(struct sum square, struct sum *sinc, struct sum *versinc);

/* An angle in radians. */
struct sum in_degrees(struct sum angle);

/* The nearest double to the angle in degrees whose tangent is y / x, from 0 to 180, for
 * y >= 0; nan where both are 0. */
double degrees_of(struct sum y, struct sum x);

#endif
