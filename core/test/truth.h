/* The truth for tests: the manual's formulas as a textbook writes them, with so
 * many bits that what is lost does not count. Shares nothing with the code
 * under test but the structs of its parameters. truth.c carries points through
 * stages and compares maps with them, truth_projection.c has the stages of a
 * projection, truth_scene.c those of a whole scene. */
#ifndef TRUTH_H
#define TRUTH_H

#include "real.h"
#include "../scene.h"

/* One step of a map. A homogeneous point p is a row and becomes
 * (p - w (before, 0)) m + w (after, 0). An eye or a translation stays out of
 * m, so that a sum of sizes counts its difference from p as one number. */
struct truth_stage {
	real before[3];
	real m[4][4];
	real after[3];
};

struct truth {
	int n;
	struct truth_stage stage[6];
};

/* Adds a stage that does nothing yet. */
struct truth_stage *truth_stage(struct truth *);
void truth_projection(struct truth *, const struct projection *,
    const struct convention *);

/* The stages between two spaces of a scene that is not degenerate. */
void truth_scene(const struct scene *, enum space from, enum space to,
    struct truth *);
void truth_flat(const struct scene *, enum flat from, enum flat to,
    struct truth *);

/* The image q of the homogeneous point p, not divided by w. When the stages are
 * multiplied out each coordinate of q is a sum of products; sum has the same
 * with all products made positive. */
void truth_image(const struct truth *, const double p[4], real q[4],
    real sum[4]);

/* The composed matrix: its rows are the images of the four unit points. */
void truth_matrix(const struct truth *, real m[4][4], real sum[4][4]);

/* What cancellation costs coordinate j: sum / |q|, times the same of w where
 * the image is divided. */
double truth_kappa(real q[4], real sum[4], int j, bool divided);

/* The worst of many maps. */
struct worst {
	double error;   /* of an element, in units of 2^-106 times its sum */
	double printed; /* what is wrong beyond half a unit in the last place,
	                 * in units of kappa 2^-47: at most 1 */
	double size;    /* a map's sum over the truth's sum: at most 1 */
	int ghosts;     /* elements that are not 0 and ought to be */
};

/* Compares every element of the matrix and of the image of the map's origin. */
void truth_compare(const struct truth *, const struct map *, struct worst *);

#endif
