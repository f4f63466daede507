/* SPDX-License-Identifier: MIT */
/* The bounds that the command fit encloses, their extents, and the fit. */
#ifndef FIT_H
#define FIT_H

#include "../scene/scene.h"

enum { BOUNDS_POINTS = 10 }; /* 6 along axes, 4 normal to side planes */

/* A sphere, a box from min to max or, if n is not 0, n points: those of the user's
 * points that are farthest along the directions of fit_directions. All numbers are in
 * model space; the world matrix turns the sphere into an ellipsoid. In a 2D window
 * there is no third coordinate, and the sphere is a circle. */
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

/* Makes the hull of bounds of two or three coordinates. Returns NULL or, if max is less
 * than min along an axis, the member and the reason. */
const char *hull_of(const struct bounds *, int dimensions, struct hull *);

/* Returns the least value on the hull of coordinate j of a map's images or, if `minus`
 * is set, of its negative. */
struct sum hull_lowest(const struct hull *, const struct map *, int j,
    bool minus);

/* The least and greatest coordinate of a hull along each axis, and their difference. */
struct extents {
	struct sum low[3], high[3], size[3];
};

/* Sets element j of extents to the range of coordinate j of the hull's images. */
void extents_set(struct extents *, int j, const struct hull *,
    const struct map *);

/* Moves `low` and `high` of each zero extent of the first n axes apart by 2^-20 of the
 * largest extent; `size` stays 0. Returns NULL, or the reason if all extents are 0. */
const char *extents_widen(struct extents *, int n);

/* Makes the maps from model space by whose columns fit measures bounds. Columns 0 and 1
 * of xy are x and y: of view space for persp and volume, of clip space with y upward
 * for ortho and oblique, whose width and height the caller has set to 2. Column 2 of
 * depth is the distance along the gaze or, for persp, w. Returns NULL, or the member
 * and the reason. */
const char *fit_axes(const struct scene *, struct map *xy, struct map *depth);

/* Finds the extents of a hull along the columns of fit_axes, and widens zero extents.
 * Returns NULL, or the member at fault and why. */
const char *hull_extents(const struct hull *, const struct scene *,
    struct extents *);

/* Returns the OUT_ bits of the planes of the view volume that any part of the hull is
 * outside of, or all bits if the scene has no volume. */
unsigned hull_outside(const struct hull *, const struct scene *);

/* Directions in model space. scaled[i] is exact[i] divided by its element of largest
 * magnitude, rounded, so that no sum of products of scaled[i] with coordinates
 * overflows. An element of `scaled` is 0 if and only if that of `exact` is 0. */
struct directions {
	int n;
	struct sum exact[BOUNDS_POINTS][3];
	double scaled[BOUNDS_POINTS][3];
};

/* Adds the direction in which coordinate j of images grows or, if `minus`, falls. */
void directions_add(struct directions *, const struct map *, int j, bool minus);

/* The farthest point along a direction. `distance` is its rounded dot product with
 * struct directions' `scaled`; `error` bounds its error. known: a point was added. */
struct farthest {
	bool known;
	double point[3], distance, error;
};

/* The farthest point along each direction. All bytes are 0 before the first point. */
struct extremes {
	struct farthest item[BOUNDS_POINTS];
};

/* Adds n points; `in` has a column for each coordinate. A point with a nan does not
 * count. The caller pads each column to a multiple of 16 numbers with numbers of these
 * points. */
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
 * form CAMERA_GAZE. The axes of view space do not change. near and far become the ends
 * of the bounds' depth. These are ignored: near and far, but not a near plane on which
 * sizes are given; width and height of ortho and oblique; camera.eye if not has_eye.
 *
 * persp keeps the directions of its side planes. The eye moves along the gaze until the
 * bounds are between the side planes and one plane touches the bounds, or until near is
 * near_ratio times far. If the bounds are points and has_eye is false, the eye also
 * moves across the gaze. Both planes of the tighter pair then touch the bounds. The
 * functions of the other two planes have the same least value on the bounds.
 *
 * ortho and oblique are centred on the bounds. Width and height become the least that
 * hold the bounds; then the shorter side is widened to the aspect, if the projection
 * has one (aspect[1] is not 0).
 *
 * In a volume only z_near and z_far change, to the ends of the bounds along the
 * convention's gaze, z or -z of view space. If the eye is before far, near is moved
 * until its distance from the eye is at least near_ratio times far's.
 *
 * A margin moves the side planes inward before they are compared with the bounds. The
 * eye is rounded to doubles; in persp it then moves back until the bounds are inside.
 * frustum_outside finds each corner or point of the bounds inside. near, far and the
 * sizes of ortho and oblique are the tightest doubles with this property, unless the
 * eye is so far away that errors exceed the last bits of the bounds. Returns NULL, or
 * the member and the reason. */
const char *fit_scene(struct scene *, bool has_eye, const struct bounds *);

/* Finds the directions along which fit_scene measures. The farthest points along them
 * make the same scene as all points. Returns NULL, or the member at fault and why. */
const char *fit_directions(const struct scene *, bool has_eye,
    struct directions *);

/* Replaces the scene's 2D window by one of center, width and height that holds x and y
 * of the bounds. The center is the double nearest to the middle of the bounds. Width
 * and height are the least doubles for which frustum_outside finds the bounds inside
 * the window less its margin. Then the shorter side is widened to the device's shape,
 * if there is a device. A zero extent along one axis counts as 2^-20 of the other.
 * Returns NULL, or the member at fault and why. */
const char *fit_window(struct scene *, const struct bounds *);

/* Sets the directions along which fit_window measures: x, -x, y and -y. */
void window_directions(struct directions *);

#endif
