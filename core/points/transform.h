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

/* The transform of blocks of points by the fastest loop that the precision allows. The loop
 * leaves points that it cannot decide to point_exact. */

/* Computes the images of n <= POINTS_BLOCK points. x, y, z and w are columns of POINTS_BLOCK
 * numbers each. A point without an image is nan, and so is a coordinate beyond the range
 * of doubles. In PRECISION_SINGLE the coordinates are floats, or infinite beyond the
 * floats' range. Returns true if all coordinates are finite. */
bool points_map(const struct transform *, enum precision,
    const double *const in[4], double *const out[4], size_t n);

/* Computes the images of rows of floats as rows of floats, in PRECISION_SINGLE. Returns false
 * where the rows need points_map, as when a point has no image; out is then undefined. */
bool points_map_floats(const struct transform *, const char *in, char *out,
    size_t n);

/* The transform of one point in exact arithmetic: the accurate phase, for the points that
 * the kernels cannot round with certainty. */

/* Computes the double nearest to each coordinate of the exact image. A coordinate beyond the
 * range of doubles is nan; so are all where the point has no image. */
void point_exact(const struct transform *, const double in[4], double out[4]);

/* Returns the float nearest to coordinate j of the exact image, whose nearest double is
 * image. */
float point_single(const struct transform *, const double in[4], int j,
    double image);

/* Returns coordinate j of the undivided image of the point, times the map's divisor. */
struct sum point_column(const struct transform *, int j, const double in[4]);

#endif
