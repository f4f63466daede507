/* SPDX-License-Identifier: MIT */
/* Parameters of a scene's picture: its planes, and a camera and a projection that make
 * the same picture. */
#ifndef PARAMETERS_H
#define PARAMETERS_H

#include "depth.h"
#include "taxonomy.h"

/* Faults of a scene, and reasons why no scene in parameters makes its picture. */
enum note {
	NOTE_MIRRORED,    /* the picture is a mirror image */
	NOTE_HANDED,      /* the projection has the other handedness */
	NOTE_AWAY,        /* the projection looks against the camera's gaze */
	NOTE_TRANSPOSED,  /* the projection's matrix looks transposed */
	NOTE_NEAR_BEYOND, /* near is farther than far */
	NOTE_BACKWARD,    /* depth falls along the convention's gaze */
	/* with one of the notes below has_scene is false */
	NOTE_NO_ROTATION, /* the camera's matrix is not a rotation */
	NOTE_TILTED,      /* near and far are not parallel to the picture */
	NOTE_BEHIND,      /* w is negative from near to far */
	NOTE_SKEWED,      /* only intrinsics could say that x depends on y */
	NOTE_RANGE,       /* a plane is behind the eye, a number out of range */
	NOTES,
};

/* Nearest doubles; nan where a number does not exist. */
struct parameters {
	/* Distances from the eye or, in a parallel projection, from the origin of
	 * view space along the convention's gaze. far may be infinite. */
	double near, far;
	struct depth depth;
	double aspect;
	bool reverse_z;
	/* x or y of view space where left, right, bottom and top meet the near
	 * plane */
	double plane[4];
	/* Rows of K. K maps X to the right, Y in the direction of device y and Z along the
	 * gaze to pixels from the viewport's corner. nan in a parallel projection. */
	double intrinsics[3][3];
	/* a b c d in world space for left, right, bottom, top, near and far: inside
	 * is where a x + b y + c z + d >= 0; a b c is a unit vector */
	double frustum_plane[6][4];
	unsigned notes; /* a bit for each enum note */
	/* A scene that makes the same picture: a camera by eye and gaze, and a projection
	 * by edges or, if x depends on y or there are no planes, by intrinsics. The
	 * convention is the answer's. */
	bool has_scene;
	struct scene scene;
};

/* Finds the parameters of a scene and its taxonomy. Returns NULL, or the member and the
 * reason. */
const char *parameters_of(const struct scene *, const struct taxonomy *,
    struct parameters *);

#endif
