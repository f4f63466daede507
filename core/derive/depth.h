/* SPDX-License-Identifier: MIT */
/* Distances along the gaze, and how finely a depth buffer tells them apart. */
#ifndef DEPTH_H
#define DEPTH_H

#include "../scene/scene.h"

enum buffer { BUFFER_UNORM16, BUFFER_UNORM24, BUFFER_FLOAT32, BUFFERS };

/* The distance D of depth z is (over[0] z + over[1]) / (under[0] z + under[1]). z is
 * depth on the device or, without a viewport, from 0 to 1. D is measured along the
 * gaze, from the eye of a perspective, in which under[0] is not 0, or from the origin of
 * view space; in a perspective z is in front where the denominator is positive. If
 * planes of equal depth are tilted against the projection plane, D is measured on the
 * normal of the projection plane through the eye. */
struct depth {
	struct sum over[2], under[2];
	double low, high; /* z where ndc depth is least, and where it is 1 */
	bool reversed;    /* the near plane has the larger ndc depth */
	bool open;        /* there are no near and far planes */
	bool flat;        /* min_z equals max_z: low and high are 0 and 1 */
};

/* Finds the function of a scene whose maps are all invertible; reversed says
 * that the near plane has the larger ndc depth. */
void depth_of(const struct scene *, bool reversed, struct depth *);

/* Writes the distance of the near or far plane as a quotient. */
void depth_quotient(const struct depth *, bool far, struct sum *over,
    struct sum *under);

/* Returns the distance of the near or far plane: nan where there is none or the plane is
 * behind the eye, infinite at infinity. */
double depth_distance(const struct depth *, bool far);

/* Returns the distance, inward from the near or far plane, at which depth has changed by
 * one step of the buffer, or has reached the next float: nan at infinity, without the
 * plane, and where the whole range is less than a step. */
double depth_step(const struct depth *, enum buffer, bool far);

/* Returns the distance from a position on the gaze toward the eye at which depth has
 * changed by one step. */
double depth_step_at(const struct depth *, enum buffer, double at);

#endif
