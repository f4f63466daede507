/* SPDX-License-Identifier: MIT */
/* Points whose images lie near a position on the device, ordered by distance. */
#pragma once

#include "../points/transform.h"

/* A circle on the device. Points with images in it are picked, ordered by `depth`. */
struct picker {
	const struct transform *to_device; /* from model space */
	struct transform depth; /* z of the image is the distance from near */
	double at[2], radius;   /* on the device */
};

/* Sets to_device and depth of a picker. */
bool picker_of(const struct scene *, const struct transform *to_device, struct picker *,
    struct refusals *faults);

/* Returns whether the exact image of a point is in the picker's circle. `device` is the
 * image rounded to the nearest doubles. */
bool pick_is_within(const struct picker *, const double in[4], const double device[2]);

/* Returns the double nearest to a point's distance from the near plane. */
double pick_distance(const struct picker *, const double in[4]);

/* Returns the sign of p's distance from the near plane minus q's. */
int pick_compare(const struct picker *, const double p[4], const double q[4]);
