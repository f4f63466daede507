/* SPDX-License-Identifier: MIT */
/* The form of matrices that types of projections make of their numbers. */
#pragma once

#include "../exact/map.h"

/* The matrix of a projection that is given by parameters:
 *	 s0  0   0   0
 *	 0   s1  0   0
 *	 z0  z1  z2  z3
 *	 t0  t1  t2  t3
 * Its columns are divided by d0, d1, d2 and 1, and the whole matrix by `divisor`.
 * Columns 2 and 3, and the divisor, are exact unless the projection is a volume with a
 * view angle.
 *
 * If row z has errors, images near a plane of constant z may need more digits than t +
 * z row z has. `plane` is then the z of that plane, and `in_plane` the image of 0 0
 * plane 1 in which no error of row z is multiplied by `plane`. A plane of 0 has the
 * image t. */
struct scaled_matrix {
	struct sum s[2], z[4], t[4], d[3], divisor;
	double plane;
	struct sum in_plane[4];
};

/* Sets rows z and t to 0, the divisor to 1, and the plane to 0. */
void scaled_clear(struct scaled_matrix *);

/* Sets s[k] / d[k] to scale / divisor, and the other such quotient so that s[1] / d[1]
 * is aspect[0] / aspect[1] times s[0] / d[0]. */
void scaled_set_sizes(const double aspect[2], int k, struct sum scale, double divisor,
    struct scaled_matrix *);

/* Returns whether x, y and depth of row z are exact: then no plane is needed. Errors of
 * w do not cancel in any plane. */
bool scaled_is_exact(const struct scaled_matrix *);

/* Makes the map of the matrix, whose origin is in its plane or, if `inverse`, of the
 * inverse matrix. */
void scaled_map(const struct scaled_matrix *, bool inverse, struct map *);
