/* SPDX-License-Identifier: MIT */
/* A transform of points between spaces of a scene: the map, and the kernel for it. */
#pragma once

#include "kernel/kernel.h"
#include "../scene/scene.h"

/* The image of p is (p, 1) times the matrix of map, divided by its w if `divide`. */
struct transform {
	int in, out; /* coordinates of a point and its image: 2, 3 or 4 */
	bool divide;
	/* If `front` is set, a point has an image if its w is above 0: it is in front
	 * of the eye. If not, a point has an image if its w is not 0. */
	bool front;
	bool reciprocal; /* points are device positions x y z 1/w */
	/* If `staged`, an exact image is from_view's image of the point in view space.
	 * `relative` and `origin` are then those of the map to view space. So angles,
	 * which are in from_view, multiply differences that have no error. */
	bool staged;
	enum kernel_kind kernel;
	/* In a perspective z of the device may be a distance Z (distance.h). A point
	 * u v Z of DISTANCE_IN is (u w, v w, unit, w) times the map, with w = Z length.
	 * An image of DISTANCE_OUT has Z = unit w / (length z), of columns w and z. */
	enum { DISTANCE_NONE, DISTANCE_IN, DISTANCE_OUT } distance;
	struct map map;
	/* Exact images are (p - origin, 1) times `relative`: rows 0 to 2 of the map and
	 * its image of `origin`. `origin` is map.origin, or 0 if the image of 0 has the
	 * smaller error, as it has if the translation, not the eye, is given. */
	struct sum relative[4][4];
	double origin[3];
	struct map from_view;
	struct sum length, unit;
	struct kernel_map for_kernel;
};

/* Computes the transform from one space to another. If `homogeneous`, images are x y z
 * w, not divided, and points of device space are x y z 1/w. */
bool transform_of_scene(const struct scene *, enum space from, enum space to,
    bool homogeneous, struct transform *, struct refusals *faults);

/* Computes the members map, in and out, as a printed matrix needs no others. */
bool transform_of_matrix(const struct scene *, enum space from, enum space to,
    struct transform *, struct refusals *faults);

/* Computes the transform of directions, vectors in place of points, among model, world
 * and view space: the map without its translation. */
bool transform_of_directions(const struct scene *, enum space from, enum space to,
    struct transform *, struct refusals *faults);

/* Sets all members of the transform except map, which the caller has set. But if `from`
 * is SPACE_CLIP, also sets the origin of map to 0. */
void transform_init(struct transform *, enum space from, enum space to,
    bool homogeneous);

/* Computes the members relative, origin, staged, distance and for_kernel from the
 * member map. */
void transform_prepare(struct transform *);

/* Sets all members of a transform from `from` by way of view space to `to`, except
 * from_view and map, which the caller has set: to the map from view space, and to the
 * map to it, which becomes the product. */
bool transform_by_view(const struct scene *, enum space from, enum space to,
    bool homogeneous, struct transform *, struct refusals *faults);

/* Refuses the scene, and returns false, if exact images could need more than EX_WORDS
 * words. */
bool transform_check(const struct scene *, const struct transform *,
    struct refusals *faults);
