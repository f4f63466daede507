/* SPDX-License-Identifier: MIT */
/* A camera as a rotation and a place, in each of the ways in which a document may give
 * them. */
#pragma once

#include "upright.h"

/* Each member is as the member of a camera of its name reads in the answer's
 * convention. Each number is the double nearest to the exact one, but with these
 * bounds: sums have the errors of their parts (core/exact/sum.h); an element of a
 * rotation nearest to a matrix is within ROTATION_BOUND, and so are the numbers that
 * come from it, but rvec, whose angle adds a relative 2^-245 (trig_angle). */
struct rigid {
	bool exists; /* false: the camera scales or mirrors */
	double eye[3];
	double
	    orientation[4]; /* a unit quaternion x y z w, as of rotation_quaternion */
	double rvec[3]; /* of at most pi; at pi its first number not 0 is positive */
	double translation[3], rotation[3][3];
};

/* Describes the camera of a scene: its nearest rotation with the translation of a
 * matrix, or the eye of a pose, as `orthonormalize` makes it; the camera that
 * upright_of finds in a projection's matrix or intrinsics without a camera; or the
 * identity. */
void rigid_of(const struct lens *, const struct upright *, struct rigid *);
