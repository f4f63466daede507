/* SPDX-License-Identifier: MIT */
/* Measures the errors of the ways to compute the images of a regime. */
#pragma once

#include "cases.h"

/* The worst errors of a way over the points of a scene. sign: a point in front
 * of the eye is taken to be behind it, or vice versa, or the image is mirrored.
 */
struct cell {
	double units; /* of the device, or of the world if regime.back */
	double ulps;  /* units in the last place of a double */
	bool nan, sign;
};

struct row {
	struct cell cell[WAYS];
	bool refused; /* the program refuses the scene, rightly */
	/* How many numbers of exact are not the nearest double, or nan in place
	 * of a number, or a number in place of nan. */
	int wrong;
	/* How many numbers of exact are only nearest to a number within
	 * TRUTH_TOLERANCE of the truth. */
	int ruled;
	/* The share of the points that a loop of core/points/kernel cannot
	 * round with certainty. */
	double accurate;
};

/* Compares the ways with the truth, on the same points in every run. */
void ways_compare(const struct regime *, double severity, struct row *);
