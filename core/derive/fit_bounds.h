/* SPDX-License-Identifier: MIT */
/* The bounds that fit closes a scene on, and their extents. */
#ifndef FIT_BOUNDS_H
#define FIT_BOUNDS_H

#include "../scene/scene.h"

enum { BOUNDS_POINTS = 10 };

/* A sphere, a box or, if n is not 0, the farthest of many points along the directions of
 * fit_directions. All is in model space; the world matrix makes an ellipsoid of a sphere.
 * Bounds of a 2D window have no third coordinate, and their sphere is a circle. */
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

/* Makes the hull of bounds of two or three coordinates. Returns NULL, or the coordinate
 * that is less in max than in min, and the reason. */
const char *hull_of(const struct bounds *, int dimensions, struct hull *);

/* The support function: returns the least value of column j of a map, or of its
 * negative. */
struct sum hull_lowest(const struct hull *, const struct map *, int j,
    bool minus);

/* The least and greatest coordinate of a hull along each axis, and their difference. */
struct extents {
	struct sum low[3], high[3], size[3];
};

/* Sets the extent along axis j to that of column j of a map, or of its negative. */
void extents_of(struct extents *, int j, const struct hull *,
    const struct map *, bool minus);

struct sum extents_middle(const struct extents *, int j);

/* Widens zero extents of n axes to 2^-20 of the largest. Returns NULL, or the reason if all
 * are 0. */
const char *extents_widen(struct extents *, int n);

/* Finds the extents of x, y and depth, widened. Depth is measured along the gaze; in a
 * perspective it is w. x and y are those of view space in a perspective or a volume, and of
 * clip space, with y upward, in ortho and oblique, whose width and height must be 2.
 * Returns NULL, or the member and the reason. */
const char *hull_extents(const struct hull *, const struct scene *,
    struct extents *);

/* Returns the planes of the view volume that part of the hull is outside of, in the bits of
 * frustum_out; all of them if the scene has no volume. */
unsigned hull_out(const struct hull *, const struct scene *);

/* Moves *v, a number of the scene that some planes depend on, outward until the hull is
 * inside of those planes. *v must be the double nearest to the value at which they touch
 * the hull: so it moves by one ulp at most, unless the hull is known less exactly. Stops
 * beyond MAGNITUDE_MAX. */
void hull_close(const struct hull *, const struct scene *, double *v,
    double outward, unsigned planes);

/* Sets near to the greatest and far to the least double for which the hull is between the
 * planes. near < far must hold before the call. */
void hull_close_depth(const struct hull *, struct scene *);

#endif
