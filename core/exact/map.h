/* SPDX-License-Identifier: MIT */
/* Vectors of three elements, and maps between spaces, which multiply homogeneous row
 * vectors by a 4x4 matrix. Rational results are exact. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "sum.h"

struct sum vec3_dot(const struct sum a[3], const struct sum b[3]);
void vec3_cross(const struct sum a[3], const struct sum b[3], struct sum r[3]);
struct sum vec3_length(const struct sum a[3]);
void vec3_normalise(struct sum a[3]);
bool vec3_is_zero(const struct sum a[3]);

/* The image of a point p is (p, 1) times the first four rows of m, over the divisor.
 * Elements can have errors; the divisor is positive, and exact unless map_divide was
 * given a d with an error. A map computed without angles and lengths is exact, as is
 * its inverse. One divisor serves all columns: it cancels in most images, which are
 * quotients of two columns.
 *
 * `origin` is the eye or a window's centre. Images of points near it need many digits:
 * transform.h first subtracts the origin from points. Row 4 of m is the origin's image.
 * If the eye is far from 0, the error of row 3 can exceed row 4: map_image, and so
 * map_multiply, use row 4 where its error is smaller. */
struct map {
	struct sum m[5][4], divisor;
	double origin[3];
};

void map_identity(struct map *);
void map_copy(struct map *, const struct map *);

/* Makes the map of a matrix of given numbers, with origin 0. */
void map_of_doubles(const double m[4][4], struct map *);

/* Sets the origin, to 0 if `origin` is NULL, and computes row 4 from the other rows. */
void map_set_origin(struct map *, const double origin[3]);

/* Sets the origin of an affine map to about the point whose image is 0, unless
 * the image of its origin is near 0 already: then images near 0 keep their
 * digits in doubles. */
void map_find_origin(struct map *);

/* map_divide divides the images of the map by d, which must be exact unless the images
 * are quotients of two columns, in which it cancels. map_divide_column divides only
 * coordinate j: if d is a power of two or has an error, it divides column j; if not, it
 * multiplies the other columns and the divisor, which keeps the map exact. */
void map_divide(struct map *, struct sum d);
void map_divide_column(struct map *, int j, struct sum d);

/* Replaces r by r * factor, which maps points by r and then by factor. If `before` is
 * set, replaces r by factor * r. */
void map_multiply(struct map *r, const struct map *factor, bool before);

/* Replaces a map by its inverse, with origin 0. Returns false, and leaves the map as it
 * is, if it is singular. */
bool map_invert(struct map *);

/* Returns the determinant of the n rows and n columns of m whose bits in the masks are
 * 0. Elements of skipped columns are read, too, and must have values. */
struct sum map_minor(int n, const struct sum m[4][4], unsigned skipped_rows,
    unsigned skipped_columns);

/* Return m[i][j] / divisor; map_element_nearest rounds to double or,
 * if single, float. */
struct sum map_element(const struct map *, int i, int j);
double map_element_nearest(const struct map *, int i, int j, bool single);

/* Computes coordinate j of a homogeneous point's image, not divided by the divisor. */
void map_image(const struct map *, int j, const struct sum p[4], struct sum *);

/* Returns whether the last column / divisor is 0 0 0 1. */
bool map_is_affine(const struct map *);

/* Returns whether each element / divisor is in the range of doubles. */
bool map_is_finite(const struct map *);
