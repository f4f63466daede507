/* SPDX-License-Identifier: MIT */
/* Distances that values of a depth buffer stand for, and the lengths of its steps. */
#pragma once

#include "lens.h"

/* The formats of depth buffers. */
enum depth_buffer { DEPTH_UNORM16, DEPTH_UNORM24, DEPTH_FLOAT32, DEPTH_BUFFERS };

/* A point of depth z on the line along which distances (points/distance.h) are measured
 * has the distance D = (num[0] z + num[1]) / (den[0] z + den[1]). z is device depth;
 * without a viewport, z is 0 to 1. den[0] is 0 only in a parallel projection. The
 * denominator has the sign of w of points in front of the eye. */
struct depth {
	struct sum num[2], den[2];
	double plane[2]; /* z at the near plane, and at the far plane */
	bool open;       /* there are no near and far planes */
	bool constant;   /* the viewport's min_z is max_z; the planes have z 0 and 1 */
};

void depth_of(const struct lens *, struct depth *);

/* Writes the distance of the near or far plane as the quotient num / den. */
void depth_quotient(const struct depth *, bool far, struct sum *num, struct sum *den);

/* Returns the distance of the near or far plane: infinite if the plane is at infinity,
 * nan if the plane is behind the eye or does not exist. */
double depth_distance(const struct depth *, bool far);

/* Returns the length in space of one step of the buffer's depth, from the near or far
 * plane toward the other plane. A step of DEPTH_FLOAT32 ends at the next float.
 * Returns nan if the plane is at infinity or does not exist, or if the whole range of
 * depth is less than a step. */
double depth_step(const struct depth *, enum depth_buffer, bool far);

/* Returns the length in space of one step of the buffer's depth, from points at the
 * given distance toward the eye. A step of DEPTH_FLOAT32 is the distance between the
 * two floats about the depth there. If the depth is a float, the step leads from it to
 * the next float toward the eye or, from the near plane, inward. Returns nan, too, if
 * the whole range of depth is less than a step of the others. */
double depth_step_at(const struct depth *, enum depth_buffer, double distance);
