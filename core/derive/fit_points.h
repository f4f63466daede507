/* SPDX-License-Identifier: MIT */
/* The few points among millions that decide a fit: the farthest along each direction.
 * Each thread collects a struct extremes; these are then merged to bounds. */
#pragma once

#include "fit_bounds.h"

/* Directions in model space. scaled[i] is exact[i] divided by its element of largest
 * magnitude, rounded, so that no sum of products of scaled[i] with coordinates
 * overflows. An element of `scaled` is 0 only where the element of `exact` is 0. */
struct directions {
	int n;
	struct sum exact[BOUNDS_POINTS][3];
	double scaled[BOUNDS_POINTS][3];
};

/* Adds the direction in which image coordinate j grows or, if `minus`, falls. */
void directions_add(struct directions *, const struct map *, int j, bool minus);

/* The farthest point along a direction, if `known`. `distance` is its dot product with
 * `scaled` of the direction, with an error of at most `error`. */
struct farthest_point {
	bool known;
	double point[3], distance, error;
};

/* The farthest point along each direction. All bytes are 0 before the first point. */
struct extremes {
	struct farthest_point item[BOUNDS_POINTS];
};

/* Adds n points, in columns, which the caller pads to multiples of 16 numbers with
 * numbers of these points. A point with a nan coordinate is ignored. */
void extremes_add(struct extremes *, const struct directions *,
    const double *const in[3], size_t n);

/* Adds the points of other extremes along the same directions. The result depends on
 * the set of points, but not on their order. */
void extremes_merge(struct extremes *, const struct directions *,
    const struct extremes *);

/* Makes bounds of the farthest points. Returns false if no point has been added. */
bool extremes_bounds(const struct extremes *, const struct directions *,
    struct bounds *);
