/* SPDX-License-Identifier: MIT */
/* Facts about the picture that a scene makes, and a second scene, with a camera and a
 * projection, that makes the same picture. */
#pragma once

#include "depth.h"
#include "note.h"
#include "rigid.h"
#include "taxonomy.h"

/* Facts about a scene's picture. A number that does not exist is nan; the others are
 * the doubles nearest to the exact numbers, except error_bound. */
struct picture {
	struct taxonomy taxonomy;
	/* Distances of the planes, as in struct depth. far may be infinite. */
	double near, far;
	struct depth depth;
	double aspect;
	bool reverse_z;
	/* The near plane's edges in view space: x of left, right, y of bottom, top. */
	double near_edge[4];
	/* The matrix K takes X, Y, Z of view space to u w, v w, w, with u and v in
	 * pixels from the viewport's corner. X is to the right, Y along device y, Z
	 * along the gaze. */
	double intrinsics[3][3];
	/* a b c d for left, right, bottom, top, near and far: a point x y z of world
	 * space is inside if a x + b y + c z + d >= 0. a b c is a unit vector. */
	double frustum_plane[6][4];
	double error_bound[3]; /* [enum precision] */
	unsigned notes;        /* bit i is set if enum note i applies */
	double up[3];          /* where the picture's up points in the world */
	struct rigid rigid;    /* the camera */
	/* The share of NOTE_RESIDUAL (upright.h), and the range of NOTE_FAR_RANGE; they
	 * are for reading, and have the errors of a few roundings. */
	double residual, far_range[2];
	/* The second scene, in the answer's convention: by eye and gaze, and by edges
	 * or, without near and far planes or if clip x depends on y, by intrinsics. */
	bool has_scene;
	struct scene scene;
};

/* Sets all members of the picture. */
bool picture_of(const struct scene *, struct picture *, struct refusals *faults);

/* Writes the members taxonomy.gaze and up of the picture, or nan. */
void picture_axes(const struct scene *, double gaze[3], double up[3]);

/* Returns those notes of picture_of that are printed, but not NOTE_RADIANS, of which
 * note_of_members has the surer rule; or 0 if the scene has no picture. */
unsigned picture_notes(const struct scene *);
