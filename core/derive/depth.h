/* SPDX-License-Identifier: MIT */
/* Distances along the gaze, and how finely a depth buffer tells them apart. */
#ifndef DEPTH_H
#define DEPTH_H

#include "../scene/scene.h"

enum buffer { BUFFER_UNORM16, BUFFER_UNORM24, BUFFER_FLOAT32, BUFFERS };

/* The distance of ndc depth z is (over[0] z + over[1]) / (under[0] z + under[1]),
 * along the gaze from the eye, where under[0] is not 0, or from the origin of view
 * space. Depth lies in front where the denominator is positive. Where planes
 * of equal depth are not parallel to the projection plane it holds on the projector
 * through the middle of the device. */
struct depth {
	struct sum over[2], under[2];
	double first; /* the least ndc depth; the greatest is 1 */
	bool reversed,
	    open; /* the near plane has the larger depth; there is none */
};

/* The scene is not degenerate. */
void depth_of(const struct scene *, bool reversed, struct depth *);

/* The distance of the near or far plane, also as a quotient: nan where it lies behind,
 * infinite at infinity. */
void depth_quotient(const struct depth *, bool far, struct sum *over,
    struct sum *under);
double depth_distance(const struct depth *, bool far);

/* The distance, inward from the near or far plane, at which the viewport's depth
 * has changed by one step of the buffer, or has reached the next float: nan at
 * infinity, without the plane, and where the whole range is less than a step.
 * Without a viewport depth runs from 0 to 1. */
double depth_step(const struct depth *, const struct viewport *, enum buffer,
    bool far);

/* The same from a distance toward the eye. */
double depth_step_at(const struct depth *, const struct viewport *, enum buffer,
    double at);

#endif
