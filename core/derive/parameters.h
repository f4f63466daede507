/* SPDX-License-Identifier: MIT */
/* What of a scene's picture can be said in parameters: its planes, and a camera and
 * a projection that make it. */
#ifndef PARAMETERS_H
#define PARAMETERS_H

#include "depth.h"
#include "taxonomy.h"

/* What is unusual about a scene, and why there is none in parameters. */
enum note {
	NOTE_MIRRORED,    /* the picture is a mirror image */
	NOTE_HANDED,      /* as of the other handedness */
	NOTE_AWAY,        /* the projection looks against the camera's gaze */
	NOTE_TRANSPOSED,  /* the projection's matrix, in all likelihood */
	NOTE_NEAR_BEYOND, /* near is farther than far */
	NOTE_BACKWARD,    /* depth falls along the convention's gaze */
	/* there is no scene, as: */
	NOTE_NO_ROTATION, /* the camera's matrix is none */
	NOTE_TILTED,      /* near and far are not parallel to the picture */
	NOTE_BEHIND,      /* w is negative everywhere */
	NOTE_SKEWED,      /* nothing but intrinsics says that x depends on y */
	NOTE_RANGE,       /* a plane is behind the eye, a number out of range */
	NOTES,
};

/* All are nearest doubles; nan stands for what there is not. */
struct parameters {
	/* From the eye, in a parallel projection from the origin of view space along
	 * the convention's gaze. far may be infinite. */
	double near, far;
	struct depth depth;
	double aspect;
	bool reverse_z;
	/* left, right, bottom and top where they meet the near plane: x or y of
	 * view space */
	double plane[4];
	/* Rows of K: what makes pixels from the viewport's corner of a point X right, Y as
	 * device y increases, Z along the gaze; nan in a parallel projection. */
	double intrinsics[3][3];
	/* a b c d in world space for left, right, bottom, top, near and far: inside
	 * is where a x + b y + c z + d >= 0; a b c is a unit vector */
	double frustum_plane[6][4];
	unsigned notes; /* a bit for each enum note */
	/* By eye and gaze, and by edges, or where x depends on y or there are no
	 * planes by intrinsics; in the convention of the answer. */
	bool has_scene;
	struct scene scene;
};

/* Returns NULL, or the member and the reason. */
const char *parameters_of(const struct scene *, const struct taxonomy *,
    struct parameters *);

#endif
