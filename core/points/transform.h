/* SPDX-License-Identifier: MIT */
/* A transform of points from one space of a scene to another: the map, the numbers of
 * coordinates, and the kernel that computes the images. */
#ifndef TRANSFORM_H
#define TRANSFORM_H

#include "kernel/kernel.h"
#include "../scene/scene.h"

/* The image of p is (p, 1) times the matrix of map, divided by its w if `divide`. */
struct transform {
	struct map map;
	/* Exact images are (p - origin, 1) times `relative`: rows 0 to 2 of the map and
	 * its image of `origin`. `origin` is map.origin, or 0 if the image of 0 has the
	 * smaller error, as it has if the translation, not the eye, is given. */
	struct sum relative[4][4];
	double origin[3];
	int in, out; /* coordinates of a point and its image: 2, 3 or 4 */
	bool divide;
	/* If `front` is set, a point has an image if its w is above 0: it is in front
	 * of the eye. If not, a point has an image if its w is not 0. */
	bool front;
	bool reciprocal; /* points are device positions x y z 1/w */
	enum kernel_kind kind;
	struct kernel_map for_kernel;
};

/* scene_transform and flat_transform compute the transform from one space to another.
 * If `homogeneous`, images are x y z w, not divided, and points of device space are
 * x y z 1/w. Return NULL, or the member of the scene at fault and why. */
const char *scene_transform(const struct scene *, enum space from,
    enum space to, bool homogeneous, struct transform *);
const char *flat_transform(const struct scene *, enum flat_space from,
    enum flat_space to, struct transform *);

/* Sets all members of the transform except map, which the caller has set. But if `from`
 * is SPACE_CLIP, also sets the origin of map to 0. */
void transform_init(struct transform *, enum space from, enum space to,
    bool homogeneous);

/* Computes the members relative, origin and for_kernel from the member map. */
void transform_prepare(struct transform *);

/* Computes the images of n <= POINTS_BLOCK points. in and out are columns of
 * POINTS_BLOCK numbers for x, y, z and w. Coordinates beyond the range of doubles, and
 * those of points without an image, are nan in PRECISION_EXACT, but may be infinite in
 * other precisions. In PRECISION_SINGLE coordinates are floats, infinite beyond their
 * range. Returns true if all coordinates are finite. */
bool points_map(const struct transform *, enum precision,
    const double *const in[4], double *const out[4], size_t n);

/* Computes the images of rows of floats as rows of floats, in PRECISION_SINGLE. Returns
 * false, and leaves the rows of out undefined, if points_map has to compute the images,
 * for example because a point has no image. */
bool points_map_floats(const struct transform *, const char *in, char *out,
    size_t n);

/* Computes the doubles nearest to the coordinates of the exact image, for a point that
 * the kernels cannot round with certainty. A coordinate beyond the range of doubles is
 * nan; all coordinates are nan if the point has no image. */
void point_exact(const struct transform *, const double in[4], double out[4]);

/* Returns the float nearest to exact coordinate j; `image` is the nearest double. */
float point_single(const struct transform *, const double in[4], int j,
    double image);

/* Returns coordinate j of the undivided image of the point, times the map's divisor. */
struct sum point_column(const struct transform *, int j, const double in[4]);

#endif
