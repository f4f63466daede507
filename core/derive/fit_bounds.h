/* SPDX-License-Identifier: MIT */
/* Bounds and where they lie: what fit fits a scene to. */
#ifndef FIT_BOUNDS_H
#define FIT_BOUNDS_H

#include "../scene/scene.h"

enum { BOUNDS_POINTS = 10 };

/* A sphere, a box, or where n is not 0 the points among many that lie farthest in the
 * directions that count, and the box about these. In model space; the world matrix
 * makes an ellipsoid of a sphere. A window's have no third coordinate, and the sphere
 * is a circle. */
struct bounds {
	double center[3], radius;
	unsigned sphere; /* 1: a sphere, 0: a box or points */
	double min[3], max[3];
	int n;
	double point[BOUNDS_POINTS][3];
};

#define BOUNDS_SINGLE "/bounds: a single point; what has an extent is wanted"
#define BOUNDS_BEYOND                                                       \
	"/bounds: what holds them has numbers beyond 1e150 or sizes below " \
	"1e-150; choose another unit"

/* NULL, or the coordinate that is less in max than in min, and the reason. */
const char *bounds_check(const struct bounds *, int dimensions);

/* The least double that times d, which is above 0, is not below n. */
double least_over(struct sum n, struct sum d);

/* Widens the side that is too short for a shape, across wide and up high, to the
 * nearest double. */
void sides_widen(double *width, double *height, double across, double up);

/* The support function: the least value of column j of a map, or of minus that, over
 * the bounds. */
struct sum bounds_lowest(const struct bounds *, const struct map *, int j,
    bool minus);

/* The ranges of x, y and depth of some bounds as seen from the eye: depth along
 * the gaze, in a perspective w; x and y of a perspective or a volume in view space, of
 * another parallel projection in clip space, where it is taken to be 2 wide and high, y
 * upward. */
struct extents {
	struct sum low[3], high[3];
};

/* A range of no width is widened to 2^-20 of the largest. Returns NULL, or the
 * member and the reason. */
const char *bounds_extents(const struct bounds *, const struct scene *,
    struct extents *);

struct sum extents_middle(const struct extents *, int j);

/* The middle of the bounds in the world, axis by axis. */
const char *bounds_center(const struct bounds *, const struct scene *,
    double center[3]);

/* The planes of the view volume that some of the bounds is outside of: some
 * corner or point as frustum_out says, or some point of a sphere. */
const char *bounds_out(const struct bounds *, const struct scene *,
    unsigned *out);

/* Moves *v, a number of the scene that some planes depend on, outward until the
 * bounds are inside of those planes. It starts at the double nearest to where
 * it closes on the bounds, so that at most one unit in the last place is
 * missing, unless the bounds are known to less than that. Stops beyond
 * MAGNITUDE_MAX. */
const char *bounds_close(const struct bounds *, const struct scene *, double *v,
    double outward, unsigned planes);

/* Sets near to the greatest and far to the least double that hold the bounds.
 * Before the call near and far must be valid: near less than far. */
const char *bounds_close_depth(const struct bounds *, struct scene *);

#endif
