/* SPDX-License-Identifier: MIT */
/* The farthest of many points along the directions that fit needs. */
#ifndef FIT_POINTS_H
#define FIT_POINTS_H

#include "fit_bounds.h"

/* A direction in model space: the vector m. hi is m divided by its element of largest
 * magnitude, and rounded; so no sum of products of hi with coordinates overflows. An
 * element of hi is 0 if and only if the element of m is 0. */
struct direction {
	struct sum m[3];
	double hi[3];
};

struct directions {
	int n;
	struct direction of[BOUNDS_POINTS];
	double hi[BOUNDS_POINTS][3]; /* copies of of[].hi for the kernels */
};

/* Adds the direction in which column j of the map grows or, if minus, falls. */
void directions_add(struct directions *, const struct map *, int j, bool minus);

/* The farthest point along a direction. value is its distance along hi, with an error of
 * at most bound. any is false before the first point. */
struct farthest {
	bool any;
	double point[3], value, bound;
};

/* The farthest point along each direction. All bytes are 0 before the first point. */
struct extremes {
	struct farthest of[BOUNDS_POINTS];
};

/* Adds n points; in has a column for each coordinate. A point with a nan is left out.
 * The caller pads each column to a multiple of 16 numbers with coordinates of these
 * points. */
void extremes_add(struct extremes *, const struct directions *,
    const double *const in[3], size_t n);

/* Adds the points of other extremes along the same directions. The result depends on
 * what points there are, but not on their order. */
void extremes_merge(struct extremes *, const struct directions *,
    const struct extremes *);

/* Makes bounds of the farthest points. Returns false if no point was added. */
bool extremes_bounds(const struct extremes *, const struct directions *,
    struct bounds *);

#endif
