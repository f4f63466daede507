/* SPDX-License-Identifier: MIT */
/* The camera: world to view and back. */
#ifndef CAMERA_H
#define CAMERA_H

#include "convention.h"
#include "../exact/map.h"
#include "../exact/trig.h"

struct camera {
	double eye[3]; /* or the translation: the world's origin in view */
	enum {
		CAMERA_AT,
		CAMERA_GAZE,
		CAMERA_ORIENTATION,      /* and eye */
		CAMERA_RVEC,             /* and eye */
		CAMERA_TRANSLATION,      /* and orientation */
		CAMERA_RVEC_TRANSLATION, /* and rvec */
		CAMERA_POSE,
		CAMERA_MATRIX,
	} kind;
	double at[3]; /* or the gaze, a direction of any length */
	double up[3];
	double orientation[4]; /* x y z w, view axes to world axes, any norm */
	double rvec[3]; /* world to view: about it, by its length in radians */
	double roll;    /* image counterclockwise */
	enum angle_unit unit; /* of roll */
	/* World to view, row vectors, affine; or the pose, view to world. */
	double matrix[4][4];
	bool orthonormalize;
};

/* Left-handed: z = unit(gaze), x = unit(up x z), y = z x x; right-handed: z
 * = unit(-gaze); then roll; where y is down in view space y and z are negated. Every element is the exact value for the given
 * doubles rounded once, within EX_BOUND u^2 of its sum, however near up is to
 * the gaze, the eye to what it looks at, and however far a matrix has drifted
 * from its nearest rotation (of which elements below 2^-248 are 0). Roll turns
 * about the eye, and a translation with the axes. The eye is the map's origin.
 * Returns NULL, or why there is no such view: the
 * member and the reason. */
const char *camera_map(const struct camera *, const struct convention *,
    bool inverse, struct map *);

#endif
