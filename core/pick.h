/* What lies under a position on the device, and how far from the near plane. */
#ifndef PICK_H
#define PICK_H

#include "point.h"

/* Model space to the distance along the gaze from the near plane, within 1/2 +
 * kappa 2^-47 units in the last place. Returns NULL, or the member and the
 * reason. */
const char *depth_transform(const struct scene *, struct transform *);
double depth_of(const struct transform *, const double in[4]);

/* Whether a device position is no further than radius from at, exactly but for
 * 2^-100. */
bool is_within(const double device[2], const double at[2], double radius);

#endif
