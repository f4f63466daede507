/* SPDX-License-Identifier: MIT */
/* Distances along the gaze, and how finely a depth buffer tells them apart. */
#ifndef DEPTH_H
#define DEPTH_H

#include "../scene/scene.h"
#include "../points/transform.h"

enum buffer { BUFFER_UNORM16, BUFFER_UNORM24, BUFFER_FLOAT32, BUFFERS };

/* The distance D at depth z is (over[0] z + over[1]) / (under[0] z + under[1]). z is
 * device depth or, without a viewport, from 0 to 1. D is measured along the gaze: from
 * the eye in a perspective, else from the origin of view space. under[0] is 0 only in a
 * parallel projection. In a perspective a depth whose denominator is positive is in
 * front of the eye. If planes of equal depth are tilted against the projection plane, D
 * is measured on the normal of the projection plane through the eye. */
struct depth {
	struct sum over[2], under[2];
	double low, high; /* z at the least ndc depth, and at ndc depth 1 */
	bool reversed;    /* the near plane has the larger ndc depth */
	bool open;        /* there are no near and far planes */
	bool flat;        /* min_z equals max_z: low and high are 0 and 1 */
};

/* Finds D(z) of a scene. All maps of the scene must be invertible. reversed says that the
 * near plane has the larger ndc depth. */
void depth_of(const struct scene *, bool reversed, struct depth *);

/* Writes the distance of the near or far plane as a quotient. */
void depth_quotient(const struct depth *, bool far, struct sum *over,
    struct sum *under);

/* Returns the distance of the near or far plane: infinite if the plane is at infinity,
 * nan if it is behind the eye or does not exist. */
double depth_distance(const struct depth *, bool far);

/* Returns how far inward from the near or far plane the depth has changed by one step of
 * the buffer; a step of BUFFER_FLOAT32 ends at the next float. Returns nan if the plane
 * is at infinity or does not exist, or if the whole range of depth is less than a
 * step. */
double depth_step(const struct depth *, enum buffer, bool far);

/* Returns how far from the distance at, toward the eye, the depth has changed by one step
 * of the buffer. */
double depth_step_at(const struct depth *, enum buffer, double at);

/* Upper bounds of the error of a point's image. */

/* Writes for each precision an upper bound of the error of any coordinate of an image, in
 * device units or, without a viewport, ndc units, for points of the view volume that are
 * given in model space. kernel/plain.h derives the bounds. A bound is nan if w could be
 * less than its own error, or 1/w beyond the range of the precision. Returns NULL, or
 * the member and the reason. */
const char *error_bounds(const struct scene *, double bound[3]);

#endif
