/* Homogeneous maps of row vectors between spaces, in double-double. */
#ifndef MAT_H
#define MAT_H

#include <stdbool.h>
#include <stddef.h>

#include "dd.h"
#include "exact.h"
#include "sum.h"

/* The image of a point p is (p - origin, 1) times rows 0 to 2 and AT_ORIGIN of
 * m. The difference is exact, so that distance from the world's origin costs
 * nothing; the origin is the eye, or a window's centre. The same map about zero,
 * which is the matrix that is printed, has row AT_ZERO instead.
 *
 * Multiplied out into the stages' parameters, m[i][j] is a sum of products, and
 * sum[i][j] the sum of their magnitudes. Each element is within MAP_BOUND u^2
 * sum[i][j] of its exact value, while none falls below 2^-968. One that may be
 * nothing but rounding errors, at most half of that, is 0. */
enum { AT_ORIGIN = 3, AT_ZERO = 4 };

struct map {
	double origin[3];
	dd m[5][4];
	double sum[5][4];
	bool exact; /* affine, with AT_ORIGIN and AT_ZERO as they were given */
};

/* Four stages and the three products that compose them round an element once
 * each, 7 EX_BOUND; taking it for 0 makes an error of at most as much again. */
#define MAP_BOUND (14 * EX_BOUND)

extern const struct map map_identity;

/* The map about the origin 0 of a matrix for row vectors, whose elements are
 * exact or rounded once. */
struct map map_of(dd m[4][4]);
struct map map_of_doubles(double m[4][4]);

/* map_about: the same map about an origin whose image is 0. map_about_zero: the
 * same about 0, for points whose w need not be 1. */
void map_about(struct map *a, const double origin[3]);
void map_about_zero(struct map *a);

/* First a, then b. Products are summed exactly, each element rounded once. */
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
