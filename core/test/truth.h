/* SPDX-License-Identifier: MIT */
/* The truth for tests: the manual's formulas as a textbook writes them, with so
 * many bits that what is lost does not count. Shares nothing with the code
 * under test but the structs of its parameters. truth.c multiplies stages out
 * and tells what is nearest, truth_projection.c has the stages of a projection,
 * truth_scene.c those of a whole scene. */
#ifndef TRUTH_H
#define TRUTH_H

#include "real.h"
#include "../scene/scene.h"

/* A matrix for row vectors, and the sizes of its elements. An element of a product of
 * stages is a sum; its size is the sum of the magnitudes of the terms. */
struct truth_stage {
	real m[4][4], size[4][4];
};

struct truth {
	int n;
	bool irrational; /* an angle or a length is in it */
	struct truth_stage stage[20];
	struct truth_stage all; /* their product, see truth_compose */
};

/* Adds a stage that is the identity. An element without a size (NULL) has its magnitude
 * as size. */
struct truth_stage *truth_stage(struct truth *);
/* Adds half a turn around x. */
void truth_half_turn(struct truth *);
void truth_projection(struct truth *, const struct projection *,
    const struct convention *);
void truth_compose(struct truth *);

/* Adds the stages between two spaces of a scene that is not degenerate, and multiplies
 * them out. */
void truth_scene(const struct scene *, enum space from, enum space to,
    struct truth *);
void truth_flat(const struct scene *, enum flat_space from, enum flat_space to,
    struct truth *);

/* Returns 1 if the camera looks along +z of view space, -1 for -z. */
double truth_gaze_sign(const struct convention *);

/* Returns the convention of the answer. */
const struct convention *truth_answer(const struct scene *);

/* Sets m to the matrix that truth_scene composes. */
void truth_matrix(const struct scene *, enum space from, enum space to,
    real m[4][4]);

/* Returns the limits of |x| and |y| in ndc on the viewport. */
void truth_limits(const struct scene *, real limit[2]);

/* A sum, and the sum of the magnitudes of its terms. */
struct sized {
	real value, size;
};

struct sized sized_of(double);
struct sized sized_add(struct sized, struct sized);
struct sized sized_sub(struct sized, struct sized);
struct sized sized_mul(struct sized, struct sized);
struct sized sized_dot(const struct sized a[3], const struct sized b[3]);

/* Returns a bound of the error of the length of v. */
struct sized sized_length(const struct sized v[3]);

/* Returns the length of the first three numbers of P's last row. */
struct sized truth_w_gradient(const struct projection *);

/* Returns column j of the image of (p[0], p[1], p[2], p[3]). */
struct sized truth_column(const struct truth *, int j, const double p[4]);
struct sized truth_element(const struct truth *, int i, int j);

/* Returns -1, 0 or 1; 0 if all but rounding errors has cancelled. Sets *doubtful,
 * unless it is NULL, if by TRUTH_RULE the sum may be 0, too. */
int truth_sign(struct sized, bool *doubtful);

/* A number with a root or an angle in it may be off by this part of the magnitudes of
 * its terms where it is compared with 0 and with midpoints. The error that each sum
 * knows is less (core/exact/sum.h). */
#define TRUTH_TOLERANCE 0x1p-290

/* The result of the comparison of a number with the truth. */
enum verdict {
	NEAREST,          /* ties to even */
	WITHIN_TOLERANCE, /* nearest to a number that differs by less than TRUTH_RULE */
	WRONG,
	VERDICTS,
};

/* Judges a printed number against n / d, which is nan beyond the range. */
enum verdict truth_verdict(double printed, struct sized n, struct sized d,
    bool single);

/* Returns the double nearest to an element. */
double element(const struct map *, int i, int j);

/* The worst errors of many maps. In a rational scene TRUTH_RULE excuses no
 * error. */
struct worst {
	int verdicts[VERDICTS]; /* of elements as doubles and as floats */
	double error;           /* of an element's dd, in units of 2^-106 */
	double bound;           /* of a sum's error, in units of the rule's */
	int beyond;             /* elements that are not within their error */
	int false_nonzeros;     /* elements not 0 that ought to be */
};

/* Compares every element of the matrix. */
void truth_compare(const struct truth *, const struct map *, struct worst *);

#endif
