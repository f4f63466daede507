/* SPDX-License-Identifier: MIT */
/* Affine maps that are given as one matrix or as a list of steps, such as a translation
 * and a rotation, which are applied to the point one after the other. The list belongs to
 * the caller. The product is computed from the numbers of the steps, not from matrices
 * of doubles, so that it is exact unless a step has an angle that makes it irrational. */
#pragma once

#include "../exact/map.h"
#include "../exact/trig.h"

struct step {
	/* in the order of step_members (cmd/scene) */
	enum {
		STEP_TRANSLATE,
		STEP_SCALE,
		STEP_ROTATE_X,
		STEP_ROTATE_Y,
		STEP_ROTATE_Z,
		STEP_ROTATE,          /* by `angle` about the axis `rotation` */
		STEP_QUATERNION,      /* rotation: x y z w, of any norm */
		STEP_QUATERNION_WXYZ, /* rotation: w x y z, of any norm */
		STEP_RVEC,            /* rotation: an axis times radians */
		STEP_MATRIX,
		STEP_NODE, /* scale, then the quaternion, then translation */
		STEP_INVERSE,
	} kind;
	/* STEP_INVERSE: how many of the steps behind it it inverts as a whole; those
	 * inside of other inverses count, too. Other steps have 0. */
	int inner;
	double translation[3], rotation[4], scale[3], angle;
	double matrix[4][4]; /* for row vectors */
};

enum { STEPS_MAX = 64 };

struct steps {
	const struct step *step; /* NULL: `matrix` is given instead */
	int n;                   /* counts the steps inside of inverses, too */
	enum angle_unit unit;
	double matrix[4][4]; /* for row vectors */
};

/* Computes the map of the steps or of the matrix; if inverse, its inverse, which is the
 * product of the inverse of each step in the opposite order. The origin of the map is 0
 * or, for the inverse of one matrix, its last row. If `regular`, a singular matrix is
 * refused in both directions. Returns NULL, or `pointer`, which leads to the member, with
 * the place of the step at fault, and why. The thread's next call overwrites this text. */
const char *steps_map(const struct steps *, const char *pointer, bool inverse,
    bool regular, struct map *);

#define STEPS_TOO_WIDE                                                        \
	"the numbers of its steps have too many digits to be multiplied "     \
	"without a loss; give fewer steps, or numbers nearer to one another " \
	"or of fewer digits"
