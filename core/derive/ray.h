/* SPDX-License-Identifier: MIT */
/* Rays from the eye through positions on the device, and where they meet a plane. */
#pragma once

#include "../points/transform.h"

/* The maps from a position on the device to its ray, in world space. */
struct ray_maker {
	struct transform to_world;  /* from x y depth to a point on the ray */
	double depth;               /* device z of the near plane */
	struct transform direction; /* from x y to a vector along the ray */
};

/* Makes the maps for rays_cast. */
bool ray_maker_of(const struct scene *, struct ray_maker *, struct refusals *faults);

/* Casts a ray through each of n <= POINTS_BLOCK device positions. Writes, in world
 * space, the point where the ray meets the near plane, or the eye if there is no near
 * plane, and the unit direction of the ray from near to far. The numbers are the
 * nearest doubles or, if single, floats; a position without a ray gets nan. The columns
 * have room for POINTS_BLOCK numbers. Returns true only if all numbers are finite. */
bool rays_cast(const struct ray_maker *, bool single, const double *const at[2],
    double *const point[3], double *const direction[3], size_t n);

/* Makes the transform from x y in the space `from` (device or ndc) to the point where
 * the ray of x y meets the plane a x + b y + c z + d = 0 of the space `to` (model,
 * world or view). w is positive in front of the eye. A refusal of the plane, which no
 * member gives, has no pointer. */
bool ray_plane_transform(const struct scene *, enum space from, enum space to,
    const double plane[4], struct transform *, struct refusals *faults);
