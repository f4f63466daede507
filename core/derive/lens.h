/* SPDX-License-Identifier: MIT */
/* The maps of a scene, from which the facts about its picture are computed. */
#pragma once

#include "frustum.h"

/* The maps of a scene. clip[j] is clip coordinate j (x, y, z or w) as a function on
 * view space: three elements are its gradient, the fourth is its value at the origin.
 * Parallel projectors are perpendicular to the gradients of x and y. The gradient of w
 * is normal to the projection plane; if w is constant, the gradient of z is. */
struct lens {
	const struct scene *scene;
	struct volume volume;
	struct map to_view, to_world; /* from world to view space and back */
	struct sum clip[4][4];        /* columns of volume.to_clip; y points upward */
	struct sum half[2], scale[2]; /* set by frustum_limits */
	bool parallel, reversed;      /* reversed: near has the larger ndc depth */
	bool mirrors; /* the answer's handedness is not the document's */
};

/* Makes the maps of a scene. Returns NULL, or the member at fault and why. */
const char *lens_of(const struct scene *, struct lens *);

/* Writes the unit vector in world space along an axis given in view space. */
void lens_world_axis(const struct lens *, const struct sum axis[3], double unit[3]);
