/* SPDX-License-Identifier: MIT */
/* Bounds and where they lie: what fit fits a scene to. */
#ifndef FIT_BOUNDS_H
#define FIT_BOUNDS_H

#include "../scene/scene.h"

enum { BOUNDS_POINTS = 10 };

/* A sphere, a box, or where n is not 0 the points among many that lie farthest in the
 * directions that count. In model space; the world matrix
 * makes an ellipsoid of a sphere. A window's have no third coordinate, and the sphere
 * is a circle. */
struct bounds {
	double center[3], radius;
	unsigned sphere; /* 1: a sphere, 0: a box or points */
	double min[3], max[3];
	int n;
	double point[BOUNDS_POINTS][3];
};

/* What is within a radius of the convex hull of some points. */
struct hull {
	int n;
	double point[BOUNDS_POINTS][3], radius;
};

/* Makes the hull of bounds of two or three coordinates. Returns NULL, or the coordinate
 * that is less in max than in min, and the reason. */
const char *hull_of(const struct bounds *, int dimensions, struct hull *);

/* The support function: the least value of column j of a map, or of minus that. */
struct sum hull_lowest(const struct hull *, const struct map *, int j,
    bool minus);

/* How far a hull reaches along each axis. */
struct extents {
	struct sum low[3], high[3], size[3];
};

/* The extent along axis j is that of column j of a map, or of minus that. */
void extents_of(struct extents *, int j, const struct hull *,
    const struct map *, bool minus);

struct sum extents_middle(const struct extents *, int j);

/* Widens extents along n axes that are none to 2^-20 of the largest. Returns NULL, or
 * why there is no extent at all. */
const char *extents_widen(struct extents *, int n);

/* x, y and depth as seen from the eye, widened: depth along the gaze, in a perspective
 * w; x and y of a perspective or a volume in view space, of another parallel projection
 * in clip space, where it is taken to be 2 wide and high, y upward. Returns NULL, or the
 * member and the reason. */
const char *hull_extents(const struct hull *, const struct scene *,
    struct extents *);

/* The planes of the view volume that some of the hull is outside of, as frustum_out has
 * them; all where the scene has none. */
unsigned hull_out(const struct hull *, const struct scene *);

/* Moves *v, a number of the scene that some planes depend on, outward until the
 * hull is inside of those planes. It starts at the double nearest to where
 * it closes on the hull, so that at most one unit in the last place is
 * missing, unless the hull is known to less than that. Stops beyond
 * MAGNITUDE_MAX. */
void hull_close(const struct hull *, const struct scene *, double *v,
    double outward, unsigned planes);

/* Sets near to the greatest and far to the least double that hold the hull.
 * Before the call near and far must be valid: near less than far. */
void hull_close_depth(const struct hull *, struct scene *);

#endif
