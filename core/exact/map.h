/* SPDX-License-Identifier: MIT */
/* Homogeneous maps of row vectors between spaces, exact where they are rational. */
#ifndef MAT_H
#define MAT_H

#include <stdbool.h>
#include <stddef.h>

#include "sum.h"

/* Vectors of three. */
struct sum vec3_dot(const struct sum a[3], const struct sum b[3]);
void vec3_cross(const struct sum a[3], const struct sum b[3], struct sum r[3]);
struct sum vec3_length(const struct sum a[3]);
bool vec3_is_zero(const struct sum a[3]);

/* (p, 1) m / divisor is the image of a point p. The elements of m are as exact as
 * sum.h says, and the divisor is exact and positive: a map that is made of given
 * numbers without an angle or a length is exact in either direction. One divisor
 * serves all columns, as most images are quotients of two of them. */
struct map {
	struct sum m[4][4], divisor;
	/* From where points are best seen: the eye, a window's centre. Their
	 * differences from it are small where the image is exact to many
	 * digits. */
	double origin[3];
};

void map_identity(struct map *);

/* Of a matrix of given numbers; the origin is 0. */
void map_of_doubles(const double m[4][4], struct map *);

/* Divides by an exact number; or a column by any, which goes into the divisor where it
 * is exact. */
void map_over(struct map *, struct sum d);
void map_column_over(struct map *, int j, struct sum d);

/* First a, then b, into another map. */
void map_then(const struct map *a, const struct map *b, struct map *r);

/* The inverse of a matrix of given numbers. Returns false where it is singular.
 * An affine one (last column 0 0 0 1) gets its last row as origin. */
bool map_inverse(const double m[4][4], struct map *inverse);

/* Determinant of the n rows and columns of m that are not struck out. */
struct sum map_minor(int n, const struct sum m[4][4], unsigned rows,
    unsigned columns);

/* An element of the matrix, divided; and its nearest double or float. */
struct sum map_element(const struct map *, int i, int j);
double map_nearest(const struct map *, int i, int j, bool single);

/* Column j of the image of a homogeneous point, times the divisor. */
void map_column(const struct map *, int j, const struct sum p[4], struct sum *);

/* Whether the last column is 0 0 0 1. */
bool map_is_affine(const struct map *);

/* Why a map that is not affine is refused where it must be. */
#define NOT_AFFINE                                                    \
	"its last column, as column vectors its last row, is not "    \
	"0 0 0 1; in memory order the translation is numbers 13, 14 " \
	"and 15, and rows stand as \"vectors\" says"

/* Whether each element is in the range of doubles. */
bool map_is_finite(const struct map *);

#endif
