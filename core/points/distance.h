/* SPDX-License-Identifier: MIT */
/* Distances along the gaze, as near and far are measured, and points of a device whose
 * z is such a distance in place of a depth, as in the images of a depth camera. */
#pragma once

#include "transform.h"

/* The distance of a point p of view space is (p, 1) times `column`, over `length`. In a
 * perspective it is measured from the eye: w over the length of w's gradient. In a
 * parallel projection it is measured from the origin of view space along the gaze or,
 * of a projection's matrix, along the gradient of z from near to far. */
struct distance {
	struct sum column[4], length;
	bool parallel;
};

/* Makes the distance of a scene. */
bool distance_of(const struct scene *, struct distance *, struct refusals *faults);

/* Computes the transform of transform_of_scene or, if z of the scene's device is a
 * distance, the transform to or from such a device. In a perspective a distance that is
 * not positive has no image. */
bool distance_transform(const struct scene *, enum space from, enum space to,
    struct transform *, struct refusals *faults);

/* Makes t, whose member map leads from `from` to view space, or from view space to `to`
 * if `from` is a device whose z is a distance, the transform from `from` to `to`. */
bool distance_by_view(const struct scene *, enum space from, enum space to,
    struct transform *t, struct refusals *faults);
