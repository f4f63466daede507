/* SPDX-License-Identifier: MIT */
/* The classical methods, for comparison in tests: matrices as GLM, cglm and
 * textbooks write them, for gl's conventions. */
#ifndef NAIVE_H
#define NAIVE_H

#include "../scene/scene.h"

/* Ways to compute an image: the textbook's, then the program's. */
enum way {
	SINGLE,   /* the matrices multiplied together, in float */
	COMPOSED, /* the same in double */
	STAGED,   /* double, a matrix after the other */
	RELATIVE, /* double, the eye or the window's centre taken off first */
	LU,       /* COMPOSED; the way back by LU, not by the adjugate */
	OUR_SINGLE,
	OUR_DOUBLE,
	EXACT,
	WAYS
};

/* A camera that rolls has been turned by so much at a time, by a small
 * rotation each: a drift that is under test. */
#define TURN (23.0 / 64)

/* World to device, or back; with a window, from there to a device of the
 * viewport's size. Images are x y z and the w that they were divided by. */
void naive_carry(const struct scene *, enum way, bool back, double (*in)[3],
    double (*out)[4], size_t n);

#endif
