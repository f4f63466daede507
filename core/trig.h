/* Sine, cosine and cotangent of degrees, in double-double. Exact where the
 * result is rational: the arguments are reduced exactly, in degrees. */
#ifndef TRIG_H
#define TRIG_H

#include "dd.h"

/* Any finite angle. Within TRIG_BOUND u^2, relative. */
enum { TRIG_BOUND = 2 };

dd sin_deg(double angle);
dd cos_deg(double angle);

/* Cotangent of angle in (0, 90]; of half an angle in (0, 180). Within 2
 * TRIG_BOUND + 1 u^2. 180 - angle is exact where it matters, so nothing is lost
 * as the angle nears 180. */
dd cot_deg(double angle);
dd cot_half_deg(double angle);

#endif
