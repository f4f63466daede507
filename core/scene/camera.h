/* SPDX-License-Identifier: MIT */
/* Cameras, which map world to view space. */
#pragma once

#include "../exact/trig.h"
#include "../projection/convention.h"
#include "../refusal/refusal.h"
#include "steps.h"

struct camera {
	double eye[3]; /* or translation: the world's origin in view space */
	/* the members that give the camera */
	enum camera_way {
		CAMERA_AT,               /* eye, at and up */
		CAMERA_GAZE,             /* eye, gaze and up */
		CAMERA_ORIENTATION,      /* eye and orientation */
		CAMERA_RVEC,             /* eye and rvec */
		CAMERA_TRANSLATION,      /* translation and orientation */
		CAMERA_RVEC_TRANSLATION, /* translation and rvec */
		CAMERA_POSE,
		CAMERA_MATRIX,
	} way;
	double at[3]; /* or the gaze, a direction of any length */
	double up[3];
	double orientation[4]; /* quaternion x y z w, any norm; view to world */
	double rvec[3];        /* rotation from world to view: axis times radians */
	double roll;           /* the angle that turns the image counterclockwise */
	enum angle_unit unit;  /* of roll */
	/* from world to view space or, with CAMERA_POSE, from view to world space */
	struct steps steps;
	bool orthonormalize; /* replace the matrix by its nearest rotation */
};

/* Computes the map from world to view space, or its inverse, as projcalc(1), FORMULAS,
 * lookat says. Each element is exact or has a bound of its error, even if up is nearly
 * parallel to the gaze or a matrix nearly singular. If a matrix is orthonormalized, an
 * element of the rotation whose magnitude is at most its error becomes 0. A roll turns
 * view space about the eye, also if a translation is given. The origin of the map to
 * view space is the eye or, for a CAMERA_MATRIX that is not orthonormalized, 0. */
bool camera_map(const struct camera *, const struct convention *, bool inverse,
    struct map *, struct refusals *faults);

/* Returns the pointer to the member that the camera's steps are given by. */
const char *camera_steps_pointer(const struct camera *);
