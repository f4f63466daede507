/* SPDX-License-Identifier: MIT */
/* Distances along the gaze, and how finely a depth buffer tells them apart. */
#ifndef DEPTH_H
#define DEPTH_H

#include "../scene/scene.h"
#include "../points/transform.h"

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
 * single, floats. A position without a ray gets nan. */
void rays_cast(const struct ray_maker *, bool single, const double *const at[2],
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
