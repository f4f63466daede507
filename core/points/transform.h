/* SPDX-License-Identifier: MIT */
/* A transform of points from one space of a scene to another: a map, and how points are
 * read, divided and computed. */
#ifndef TRANSFORM_H
#define TRANSFORM_H

#include "kernel/kernel.h"
#include "../scene/scene.h"

/* The image of a point p is (p, 1) m, divided by its w if divide is set. */
struct transform {
	struct map map;
	/* The matrix for points relative to the map's origin. Row 3, the image of
	 * the origin, has exact zeros instead of numbers within their error of 0,
	 * as such an error could exceed a near point's difference. */
	struct sum relative[4][4];
	/* numbers of coordinates: 2, 3, or 4 in clip space and homogeneous */
	int in, out;
	bool divide;
	/* A point has an image if w > 0, in front of the eye; else if w is not 0. */
	bool front;
	bool reciprocal; /* the fourth coordinate of a device point is 1/w */
	enum kernel_kind kind;
	struct kernel_map for_kernel;
};

/* Compute the transform between two spaces. If homogeneous, images are x y z w, undivided,
 * or points of the device are x y z 1/w. Return NULL, or the member and the reason. */
const char *scene_transform(const struct scene *, enum space from,
    enum space to, bool homogeneous, struct transform *);
const char *flat_transform(const struct scene *, enum flat from, enum flat to,
    struct transform *);

/* Computes the rest of a transform that holds its map. */
void transform_init(struct transform *, enum space from, enum space to,
    bool homogeneous);

/* Computes the relative matrix, and the map that the kernels take. */
void transform_prepare(struct transform *);

#endif
