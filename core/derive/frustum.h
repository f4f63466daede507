/* SPDX-License-Identifier: MIT */
/* The view volume, or the edges of a 2D window, and what follows from them: whether a
 * point is outside, bounds of errors, rays, and the points near a position. */
#ifndef FRUSTUM_H
#define FRUSTUM_H

#include "../points/transform.h"

enum {
	OUT_LEFT = 1,
	OUT_RIGHT = 2,
	OUT_BOTTOM = 4,
	OUT_TOP = 8,
	OUT_NEAR = 16,
	OUT_FAR = 32,
	OUT_BEHIND = 64,
	OUT_NAN = 128,
};

/* A point is inside if no column of its images under `sides` and `ends` is negative,
 * and w is positive. A 2D window, for which sides.in is 2, does not use `ends`. */
struct frustum {
	struct transform sides; /* to the columns left, right, bottom and top */
	struct transform ends;  /* to the columns near, far and w */
};

/* Finds the limits of ndc x and y: a point is between the side planes if |x| scale[0]
 * <= half[0] and |y| scale[1] <= half[1]. The scene's margin makes half smaller. */
void view_limits(const struct scene *, struct sum half[2], struct sum scale[2]);

/* view_planes and frustum_of make the planes of the view volume, as linear functions of
 * a point in the space `from`; inside no function is negative. `sides` has the columns
 * left, right, bottom and top, `ends` near, far and w. If `homogeneous` is set, points
 * of device space are x y z 1/w. Both return NULL, or the member at fault and why. */
const char *view_planes(const struct scene *, enum space from,
    struct map *sides, struct map *ends);
const char *frustum_of(const struct scene *, enum space from, bool homogeneous,
    struct frustum *);

/* Makes the edges of the ndc square, which fills the device, as functions of a point in
 * the 2D space `from`. Returns NULL, or the member at fault and why. */
const char *flat_frustum_of(const struct scene *, enum flat_space from,
    struct frustum *);

/* Returns the OUT_ bits of the planes that a point is outside of, decided exactly. A
 * point on a plane is not outside. With OUT_BEHIND or OUT_NAN no other bit is set. */
unsigned frustum_outside(const struct frustum *, const double in[4]);

/* Writes frustum_outside of n points to `out`. `in` has one column per coordinate. */
void frustum_outside_all(const struct frustum *, const double *const in[4],
    unsigned char *out, size_t n);

/* The view volume in view space. sides and ends have the columns of view_planes. The
 * corners and the eye are homogeneous points, each computed as the point where three
 * planes meet. (The inverse of to_clip has errors relative to the whole volume; they
 * could exceed the size of a small near plane.) The corners of near are 0 to 3, those
 * of far 4 to 7, in the order left-bottom, right-bottom, right-top, left-top. w of a
 * corner is not negative. Without near and far planes all corners are at infinity. */
struct volume {
	struct map to_clip, sides, ends; /* from view space */
	struct sum corner[8][4], eye[4];
	struct sum eye_z[2]; /* clip z of the eye is eye_z[0] / eye_z[1] */
};

/* Makes the volume of a scene. Returns NULL, or the member at fault and why. */
const char *volume_of(const struct scene *, struct volume *);

/* Writes to bound[enum precision] an upper bound of the errors of the coordinates of
 * images, for all model points in the view volume. The unit is that of the device or,
 * without a viewport, of ndc. kernel/approx.h derives the bounds. A bound is nan if a
 * point's w could be at most 16 times its error, or if 1/w is beyond the range of the
 * precision. Returns NULL, or the member at fault and why. */
const char *error_bounds(const struct scene *, const struct volume *,
    double bound[3]);

/* The maps from a position on the device to its ray, in world space. */
struct ray_maker {
	struct transform to_world;  /* from x y depth to a point on the ray */
	double depth;               /* device z of the near plane */
	struct transform direction; /* from x y to a vector along the ray */
};

/* Makes the maps for rays_cast. Returns NULL, or the member at fault and why. */
const char *ray_maker_of(const struct scene *, struct ray_maker *);

/* Casts a ray through each of n <= POINTS_BLOCK device positions. Writes, in world
 * space, the point where the ray meets the near plane, or the eye if there is no near
 * plane, and the unit direction of the ray from near to far. The numbers are the
 * nearest doubles or, if single, floats; a position without a ray gets nan. The columns
 * have room for POINTS_BLOCK numbers. Returns true only if all numbers are finite. */
bool rays_cast(const struct ray_maker *, bool single, const double *const at[2],
    double *const point[3], double *const direction[3], size_t n);

/* Makes the transform from x y in the space `from` (device or ndc) to the point where
 * the ray of x y meets the plane a x + b y + c z + d = 0 of the space `to` (model,
 * world or view). w is positive in front of the eye. Returns NULL or the reason. */
const char *ray_plane_transform(const struct scene *, enum space from,
    enum space to, const double plane[4], struct transform *);

/* A circle on the device. Points with images in it are picked, ordered by `depth`. */
struct picker {
	const struct transform *to_device; /* from model space */
	struct transform depth; /* z of the image is the distance from near */
	double at[2], radius;   /* on the device */
};

/* Sets to_device and depth of a picker. Returns NULL, or the member and the reason. */
const char *picker_of(const struct scene *, const struct transform *to_device,
    struct picker *);

/* Returns whether the exact image of a point is in the picker's circle. `device` is the
 * image rounded to the nearest doubles. */
bool pick_is_within(const struct picker *, const double in[4],
    const double device[2]);

/* Returns the double nearest to a point's distance from the near plane. */
double pick_distance(const struct picker *, const double in[4]);

/* Returns the sign of p's distance from the near plane minus q's. */
int pick_compare(const struct picker *, const double p[4], const double q[4]);

#endif
