/* SPDX-License-Identifier: MIT */
/* Fits a scene to bounds, so that its picture holds them, as the command fit does. */
#ifndef FIT_H
#define FIT_H

#include "../scene/scene.h"

enum { BOUNDS_POINTS = 12 }; /* the most directions of fit_directions */

/* The bounds to fit to: a sphere, a box from min to max or, if n is not 0, n points:
 * those farthest along the directions of fit_directions or window_directions. All
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

/* Makes the hull of bounds with two or three coordinates. Returns NULL or, if max is
 * less than min along an axis, the member at fault and the reason. */
const char *hull_of(const struct bounds *, int dimensions, struct hull *);

/* Returns the least value that coordinate j of a map's images takes on the hull or, if
 * `minus` is set, the least value of the negated coordinate. */
struct sum hull_lowest(const struct hull *, const struct map *, int j,
    bool minus);

/* The least and greatest coordinate of a hull along each axis, and their difference. */
struct extents {
	struct sum low[3], high[3], size[3];
};

/* Sets element j of extents to the range of coordinate j of the hull's images. */
void extents_set(struct extents *, int j, const struct hull *,
    const struct map *);

/* Widens each of the first n extents whose size is 0: moves `low` and `high` apart by
 * 2^-20 of the largest extent; `size` stays 0. Returns NULL, or why if all are 0. */
const char *extents_widen(struct extents *, int n);

/* Makes the maps from model space by whose images fit measures bounds. Columns 0 and 1
 * of `xy` are x and y: for persp and volume those of view space, for ortho and oblique
 * those of clip space with y upward and with width and height 2, which the caller has
 * set. Column 2 of `depth` is the distance along the gaze or, for persp, w. Returns
 * NULL, or the member and the reason. */
const char *fit_maps(const struct scene *, struct map *xy, struct map *depth);

/* Finds the extents of a hull in x, y and depth of fit_maps, and widens zero extents.
 * Returns NULL, or the member at fault and why. */
const char *hull_extents(const struct hull *, const struct scene *,
    struct extents *);

/* Returns the OUT_ bits of the planes of the view volume that a part of the hull is
 * outside of, or all bits if the scene has no volume. */
unsigned hull_outside(const struct hull *, const struct scene *);

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
struct farthest {
	bool known;
	double point[3], distance, error;
};

/* The farthest point along each direction. All bytes are 0 before the first point. */
struct extremes {
	struct farthest item[BOUNDS_POINTS];
};

/* Adds n points; `in` has a column for each coordinate. A point with a nan coordinate
 * is ignored. The caller pads each column to a multiple of 16 numbers with numbers of
 * these points. */
void extremes_add(struct extremes *, const struct directions *,
    const double *const in[3], size_t n);

/* Adds the points of other extremes along the same directions. The result depends on
 * the set of points, but not on their order. */
void extremes_merge(struct extremes *, const struct directions *,
    const struct extremes *);

/* Makes bounds of the farthest points. Returns false if no point has been added. */
bool extremes_bounds(const struct extremes *, const struct directions *,
    struct bounds *);

/* Completes a scene of type persp, ortho, oblique or volume, and gives its camera the
 * form CAMERA_GAZE. The axes of view space do not change. near and far become the least
 * and the greatest depth of the bounds. The fit ignores the given near and far, except
 * a near plane on which sizes are given; width and height of ortho and oblique; and
 * camera.eye if has_eye is false.
 *
 * persp keeps the directions of its side planes. The eye moves along the gaze until the
 * bounds are between the side planes and one plane touches the bounds, or until near is
 * near_ratio times far. If the bounds are points and has_eye is false, the eye also
 * moves across the gaze. Both planes of the tighter pair then touch the bounds, and the
 * bounds are centred between the other two planes: the functions of these planes
 * (view_planes in frustum.h) have the same least value on the bounds.
 *
 * ortho and oblique are centred on the bounds. Width and height become the least that
 * hold the bounds; then one of them is enlarged to the aspect, unless aspect[1] is 0.
 *
 * In a volume only z_near and z_far change, to the ends of the bounds along the
 * convention's gaze, z or -z of view space. If the eye is on near's side of far, near
 * is moved until its distance from the eye is at least near_ratio times far's.
 *
 * A margin moves the side planes inward before they are compared with the bounds. The
 * eye is rounded to doubles; in persp it then moves back until the bounds are inside.
 * frustum_outside finds each corner or point of the bounds inside. near, far and the
 * sizes of ortho and oblique are the tightest such doubles, unless the errors of a far
 * eye exceed the last bits of the bounds. Returns NULL, or the member and why. */
const char *fit_scene(struct scene *, bool has_eye, const struct bounds *);

/* Finds the directions for which fit_scene makes the same scene of the farthest points
 * along them as of all points. Returns NULL, or the member at fault and why. */
const char *fit_directions(const struct scene *, bool has_eye,
    struct directions *);

/* Replaces the scene's 2D window by one that holds x and y of the bounds, given by
 * center, width and height. The center is the double nearest to the middle of the
 * bounds. Width and height are the least doubles for which frustum_outside finds the
 * bounds inside the window less its margin. Then one of them is enlarged to the
 * device's shape, if there is a device. A zero extent along one axis counts as 2^-20 of
 * the other. Returns NULL, or the member at fault and why. */
const char *fit_window(struct scene *, const struct bounds *);

/* Sets the directions along which fit_window measures: x, -x, y and -y. */
void window_directions(struct directions *);

#endif
