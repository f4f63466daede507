/* SPDX-License-Identifier: MIT */
/* The differences between the conventions of graphics systems; and cameras, the maps
 * from world to view. */
#ifndef CAMERA_H
#define CAMERA_H

#include <stdbool.h>

#include "../exact/map.h"
#include "../exact/trig.h"

/* The convention d3d has all members false. */
struct convention {
	bool right_handed;
	bool minus_one; /* ndc depth is from -1, not 0, to 1 */
	bool column;    /* matrices are printed transposed: p' = M p */
	bool ndc_y_down;
	bool bottom_left; /* the device's origin */
	bool view_y_down; /* y and z of view space are negated */
};

/* Returns whether the camera looks along -z. */
static inline bool looks_back(const struct convention *c)
{
	return c->right_handed != c->view_y_down;
}

/* Changes the convention of one side of a map: of its points if rows, else of its
 * images. This side is in clip space if clip, else in view space. y, and in view space
 * z, may change their signs. The depth z from 0 to w of clip space becomes 2 z - w from
 * -w to w, and back (z + w) / 2. */
void convention_change(const struct convention *from,
    const struct convention *to, bool clip, bool rows, struct map *);

struct camera {
	double
	    eye[3]; /* or the translation, the world's origin in view space */
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
	double orientation[4]; /* x y z w, view to world axes, of any norm */
	double
	    rvec[3]; /* the rotation from world to view: axis times radians */
	double roll; /* of the image, counterclockwise */
	enum angle_unit unit; /* of roll */
	/* The affine matrix from world to view space, for row vectors; or the pose,
	 * the matrix from view to world space. */
	double matrix[4][4];
	bool orthonormalize;
};

/* Computes the matrix of projcalc(1), FORMULAS, lookat, or its inverse. The elements
 * are exact, or have a bound of their error, however near up is to the gaze, or the eye
 * to the point at which it looks, and however far a matrix is from its nearest
 * rotation. Elements of a nearest rotation below 2^-252 become 0. A roll turns the
 * axes, and a translation with them, about the eye. The origin of the map is the eye.
 * Returns NULL, or the member and the reason why there is no such view. */
const char *camera_map(const struct camera *, const struct convention *,
    bool inverse, struct map *);

#endif
