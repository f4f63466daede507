/* SPDX-License-Identifier: MIT */
/* The way from one space of a scene to another, for many points: a composed
 * map and what follows from it alone. */
#ifndef TRANSFORM_H
#define TRANSFORM_H

#include "kernel/kernel.h"
#include "../scene/scene.h"

/* A point's image is (p, 1) m, divided by its w where divide says. */
struct transform {
	struct map map;
	/* The map for points relative to its origin. Row 3 is settled: what is 0 by its
	 * formula has no error beside the difference of a near point. */
	struct sum relative[4][4];
	int in, out; /* coordinates: 2, 3, or 4 for clip and homogeneous ones */
	bool divide;
	/* Only w > 0 has an image (the point is in front of the eye). If
	 * false, any w other than 0 has one. */
	bool front;
	/* The fourth number read is 1/w, of a device point. */
	bool reciprocal;
	enum kernel_kind kind;
	struct kernel_map for_kernel;
};

/* The transform between two spaces; homogeneous keeps x y z w undivided or,
 * from the device, reads 1/w after x y z. Returns NULL, or the member and the
 * reason. */
const char *scene_transform(const struct scene *, enum space from,
    enum space to, bool homogeneous, struct transform *);
const char *flat_transform(const struct scene *, enum flat from, enum flat to,
    struct transform *);

/* The same for the map that the transform holds, whatever leads from one space to
 * another. */
void transform_init(struct transform *, enum space from, enum space to,
    bool homogeneous);

/* Finds the image of the map's origin, and the map that the kernels take. */
void transform_prepare(struct transform *);

#endif
