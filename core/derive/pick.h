/* SPDX-License-Identifier: MIT */
/* The points near a position on the device, and their distances from the near plane. */
#ifndef PICK_H
#define PICK_H

#include "../points/transform.h"

struct picker {
	const struct transform *to_device; /* from model space */
	struct transform depth; /* to z, the distance from the near plane */
	double at[2], radius;   /* on the device */
};

/* Sets all members but at and radius. Returns NULL, or the member and the reason. */
const char *picker_of(const struct scene *, const struct transform *to_device,
    struct picker *);

/* Returns whether the image of a point is within radius of at, decided exactly; device is
 * the image rounded to nearest. */
bool pick_holds(const struct picker *, const double in[4],
    const double device[2]);

/* Returns the double nearest to a point's distance from the near plane. */
double pick_distance(const struct picker *, const double in[4]);

/* Returns the sign of the distance of p minus the distance of q. */
int pick_compare(const struct picker *, const double p[4], const double q[4]);

#endif
