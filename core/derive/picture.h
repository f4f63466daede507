/* SPDX-License-Identifier: MIT */
/* Facts about the picture that a scene makes, and a second scene, with a camera and a
 * projection, that makes the same picture. */
#pragma once

#include "depth.h"
#include "taxonomy.h"

/* Faults of a scene, and reasons why it has no second scene (struct picture). */
enum note {
	NOTE_MIRRORED,     /* the picture is a mirror image */
	NOTE_OTHER_HANDED, /* the projection's handedness is not the scene's */
	NOTE_LOOKS_AWAY,   /* the projection looks against the camera's gaze */
	NOTE_TRANSPOSED,   /* the projection's matrix looks transposed */
	NOTE_NEAR_BEYOND,  /* the near plane is farther than the far plane */
	NOTE_DEPTH_FALLS,  /* depth decreases along the convention's gaze */
	NOTE_RADIANS,      /* an angle of view in degrees may be in radians */
	NOTE_OFF_CENTER, /* the principal point is at the viewport's edge or outside */
	/* with each of the following notes there is no second scene */
	NOTE_NO_ROTATION,   /* the camera's matrix is not a rotation */
	NOTE_TILTED,        /* near and far are not parallel to the image */
	NOTE_MINUS_W,       /* w is negative between the near and far planes */
	NOTE_NO_INTRINSICS, /* it would need intrinsics, but cannot have them */
	NOTE_OUT_OF_RANGE,  /* numbers of the second scene are out of range */
	NOTES,
};

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
	/* The second scene, in the answer's convention: by eye and gaze, and by edges or,
	 * without near and far planes or if clip x depends on y, by intrinsics. */
	bool has_scene;
	struct scene scene;
};

/* Sets all members of the picture. Returns NULL, or the member at fault and why. */
const char *picture_of(const struct scene *, struct picture *);
