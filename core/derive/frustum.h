/* SPDX-License-Identifier: MIT */
/* The view volume: its planes, its corners, and the test which planes, or edges of a 2D
 * window, a point is outside of. */
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

/* A point is inside if all columns of its images under both transforms are at least 0. A
 * 2D window (sides.in is 2) does not use ends. */
struct frustum {
	struct transform sides; /* left right bottom top */
	struct transform ends;  /* near far w */
};

/* Finds the limits of ndc x and y: a point is between the side planes if |x| scale[0] <=
 * half[0] and |y| scale[1] <= half[1]. half is the viewport's, less the margin. */
void view_limits(const struct scene *, struct sum half[2], struct sum scale[2]);

/* Makes the planes of the view volume as linear functions of a point in one space. The
 * columns of sides are left, right, bottom and top; those of ends are near, far and w.
 * Returns NULL, or the member and the reason. */
const char *view_planes(const struct scene *, enum space from,
    struct map *sides, struct map *ends);
const char *frustum_of(const struct scene *, enum space from, bool homogeneous,
    struct frustum *);

/* Makes the edges of the 2D window as functions of a point in a 2D space. They are the
 * edges of the square in ndc, and those of the device on the device. */
const char *flat_frustum_of(const struct scene *, enum flat from,
    struct frustum *);

/* Returns the OUT_ bits of the planes that a point is outside of, decided exactly. A
 * point on a plane is not outside of it. With OUT_BEHIND or OUT_NAN no other bit is
 * set. */
unsigned frustum_out(const struct frustum *, const double in[4]);

/* Writes frustum_out of n points; in has a column for each coordinate. */
void frustum_out_all(const struct frustum *, const double *const in[4],
    unsigned char *out, size_t n);

/* The planes of the view volume in view space, and the map from view space to another
 * space. A corner is computed as the point where three planes meet. An inverse map has
 * errors relative to the volume, in which the corners of a small near plane would
 * drown. */
struct volume {
	struct map sides, ends, from_view;
};

/* Makes the volume of a scene. Returns NULL, or the member and the reason. */
const char *volume_of(const struct scene *, enum space to, struct volume *);

/* Writes the homogeneous image of corner 0..7 of the view volume: near, then far, each
 * left-bottom, right-bottom, right-top, left-top. Without near and far planes all are at
 * infinity. Returns the positive factor f: h / f is the image of the corner with clip
 * w 1. */
struct sum volume_corner(const struct volume *, int corner, struct sum h[4]);

/* Writes the homogeneous image of the eye, where clip x, y and w are 0. Returns 1 where
 * the eye is on the inner side of the far plane, -1 beyond it, 0 at infinity. */
int volume_eye(const struct volume *, struct sum h[4]);

/* Writes the homogeneous point where three planes a x + b y + c z + d = 0 meet. All of h
 * is 0 if the planes have more than one point in common. */
void planes_meet(const struct sum plane[3][4], struct sum h[4]);

/* Distances along the gaze, and how finely a depth buffer tells them apart. */

enum buffer { BUFFER_UNORM16, BUFFER_UNORM24, BUFFER_FLOAT32, BUFFERS };

/* The distance D at depth z is (over[0] z + over[1]) / (under[0] z + under[1]). z is
 * device depth or, without a viewport, from 0 to 1. D is measured along the gaze: from
 * the eye in a perspective, else from the origin of view space. under[0] is 0 only in a
 * parallel projection. In a perspective a depth whose denominator is positive is in
 * front of the eye. If planes of equal depth are tilted against the projection plane, D
 * is measured on the normal of the projection plane through the eye. */
struct depth {
	struct sum over[2], under[2];
	double low, high; /* z at the least ndc depth, and at ndc depth 1 */
	bool reversed;    /* the near plane has the larger ndc depth */
	bool open;        /* there are no near and far planes */
	bool flat;        /* min_z equals max_z: low and high are 0 and 1 */
};

/* Finds D(z) of a scene. All maps of the scene must be invertible. reversed says that the
 * near plane has the larger ndc depth. */
void depth_of(const struct scene *, bool reversed, struct depth *);

/* Writes the distance of the near or far plane as a quotient. */
void depth_quotient(const struct depth *, bool far, struct sum *over,
    struct sum *under);

/* Returns the distance of the near or far plane: infinite if the plane is at infinity,
 * nan if it is behind the eye or does not exist. */
double depth_distance(const struct depth *, bool far);

/* Returns how far inward from the near or far plane the depth has changed by one step of
 * the buffer; a step of BUFFER_FLOAT32 ends at the next float. Returns nan if the plane
 * is at infinity or does not exist, or if the whole range of depth is less than a
 * step. */
double depth_step(const struct depth *, enum buffer, bool far);

/* Returns how far from the distance at, toward the eye, the depth has changed by one step
 * of the buffer. */
double depth_step_at(const struct depth *, enum buffer, double at);

/* Upper bounds of the error of a point's image. */

/* Writes for each precision an upper bound of the error of any coordinate of an image, in
 * device units or, without a viewport, ndc units, for points of the view volume that are
 * given in model space. kernel/plain.h derives the bounds. A bound is nan if w could be
 * less than its own error, or 1/w beyond the range of the precision. Returns NULL, or
 * the member and the reason. */
const char *error_bounds(const struct scene *, double bound[3]);

/* Rays through positions on the device. */

struct ray_maker {
	struct transform to_world; /* from the device to the points on rays */
	double depth;              /* device z of the near plane */
	struct transform along;    /* from x y 1 to a vector along a ray */
};

/* Prepares rays_cast. Returns NULL, or the member and the reason. */
const char *ray_maker_of(const struct scene *, struct ray_maker *);

/* Casts a ray through each of n <= POINTS_BLOCK device positions. Writes its point on the
 * near plane, or the eye if there is no near plane, and its unit direction from near to
 * far. Both are in world space, in columns of POINTS_BLOCK of the nearest doubles or, if
 * single, floats. A position without a ray gets nan. Returns true only if all numbers
 * are finite. */
bool rays_cast(const struct ray_maker *, bool single, const double *const at[2],
    double *const point[3], double *const direction[3], size_t n);

/* Makes the transform from x and y in device or ndc space to the point where the ray
 * through them meets the plane a x + b y + c z + d = 0 of model, world or view space. w
 * is positive in front of the eye. Returns NULL, or the member and the reason. */
const char *ray_plane_transform(const struct scene *, enum space from,
    enum space to, const double plane[4], struct transform *);

/* The points near a position on the device, and their distances from the near plane. */

struct picker {
	const struct transform *to_device; /* from model space */
	struct transform depth; /* to z, the distance from the near plane */
	double at[2], radius;   /* on the device */
};

/* Sets all members but at and radius. Returns NULL, or the member and the reason. */
const char *picker_of(const struct scene *, const struct transform *to_device,
    struct picker *);

/* Returns whether the image of a point is within radius of at, decided exactly; device is
 * the image rounded to nearest. */
bool pick_holds(const struct picker *, const double in[4],
    const double device[2]);

/* Returns the double nearest to a point's distance from the near plane. */
double pick_distance(const struct picker *, const double in[4]);

/* Returns the sign of the distance of p minus the distance of q. */
int pick_compare(const struct picker *, const double p[4], const double q[4]);

#endif
