/* SPDX-License-Identifier: MIT */
/* Affine maps that are given as one matrix or as a list of steps, such as a translation
 * and a rotation, which are applied to the point one after the other. The list
 * belongs to the caller. The product is computed from the numbers of the steps, not
 * from matrices of doubles, so that it is exact unless a step has an angle that
 * makes it irrational. */
#pragma once

#include "../exact/map.h"
#include "../exact/trig.h"
#include "../refusal/refusal.h"

struct step {
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
	bool is_wrong;       /* it was refused: it is nothing */
};

enum { STEPS_MAX = 64 };

/* Returns whether a step rotates about an axis of the coordinates, by its angle. */
static inline bool step_is_about_axis(const struct step *s)
{
	return s->kind == STEP_ROTATE_X || s->kind == STEP_ROTATE_Y ||
	    s->kind == STEP_ROTATE_Z;
}

struct steps {
	const struct step *step; /* NULL: `matrix` is given instead */
	int n;                   /* counts the steps inside of inverses, too */
	enum angle_unit unit;
	double matrix[4][4]; /* for row vectors */
	bool is_wrong;       /* the matrix, or what is no list, was refused */
};

/* Computes the map of the steps or of the matrix; if inverse, its inverse, which is the
 * product of the inverse of each step in the opposite order. The origin of the map is 0
 * or, for the inverse of one matrix, its last row. If `regular`, a singular matrix is
 * refused in both directions. `pointer` leads to the member; a refusal adds to it where
 * the step at fault is. All steps at fault are refused; of those that are wrong already
 * only false is returned. */
bool steps_map(const struct steps *, const char *pointer, bool inverse, bool regular,
    struct map *, struct refusals *faults);

/* Says why a matrix that must be affine is refused. */
#define STEPS_NOT_AFFINE                                                     \
	"its last column, as column vectors its last row, is not exactly 0 " \
	"0 0 1"
#define STEPS_NOT_AFFINE_REMEDY                                            \
	"of 16 numbers the translation is 13, 14 and 15; write rows "      \
	"of column vectors as {\"matrix\": [[...], [...], [...], [...]], " \
	"\"vectors\": \"column\"}"

/* Says why a product of steps that has lost digits is refused. */
#define STEPS_TOO_WIDE                                                    \
	"the numbers of its steps have too many digits to be multiplied " \
	"without a loss"
#define STEPS_TOO_WIDE_REMEDY \
	"give fewer steps, or numbers nearer to one another or of fewer digits"
