/* SPDX-License-Identifier: MIT */
/* How wrong the ways to compute a regime are. */
#ifndef WAYS_H
#define WAYS_H

#include "cases.h"

/* The worst over the points of a cell. sign: a point that ought to be seen
 * is taken to be behind the eye, or the other way round, or the image is
 * mirrored. */
struct cell {
	double units; /* of the device, or of the world where it leads back */
	double ulps;  /* units in the last place of a double */
	bool nan, sign;
};

struct row {
	struct cell cell[WAYS];
	bool refused; /* no image is right, and the program says so */
	/* How often exact is not the nearest double, nan or a number where the
	 * truth is the other. */
	int wrong;
	/* How often it is that only within the rule. */
	int ruled;
	/* The share of the points that its fast phase leaves undecided. */
	double accurate;
};

/* Compares the ways with the truth, on the same points in every run. */
void ways_compare(const struct regime *, double severity, struct row *);

#endif
