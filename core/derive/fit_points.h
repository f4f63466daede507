/* SPDX-License-Identifier: MIT */
/* The farthest of many points along the directions that fit needs. */
#ifndef FIT_POINTS_H
#define FIT_POINTS_H

#include "fit_bounds.h"

/* A direction in model space. hi is m over its largest element, rounded, so that no sum of
 * products with coordinates overflows. An element of hi is 0 if and only if that of m
 * is 0. */
struct direction {
	struct sum m[3];
	double hi[3];
};

struct directions {
	int n;
	struct direction of[BOUNDS_POINTS];
	double hi[BOUNDS_POINTS][3]; /* copies for the kernels */
};

/* Adds the direction in which column j of the map, or minus that, grows. */
void directions_add(struct directions *, const struct map *, int j, bool minus);

/* The farthest point, and its distance along the direction with an error of at most
 * bound. */
struct farthest {
	bool any;
	double point[3], value, bound;
};

/* One for each direction; all 0 before the first point. */
struct extremes {
	struct farthest of[BOUNDS_POINTS];
};

/* Adds n points, a column for each coordinate, without those that have a nan. A column is
 * padded to the next multiple of 16 with numbers of any of the points. */
void extremes_add(struct extremes *, const struct directions *,
    const double *const in[3], size_t n);

/* Adds the points of other extremes along the same directions. The result depends on
 * what points there are, but not on their order. */
void extremes_merge(struct extremes *, const struct directions *,
    const struct extremes *);

/* Makes bounds of the points. Returns false where there are none. */
bool extremes_bounds(const struct extremes *, const struct directions *,
    struct bounds *);

#endif
