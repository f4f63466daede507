/* SPDX-License-Identifier: MIT */
/* Vectors of three elements, and homogeneous maps of row vectors between spaces.
 * Rational results are exact. */
#ifndef MAP_H
#define MAP_H

#include <stdbool.h>
#include <stddef.h>

#include "sum.h"

struct sum vec3_dot(const struct sum a[3], const struct sum b[3]);
void vec3_cross(const struct sum a[3], const struct sum b[3], struct sum r[3]);
struct sum vec3_length(const struct sum a[3]);
bool vec3_is_zero(const struct sum a[3]);

/* (p, 1) m / divisor is the image of a point p. The elements of m are as exact as sum.h
 * says; the divisor is exact and positive. A map that is made of given numbers without
 * an angle or a length is exact in both directions. One divisor serves all columns, as
 * most images are quotients of two columns. */
struct map {
	struct sum m[4][4], divisor;
	/* The point that is subtracted from coordinates first: the eye, or a window's
	 * centre. Differences are small where the image needs many digits. */
	double origin[3];
};

void map_identity(struct map *);

/* Makes the map of a matrix of given numbers, with origin 0. */
void map_of_doubles(const double m[4][4], struct map *);

/* Divide the images of the map, or their coordinate j, by d. In map_divide d must be
 * exact. In map_divide_column d can have an error; if it has none, it becomes a factor
 * of the divisor and of the other columns, and the map stays exact. */
void map_divide(struct map *, struct sum d);
void map_divide_column(struct map *, int j, struct sum d);

/* Replaces r by the product r stage, which maps points by r and then by stage. If
 * before, replaces r by the product stage r. */
void map_append(struct map *r, const struct map *stage, bool before);

/* Computes the inverse of a matrix of given numbers. Returns false if the matrix is
 * singular. The inverse of an affine matrix has the matrix's last row as origin. */
bool map_inverse(const double m[4][4], struct map *inverse);

/* Returns the determinant of n rows and n columns of m: those whose bits in the masks
 * rows and columns are 0. Elements of the other columns must be numbers, too. */
struct sum map_minor(int n, const struct sum m[4][4], unsigned rows,
    unsigned columns);

/* Return m[i][j] / divisor, and the double or float nearest to it. */
struct sum map_element(const struct map *, int i, int j);
double map_nearest(const struct map *, int i, int j, bool single);

/* Computes coordinate j of the image of a homogeneous point, times the divisor. */
void map_image(const struct map *, int j, const struct sum p[4], struct sum *);

/* Returns whether the last column is 0 0 0 1. */
bool map_is_affine(const struct map *);

/* The reason why a matrix is refused that must be affine. */
#define NOT_AFFINE                                                    \
	"its last column, as column vectors its last row, is not "    \
	"0 0 0 1; in memory order the translation is numbers 13, 14 " \
	"and 15, and rows stand as \"vectors\" says"

/* Returns whether each element is in the range of doubles. */
bool map_is_finite(const struct map *);

#endif
