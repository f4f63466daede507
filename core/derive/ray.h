/* SPDX-License-Identifier: MIT */
/* Rays through positions on the device. */
#ifndef RAY_H
#define RAY_H

#include "../points/transform.h"

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
