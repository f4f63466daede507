/* Sine, cosine and cotangent of degrees, with more digits than are printed of
 * what is made of them. Exact where the result is rational: the arguments are
 * reduced exactly, in degrees. */
#ifndef TRIG_H
#define TRIG_H

#include "sum.h"

/* Relative, where the result is not exact. */
#define TRIG_BOUND 0x1p-300

/* Any finite angle. */
struct sum sin_deg(double angle);
struct sum cos_deg(double angle);

/* Cotangent of an angle in (0, 90]; of half an angle in (0, 180), with all its
 * digits also near 180. */
struct sum cot_deg(double angle);
struct sum cot_half_deg(double angle);

/* An angle in radians. */
struct sum in_degrees(struct sum angle);

#endif
