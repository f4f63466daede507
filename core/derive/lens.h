/* SPDX-License-Identifier: MIT */
/* The maps and the view volume of a scene, from which the facts about its picture are
 * computed. */
#pragma once

#include "frustum.h"

/* clip[j] is clip coordinate j (x, y, z or w) as a function on view space: three
 * elements are its gradient, the fourth is its value at the origin. Parallel projectors
 * are perpendicular to the gradients of x and y. The gradient of w is normal to the
 * projection plane; if w is constant, the gradient of z is.
 *
 * The corners and the eye are homogeneous points where three planes meet, as the errors
 * of the inverse of to_clip could exceed a small near plane. The corners of near are 0
 * to 3, those of far 4 to 7, in the order left-bottom, right-bottom, right-top,
 * left-top. w of a corner is not negative. Without near and far planes all are at
 * infinity. */
struct lens {
	struct scene scene;              /* which knows the maps below */
	struct map to_view, to_world;    /* from world to view space and back */
	struct map to_clip;              /* from view space */
	struct map sides, ends;          /* from view space, as of frustum_planes */
	struct sum clip[4][4];           /* columns of to_clip; y points upward */
	struct sum half[2], scale[2];    /* set by frustum_limits */
	struct sum corner[8][4], eye[4]; /* in view space */
	struct sum world_corner[8][4], world_eye[4];
	double tolerance;        /* projection_tolerance */
	bool parallel, reversed; /* reversed: near has the larger ndc depth */
	/* The answer's handedness is not the world's, which is that of the document's
	 * convention or, if the camera has axes, theirs. */
	bool mirrors;
};

/* Makes the lens of a scene. */
bool lens_of(const struct scene *, struct lens *, struct refusals *faults);

/* Writes the unit vector in world space along an axis given in view space. */
void lens_world_axis(const struct lens *, const struct sum axis[3], double unit[3]);
