/* SPDX-License-Identifier: MIT */
/* A transform of points from one space of a scene to another: the map, which
 * coordinates points and images have, and the kernel that computes the images. */
#ifndef TRANSFORM_H
#define TRANSFORM_H

#include "kernel/kernel.h"
#include "../scene/scene.h"

/* The image of a point p is (p, 1) m, divided by its w if divide is set. */
struct transform {
	struct map map;
	/* The matrix for points relative to the map's origin. Row 3 is the image of the
	 * origin. An element of row 3 that is within its error of 0 is set to exact 0:
	 * its error could exceed the difference of a near point. */
	struct sum relative[4][4];
	int in, out; /* numbers of coordinates: 2, 3, or 4 if homogeneous */
	bool divide;
	/* If front, only a point with w > 0, in front of the eye, has an image; if not,
	 * a point whose w is not 0. */
	bool front;
	bool reciprocal; /* the fourth coordinate of a device point is 1/w */
	enum kernel_kind kind;
	struct kernel_map for_kernel;
};

/* Compute the transform between two spaces. If homogeneous, images have x y z w,
 * undivided; device points have x y z 1/w. Return NULL, or the member and the
 * reason. */
const char *scene_transform(const struct scene *, enum space from,
    enum space to, bool homogeneous, struct transform *);
const char *flat_transform(const struct scene *, enum flat_space from,
    enum flat_space to, struct transform *);

/* Computes all other members of a transform from its map. */
void transform_init(struct transform *, enum space from, enum space to,
    bool homogeneous);

/* Computes relative and for_kernel. */
void transform_prepare(struct transform *);

/* Computes the images of n <= POINTS_BLOCK points by the fastest loop that the
 * precision allows. x, y, z and w are columns of POINTS_BLOCK numbers each. All
 * coordinates are nan if a point has no image; a coordinate beyond the range of doubles
 * is nan. In PRECISION_SINGLE the coordinates are floats, or infinite beyond the range
 * of floats. Returns true if all coordinates are finite. */
bool points_map(const struct transform *, enum precision,
    const double *const in[4], double *const out[4], size_t n);

/* Computes the images of rows of floats as rows of floats, in PRECISION_SINGLE. Returns
 * false if the rows need points_map, as when a point has no image; out is then
 * undefined. */
bool points_map_floats(const struct transform *, const char *in, char *out,
    size_t n);

/* Computes the double nearest to each coordinate of the exact image, for a point that
 * the kernels cannot round with certainty. A coordinate beyond the range of doubles is
 * nan; all coordinates are nan if the point has no image. */
void point_exact(const struct transform *, const double in[4], double out[4]);

/* Returns the float nearest to coordinate j of the exact image, whose nearest double is
 * image. */
float point_single(const struct transform *, const double in[4], int j,
    double image);

/* Returns coordinate j of the undivided image of the point, times the map's divisor. */
struct sum point_column(const struct transform *, int j, const double in[4]);

#endif
