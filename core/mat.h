/* Homogeneous maps of row vectors between spaces, in double-double. */
#ifndef MAT_H
#define MAT_H

#include <stdbool.h>
#include <stddef.h>

#include "dd.h"
#include "expansion.h"
#include "sum.h"

/* q = (p - origin, 1) m[0..3], or (p, 1) m with its last row replaced by
 * m[AT_ZERO]: the matrix that is printed. Points are taken relative to the
 * origin (the eye, a window's centre), and the difference is exact, so that
 * distance from the world's origin costs nothing.
 *
 * sum[i][j] is the sum of |products| of which m[i][j] is the sum, when the
 * stages are multiplied out; each element is within MAP_BOUND u^2 sum[i][j]
 * of its exact value, while none falls below 2^-968, and 0 where half that
 * leaves nothing of it. */
enum { AT_ORIGIN = 3, AT_ZERO = 4 };

struct map {
	double origin[3];
	dd m[5][4];
	double sum[5][4];
	bool exact; /* affine, with last rows as they were given */
};

/* Elements of four stages and of their three compositions are rounded once
 * each, and may be as wrong again where they are taken for 0. */
#define MAP_BOUND (14 * EX_BOUND)

extern const struct map map_identity;

/* A map whose elements are exact or rounded once: sets sum; AT_ORIGIN and
 * AT_ZERO rows are m[3], the origin 0. */
struct map map_of(dd m[4][4]);
struct map map_of_doubles(double m[4][4]);

/* Takes points relative to an origin whose image is 0, or to zero again, as
 * clip points need it: their w is not 1. */
void map_about(struct map *a, const double origin[3]);
void map_about_zero(struct map *a);

/* First a, then b. The products are summed exactly and rounded once. */
struct map map_then(const struct map *a, const struct map *b);

/* Sets to 0 what may be nothing but rounding errors. */
void map_settle(struct map *a);

/* Column j of the image of p, relative to the origin, w: four products and sums
 * in double-double, within 13 u^2 of size; 0 where it is no larger than that
 * and the elements' own errors. */
struct sum map_column(const struct map *, int j, const dd p[4]);

/* The inverse of a bare matrix, each element an exact quotient of minors
 * rounded once. Returns false where it is singular. An affine one (last
 * column 0 0 0 1) gets its last row as origin. */
bool map_inverse(double m[4][4], struct map *inverse);

/* Determinant of the n rows and columns of m that are not struck out. */
ex ex_minor(int n, ex m[4][4], unsigned rows, unsigned columns);

bool map_is_affine(const struct map *);
bool map_is_finite(const struct map *);

#endif
