/* SPDX-License-Identifier: MIT */
/* Classical methods, to compare with in tests: matrices as GLM, cglm and
 * textbooks make them, in the convention gl. */
#pragma once

#include "../scene/scene.h"

/* Ways to compute an image: the textbook's, then the program's. */
enum way {
	SINGLE,   /* the matrices multiplied together, in float */
	COMPOSED, /* the same in double */
	STAGED,   /* double, one matrix after the other */
	RELATIVE, /* double, the eye or window centre subtracted first */
	LU,       /* COMPOSED, but inverted by LU, not by the adjugate */
	OUR_SINGLE,
	OUR_DOUBLE,
	EXACT,
	WAYS
};

/* The classical methods turn a camera with a roll in steps of this many
 * degrees, whose errors add up. */
#define TURN (23.0 / 64)

/* Maps points from the world, or a 2D window, to the device, or back. An image
 * is x, y and z, and the w by which they were divided. */
void naive_carry(const struct scene *, enum way, bool back, double (*in)[3],
    double (*out)[4], size_t n);
