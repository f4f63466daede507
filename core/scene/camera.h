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
		CAMERA_AT,                   /* eye, at and up */
		CAMERA_GAZE,                 /* eye, gaze and up */
		CAMERA_ORIENTATION,          /* eye and orientation */
		CAMERA_RVEC,                 /* eye and rvec */
		CAMERA_TRANSLATION,          /* translation and orientation */
		CAMERA_RVEC_TRANSLATION,     /* translation and rvec */
		CAMERA_ROTATION,             /* eye and rotation */
		CAMERA_ROTATION_TRANSLATION, /* translation and rotation */
		CAMERA_POSE,
		CAMERA_MATRIX,
	} way;
	double at[3]; /* or the gaze, a direction of any length */
	double up[3];
	bool has_default_up;   /* the document gives none */
	double orientation[4]; /* quaternion x y z w, any norm; view to world */
	double rvec[3];        /* rotation from world to view: axis times radians */
	double rotation[3][3]; /* from world to view, for column vectors */
	/* Where x, y and z of the camera's own frame point, to which the members lead
	 * in place of view space, and which a pose or an orientation leaves. Without
	 * axes the frame is view space. */
	bool has_axes;
	enum camera_axis {
		AXIS_BACK = -3,
		AXIS_DOWN,
		AXIS_LEFT,
		AXIS_RIGHT = 1,
		AXIS_UP,
		AXIS_FORWARD,
	} axes[3];
	double roll;          /* the angle that turns the image counterclockwise */
	enum angle_unit unit; /* of roll */
	/* from world to view space or, with CAMERA_POSE, from view to world space */
	struct steps steps;
	bool orthonormalize; /* replace the 3x3 part by its nearest rotation */
};

/* Returns whether the camera is given by a direction of the gaze and up. */
static inline bool camera_is_by_gaze(const struct camera *c)
{
	return c->way == CAMERA_AT || c->way == CAMERA_GAZE;
}

/* Returns whether the camera is given as a whole, by a matrix or steps. */
static inline bool camera_is_by_steps(const struct camera *c)
{
	return c->way == CAMERA_POSE || c->way == CAMERA_MATRIX;
}

/* Returns whether the camera's 3x3 part is given, which need not be a rotation. */
static inline bool camera_gives_3x3(const struct camera *c)
{
	return camera_is_by_steps(c) || c->way == CAMERA_ROTATION ||
	    c->way == CAMERA_ROTATION_TRANSLATION;
}

/* Returns whether the eye is given, not the world's origin in view space. */
static inline bool camera_has_eye(const struct camera *c)
{
	return camera_is_by_gaze(c) || c->way == CAMERA_ORIENTATION ||
	    c->way == CAMERA_RVEC || c->way == CAMERA_ROTATION;
}

/* Returns whether the axes are of the other handedness than view space. If a camera of
 * a right-handed world, say, has them, the world is left-handed. */
bool camera_mirrors(const struct camera *, const struct convention *);

/* Computes the map from world to view space, or its inverse, as projcalc-numbers(7),
 * FORMULAS, lookat says. Each element is exact or has a bound of its error, even if up
 * is nearly parallel to the gaze or a matrix nearly singular. If a matrix is
 * orthonormalized, an element of the rotation whose magnitude is at most its error
 * becomes 0. A roll turns view space about the eye, also if a translation is given. The
 * origin of the map to view space is the eye or, if it is not given and a matrix is not
 * orthonormalized, 0. */
bool camera_map(const struct camera *, const struct convention *, bool inverse,
    struct map *, struct refusals *faults);

/* Refuses what camera_map would refuse, where the numbers that a check compares are
 * known: those that a document lacks or that were refused are NaN. */
bool camera_check(const struct camera *, const struct convention *, bool inverse,
    struct refusals *faults);

/* Returns the pointer to the member that gives the camera's 3x3 part. */
const char *camera_3x3_pointer(const struct camera *);
