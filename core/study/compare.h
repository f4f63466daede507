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
	/* The worst that exact is wrong by beyond half a unit in the last
	 * place, in units of kappa 2^-47: at most 1. */
	double promise;
	/* How often it is more, nan or a number where the truth is the other,
	 * not 0 where that is 0, or refused. */
	int wrong;
};

/* Compares the ways with the truth, on the same points in every run. */
void ways_compare(const struct regime *, double severity, struct row *);

#endif
