/* SPDX-License-Identifier: MIT */
/* The view volume, or the edges of a 2D window, and whether a point is outside. */
#pragma once

#include "../points/transform.h"

enum {
	OUT_LEFT = 1,
	OUT_RIGHT = 2,
	OUT_BOTTOM = 4,
	OUT_TOP = 8,
	OUT_NEAR = 16,
	OUT_FAR = 32,
	OUT_BEHIND = 64,
	OUT_NAN = 128,
};

/* A point is inside if no column of its images under `sides` and `ends` is negative,
 * and w is positive. A 2D window, for which sides.in is 2, does not use `ends`. */
struct frustum {
	struct transform sides; /* to the columns left, right, bottom and top */
	struct transform ends;  /* to the columns near, far and w */
};

/* Finds the limits of ndc x and y: a point is between the side planes if |x| scale[0]
 * <= half[0] and |y| scale[1] <= half[1]. The scene's margin makes half smaller. */
void frustum_limits(const struct scene *, struct sum half[2], struct sum scale[2]);

/* frustum_planes and frustum_of make the planes of the view volume, as linear functions
 * of a point in the space `from`; inside no function is negative. `sides` has the
 * columns left, right, bottom and top, `ends` near, far and w. If `homogeneous` is set,
 * points of device space are x y z 1/w. From a flat space `sides` are the edges of the
 * ndc square, which fills the device, and there are no ends. */
bool frustum_planes(const struct scene *, enum space from, struct map *sides,
    struct map *ends, struct refusals *faults);
bool frustum_of(const struct scene *, enum space from, bool homogeneous,
    struct frustum *, struct refusals *faults);

/* Returns the OUT_ bits of the planes that a point is outside of, decided exactly. A
 * point on a plane is not outside. With OUT_BEHIND or OUT_NAN no other bit is set. */
unsigned frustum_outside(const struct frustum *, const double in[4]);

/* Writes frustum_outside of n points to `out`. `in` has one column per coordinate. */
void frustum_outside_all(const struct frustum *, const double *const in[4],
    unsigned char *out, size_t n);

/* Refuses a projection that has no inverse, and then returns false. */
bool frustum_refuse_singular(const struct scene *, struct refusals *faults);
