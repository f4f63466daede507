/* Sine, cosine and cotangent of degrees, with more digits than a double-double
 * keeps, so that what is made of them is rounded once. Exact where the result
 * is rational: the arguments are reduced exactly, in degrees. */
#ifndef TRIG_H
#define TRIG_H

#include "exact.h"

/* Relative. */
#define TRIG_BOUND 0x1p-200

/* Any finite angle. */
ex sin_deg(double angle);
ex cos_deg(double angle);

/* Cotangent of an angle in (0, 90]; of half an angle in (0, 180), with all its
 * digits also near 180. */
ex cot_deg(double angle);
ex cot_half_deg(double angle);

#endif
