/* SPDX-License-Identifier: MIT */
/* Bounds to which a scene is fitted, their hull, and its extents,
 * which fit.c measures. */
#pragma once

#include "../scene/scene.h"

enum { BOUNDS_POINTS = 12 }; /* the most directions of fit_directions */

/* The bounds to fit to: a sphere, a box from min to max or, if n is not 0, n points:
 * those farthest along the directions of fit_directions or fit_window_directions. All
 * numbers are in model space; the world matrix may make the sphere an ellipsoid. A 2D
 * window has no third coordinate, and the sphere is a circle. */
struct bounds {
	double center[3], radius;
	unsigned sphere; /* 1: a sphere, 0: a box or points */
	double min[3], max[3];
	int n;
	double point[BOUNDS_POINTS][3];
};

/* The convex hull of n points, widened on all sides by a radius, which may be 0. */
struct hull {
	int n;
	double point[BOUNDS_POINTS][3], radius;
};

/* Makes the hull of bounds with two or three coordinates. Refuses a max that is less
 * than min along an axis. */
bool hull_of(const struct bounds *, int dimensions, struct hull *,
    struct refusals *faults);

/* Returns the least value that coordinate j of a map's images takes on the hull or, if
 * `minus` is set, the least value of the negated coordinate. */
struct sum hull_lowest(const struct hull *, const struct map *, int j, bool minus);

/* The least and greatest coordinate of a hull along each axis, and their difference. */
struct extents {
	struct sum low[3], high[3], size[3];
};

/* Sets element j of extents to the range of coordinate j of the hull's images. */
void extents_set(struct extents *, int j, const struct hull *, const struct map *);

/* Widens each of the first n extents whose size is 0: moves `low` and `high` apart by
 * 2^-20 of the largest extent; `size` stays 0. Refuses bounds of which all are 0. */
bool extents_widen(struct extents *, int n, struct refusals *faults);

/* Makes the maps from model space by whose images fit measures bounds. Columns 0 and 1
 * of `xy` are x and y: for persp and volume those of view space, for ortho and oblique
 * those of clip space with y upward and with width and height 2, which the caller has
 * set. Column 2 of `depth` is the distance along the gaze or, for persp, w. */
bool fit_maps(const struct scene *, struct map *xy, struct map *depth,
    struct refusals *faults);

/* Finds the extents of a hull in x, y and depth of fit_maps, and widens those of 0. */
bool hull_extents(const struct hull *, const struct scene *, struct extents *,
    struct refusals *faults);

/* Returns the OUT_ bits of the planes of the view volume that a part of the hull is
 * outside of, or all bits if the scene has no volume. */
unsigned hull_outside(const struct hull *, const struct scene *);
