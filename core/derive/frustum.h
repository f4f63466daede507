/* SPDX-License-Identifier: MIT */
/* The view volume: its planes and corners, and the planes, or edges of a 2D window,
 * that a point is outside of. The bounds of errors, rays, and picked points. */
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

/* A point is inside if all columns of its images under both transforms are at least 0.
 * ends is not used for a 2D window (sides.in is 2). */
struct frustum {
	struct transform sides; /* left right bottom top */
	struct transform ends;  /* near far w */
};

/* Finds the limits of ndc x and y: a point is between the side planes if |x| scale[0]
 * <= half[0] and |y| scale[1] <= half[1]. half excludes the margin. */
void view_limits(const struct scene *, struct sum half[2], struct sum scale[2]);

/* Makes the planes of the view volume as linear functions of a point in one space. The
 * columns of sides are left, right, bottom and top; those of ends are near, far and w.
 * Returns NULL, or the member and the reason. */
const char *view_planes(const struct scene *, enum space from,
    struct map *sides, struct map *ends);
const char *frustum_of(const struct scene *, enum space from, bool homogeneous,
    struct frustum *);

/* Makes the edges of the 2D window as functions of a point in a 2D space: the edges of
 * the square in ndc or, on the device, those of the device. */
const char *flat_frustum_of(const struct scene *, enum flat from,
    struct frustum *);

/* Returns the OUT_ bits of the planes that a point is outside of, decided exactly. A
 * point on a plane is not outside of it. OUT_BEHIND and OUT_NAN are set alone. */
unsigned frustum_out(const struct frustum *, const double in[4]);

/* Writes frustum_out of n points; in has a column for each coordinate. */
void frustum_out_all(const struct frustum *, const double *const in[4],
    unsigned char *out, size_t n);

/* The view volume in view space. sides and ends are as in struct frustum. The corners
 * and the eye are homogeneous points, computed as the points where three planes meet:
 * the errors of an inverse map are relative to the whole volume, and could exceed a
 * small near plane. The corners are near, then far, each left-bottom, right-bottom,
 * right-top, left-top; w is not negative in them. Without near and far planes all
 * corners are at infinity. */
struct volume {
	struct map clip, sides, ends; /* from view space */
	struct sum corner[8][4], eye[4];
	struct sum eye_z[2]; /* clip z of the eye, a quotient */
};

/* Makes the volume of a scene. Returns NULL, or the member and the reason. */
const char *volume_of(const struct scene *, struct volume *);

/* Writes an upper bound of the error of any coordinate of an image, for each precision
 * and for points of the scene's view volume that are given in model space. The unit is
 * that of the device or, without a viewport, of ndc. kernel/approx.h derives the bounds.
 * A bound is nan if w could be less than its own error, or 1/w beyond the range of the
 * precision. Returns NULL, or the member and the reason. */
const char *error_bounds(const struct scene *, const struct volume *,
    double bound[3]);

/* The maps from a position on the device to the ray through it. */
struct ray_maker {
	struct transform to_world; /* from the device to the points on rays */
	double depth;              /* device z of the near plane */
	struct transform along;    /* from x y 1 to a vector along a ray */
};

/* Makes the maps for rays_cast. Returns NULL, or the member and the reason. */
const char *ray_maker_of(const struct scene *, struct ray_maker *);

/* Casts a ray through each of n <= POINTS_BLOCK device positions. Writes the point
 * where the ray meets the near plane, or the eye if there is no near plane, and the
 * unit direction of the ray from near to far. Both are in world space, in columns of
 * POINTS_BLOCK of the nearest doubles or, if single, floats. If a position has no ray,
 * they are nan. Returns true only if all numbers are finite. */
bool rays_cast(const struct ray_maker *, bool single, const double *const at[2],
    double *const point[3], double *const direction[3], size_t n);

/* Makes the transform from x and y in device or ndc space to the point where the ray
 * through them meets the plane a x + b y + c z + d = 0 of model, world or view space. w
 * is positive in front of the eye. Returns NULL, or the member and the reason. */
const char *ray_plane_transform(const struct scene *, enum space from,
    enum space to, const double plane[4], struct transform *);

/* Finds the points near a device position, and their distance from the near plane. */

struct picker {
	const struct transform *to_device; /* from model space */
	struct transform depth; /* to z, the distance from the near plane */
	double at[2], radius;   /* on the device */
};

/* Sets all members but at and radius. Returns NULL, or the member and the reason. */
const char *picker_of(const struct scene *, const struct transform *to_device,
    struct picker *);

/* Returns whether the image of a point is within radius of at, decided exactly; device
 * is the image rounded to nearest. */
bool pick_holds(const struct picker *, const double in[4],
    const double device[2]);

/* Returns the double nearest to a point's distance from the near plane. */
double pick_distance(const struct picker *, const double in[4]);

/* Returns the sign of the distance of p minus the distance of q. */
int pick_compare(const struct picker *, const double p[4], const double q[4]);

#endif
