/* Bounds and where they lie: what fit fits a scene to. */
#ifndef BOUNDS_H
#define BOUNDS_H

#include "scene.h"

/* In model space; the world matrix makes an ellipsoid of a sphere. */
struct bounds {
	bool sphere;
	double center[3], radius;
	double min[3], max[3]; /* of a box */
};

/* The exact value is within error. */
struct estimate {
	dd value;
	double error;
};

/* Of a sum of products with a map's elements, relative to the products. */
#define SUM_BOUND ((MAP_BOUND + 13) * 0x1p-106)

/* Rounds, and makes 0 of what is no larger than its error. */
struct estimate estimate_of(ex value, double error);

/* The support function: the least of sign times column j of a map over the
 * bounds. Exact but for the map's elements, also for a sphere. */
struct estimate bounds_lowest(const struct bounds *, const struct map *, int j,
    double sign);

/* From the eye: x and y as a parallel projection that is 2 wide and high has
 * them in clip space, y upward, or as view space has them; and depth along the
 * gaze. A range of no width is widened to 2^-20 of the largest. Returns NULL,
 * or the member and the reason. */
struct extents {
	struct estimate low[3], high[3];
};

const char *bounds_extents(const struct bounds *, const struct scene *,
    struct extents *);

struct estimate extents_middle(const struct extents *, int j);

/* In the world. */
const char *bounds_center(const struct bounds *, const struct scene *,
    double center[3]);

/* The planes of the view volume that some of the bounds is outside of: some
 * corner as frustum_out says, or some point of a sphere. */
const char *bounds_out(const struct bounds *, const struct scene *,
    unsigned *out);

/* Moves *v, a number of the scene's, outward from the double nearest to where
 * it closes on the bounds, which can be on the wrong side, until they are
 * inside of its planes: by one unit in the last place, but where the bounds are
 * known to less than that. Stops beyond 1e150. */
const char *bounds_close(const struct bounds *, const struct scene *, double *v,
    double outward, unsigned planes);

/* Sets near and far to the greatest and the least double that hold the bounds;
 * they are some doubles of which near is less before. */
const char *bounds_close_depth(const struct bounds *, struct scene *);

#endif
