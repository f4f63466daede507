/* SPDX-License-Identifier: MIT */
/* The true values for tests: the formulas of the manual as in a textbook, with
 * REAL_BITS bits, whose rounding errors are negligible. Nothing is shared with the code
 * under test but the structs of its parameters. A map is a product of stages:
 * truth_scene.c makes those of a whole scene, truth_projection.c those of a projection,
 * and truth.c multiplies them and tells which double is nearest. */
#pragma once

#include "real.h"
#include "../scene/scene.h"

/* A matrix for row vectors, and the sizes of its elements. An element of a product of
 * stages is a sum, and its size is the sum of the magnitudes of its terms. */
struct truth_stage {
	real m[4][4], size[4][4];
};

struct truth {
	int n;
	bool irrational; /* an angle or the length of a vector occurs */
	struct truth_stage stage[80];
	struct truth_stage product; /* of the stages, by truth_compose */
};

/* Adds a stage that is the identity, and returns it. The size of an element is its
 * magnitude while the size is NULL. */
struct truth_stage *truth_stage(struct truth *);
/* Adds a stage: half a turn around x. */
void truth_half_turn(struct truth *);
void truth_projection(struct truth *, const struct projection *,
    const struct convention *);
void truth_compose(struct truth *);

/* Sets the stages to those between two spaces of a scene that is not degenerate, and
 * multiplies them. */
void truth_scene(const struct scene *, enum space from, enum space to, struct truth *);
void truth_flat(const struct scene *, enum space from, enum space to, struct truth *);

/* Returns 1 if the camera looks along +z of view space, -1 for -z. */
double truth_gaze_sign(const struct convention *);

/* Returns the convention of the answer. */
const struct convention *truth_answer(const struct scene *);

/* Sets m to the product of the stages of truth_scene. */
void truth_matrix(const struct scene *, enum space from, enum space to, real m[4][4]);

/* Returns the limits of |x| and |y| in ndc on the viewport, less the margin of the
 * scene. */
void truth_limits(const struct scene *, real limit[2]);

/* Sets column to the distance that inspect prints as near and far, a function on view
 * space: from the eye along the gradient of w or, if w is constant, from the origin
 * along the gaze or, of a matrix, from near to far. Returns whether w is constant. */
bool truth_distance(const struct scene *, real column[4]);

/* A value that is a sum. Its size is the sum of the magnitudes of its terms. */
struct sized {
	real value, size;
};

struct sized sized_of(double);
struct sized sized_add(struct sized, struct sized);
struct sized sized_sub(struct sized, struct sized);
struct sized sized_mul(struct sized, struct sized);
struct sized sized_dot(const struct sized a[3], const struct sized b[3]);

/* Returns the length of v, with the length plus the sizes of v as its size. */
struct sized sized_length(const struct sized v[3]);

/* Returns the length of the first three numbers in the last row of the matrix P, which
 * is how much w changes per unit of distance. */
struct sized truth_w_gradient(const struct projection *);

/* Returns the product of the row vector p and column j of the matrix. */
struct sized truth_column(const struct truth *, int j, const double p[4]);
struct sized truth_element(const struct truth *, int i, int j);

/* Sets plane to the functions of the planes left, right, bottom, top, near and far at
 * the point q of clip space. They are not negative inside. */
void truth_planes(const struct scene *, const struct sized q[4], struct sized plane[6]);

/* Returns the sign of the value, or 0 if only rounding errors are left of it. Sets
 * *doubtful, unless it is NULL, to whether the value is within TRUTH_TOLERANCE times
 * its size of 0. */
int truth_sign(struct sized, bool *doubtful);

/* A computed number with a root or an angle in it may be off by this part of its size,
 * where it is compared with 0 and with midpoints of doubles. The errors of sums in
 * core/exact/sum.h are less. */
#define TRUTH_TOLERANCE 0x1p-290

/* The result of the comparison of a number with the truth. */
enum verdict {
	NEAREST,          /* the nearest double or float; of two, the even one */
	WITHIN_TOLERANCE, /* nearest to a number off by less than the tolerance */
	WRONG,
	VERDICTS,
};

/* Returns the verdict on a computed number whose true value is n / d. It must be nan if
 * that is beyond the range of doubles, or floats. */
enum verdict truth_verdict(double printed, struct sized n, struct sized d, bool single);

/* Returns the double nearest to an element. */
double element(const struct map *, int i, int j);

/* A largest value, with the sample and the element where it was found. */
struct largest {
	double value;
	char where[200];
};

/* The worst errors in many maps. TRUTH_TOLERANCE excuses none in a rational scene. */
struct worst {
	int verdicts[VERDICTS];    /* of elements as doubles and as floats */
	struct largest pair_error; /* of an element's pair of doubles, in 2^-106 */
	struct largest sum_bound;  /* bound of a sum / (TRUTH_TOLERANCE times size) */
	int beyond_error;          /* elements whose error is above its bound */
	int false_nonzeros;        /* elements that are not 0 where the truth is */
	struct largest fault;      /* 1: the first that is wrong, beyond or not 0 */
};

/* Compares every element of the map with the truth. */
void truth_compare(const struct truth *, const struct map *, struct worst *);
