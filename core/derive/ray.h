/* SPDX-License-Identifier: MIT */
/* Rays under positions on the device. */
#ifndef RAY_H
#define RAY_H

#include "../points/points.h"

struct ray_maker {
	struct transform to_world; /* from the device, to where rays begin */
	double depth;              /* the near plane's, on the device */
	struct transform along; /* from the device, to a vector along the ray */
};

/* Returns NULL, or the member and the reason. */
const char *ray_maker_of(const struct scene *, struct ray_maker *);

/* The points on the near plane under n <= POINTS_BLOCK device positions, or where
 * there is none the eye, and the unit directions away from the eye, from near to far,
 * in world space: columns of POINTS_BLOCK of the nearest doubles, or floats. nan
 * where there is none. */
void rays_cast(const struct ray_maker *, bool single, const double *const at[2],
    double *const point[3], double *const direction[3], size_t n);

/* The transform from x and y of the device, or of ndc, to where the ray through them
 * meets the plane a x + b y + c z + d = 0 of another space, the world's or one before
 * or behind it. In front of the eye w is positive. Returns NULL, or the member and the
 * reason. */
const char *ray_plane_transform(const struct scene *, enum space from,
    enum space to, const double plane[4], struct transform *);

#endif
