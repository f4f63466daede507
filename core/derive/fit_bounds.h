/* SPDX-License-Identifier: MIT */
/* The bounds that fit closes a scene on, and their extents. */
#ifndef FIT_BOUNDS_H
#define FIT_BOUNDS_H

#include "../scene/scene.h"

enum { BOUNDS_POINTS = 10 };

/* A sphere, a box or, if n is not 0, the farthest of many points along the directions of
 * fit_directions. All numbers are in model space; the world matrix turns the sphere into
 * an ellipsoid. Bounds of a 2D window have no third coordinate, and their sphere is a
 * circle. */
struct bounds {
	double center[3], radius;
	unsigned sphere; /* 1: a sphere, 0: a box or points */
	double min[3], max[3];
	int n;
	double point[BOUNDS_POINTS][3];
};

/* The convex hull of some points, widened by a radius. */
struct hull {
	int n;
	double point[BOUNDS_POINTS][3], radius;
};

/* Makes the hull of bounds of two or three coordinates. Returns NULL or, if a coordinate
 * of max is less than that of min, the member and the reason. */
const char *hull_of(const struct bounds *, int dimensions, struct hull *);

/* Returns the least value of column j of a map, or of its negative if minus, on the hull
 * (its support function). */
struct sum hull_lowest(const struct hull *, const struct map *, int j,
    bool minus);

/* The least and greatest coordinate of a hull along each axis, and their difference. */
struct extents {
	struct sum low[3], high[3], size[3];
};

/* Sets the extent along axis j to the range of column j of a map, or of its negative if
 * minus, on the hull. */
void extents_of(struct extents *, int j, const struct hull *,
    const struct map *, bool minus);

struct sum extents_middle(const struct extents *, int j);

/* Widens each zero extent of the first n axes to 2^-20 of the largest extent. Returns
 * NULL, or the reason if all extents are 0. */
const char *extents_widen(struct extents *, int n);

/* Finds the extents of x, y and depth, and widens them. Depth is measured along the gaze;
 * in a perspective it is w. In a perspective or a volume x and y are in view space. In
 * ortho and oblique, whose width and height must be 2, they are in clip space, y upward.
 * Returns NULL, or the member and the reason. */
const char *hull_extents(const struct hull *, const struct scene *,
    struct extents *);

/* Returns the OUT_ bits of the planes of the view volume that a part of the hull is
 * outside of: all bits if the scene has no volume. */
unsigned hull_out(const struct hull *, const struct scene *);

/* Moves *v, a number of the scene on which some planes depend, outward until the hull is
 * inside these planes. Before the call *v must be the double nearest to the value at
 * which the planes touch the hull; so it moves by at most one ulp, unless the hull is
 * known less exactly. Stops beyond MAGNITUDE_MAX. */
void hull_close(const struct hull *, const struct scene *, double *v,
    double outward, unsigned planes);

/* Sets near to the greatest and far to the least double with the hull between both
 * planes. near < far must hold before the call. */
void hull_close_depth(const struct hull *, struct scene *);

#endif
