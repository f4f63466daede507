/* SPDX-License-Identifier: MIT */
/* What lies under a position on the device, and how far from the near plane. */
#ifndef PICK_H
#define PICK_H

#include "../points/point.h"

/* From model space: to the device, and along the gaze from the near plane; and
 * where on the device, within which radius. */
struct picker {
	const struct transform *to_device;
	struct transform depth; /* its z */
	double at[2], radius;
};

/* Returns NULL, or the member and the reason. */
const char *picker_of(const struct scene *, const struct transform *to_device,
    struct picker *);

/* Whether a point, whose image's nearest doubles are given, is no further than
 * radius from at on the device, exactly. */
bool pick_holds(const struct picker *, const double in[4],
    const double device[2]);

/* The distance's nearest double; and the sign of that of p less that of q. */
double pick_distance(const struct picker *, const double in[4]);
int pick_compare(const struct picker *, const double p[4], const double q[4]);

#endif
