/* SPDX-License-Identifier: MIT */
/* Numbers of thousands of bits, for tests: MPFR's, without naming every
 * intermediate. Link with -lmpfr -lgmp. */
#ifndef REAL_H
#define REAL_H

#include <mpfr.h>
#include <stdbool.h>

#include "../exact/exact.h"

/* Magnitudes from 1e-150 to 1e150 differ by 1000 bits, products of two such
 * sums by twice as many. */
enum { REAL_BITS = 3000 };

typedef mpfr_ptr real;

/* Results lie in one store, until it is given back down to a mark. */
int real_mark(void);
void real_release(int mark);

real real_of(double a);
real real_of_ex(ex a);
real real_of_dd(dd a);
real add(real a, real b);
real sub(real a, real b);
real mul(real a, real b);
real divide(real a, real b);
real negative(real a);
real magnitude(real a);
real root(real a);

/* Returns the cotangent of angle / part, for an angle in degrees or radians. */
real sine(double angle, bool radians);
real cosine(double angle, bool radians);
real cotangent(double angle, bool radians, int part);

void set_reals(real r[], int n, const double a[]); /* NULL: zeros */
void set_matrix(real r[4][4], double m[4][4]);
void set_identity(real r[4][4]);
void set_inverse(real r[4][4], real m[4][4]);

real dot(real a[], real b[], int n);
void cross(real a[3], real b[3], real r[3]);
void normalise(real a[], int n);

/* Replaces the upper 3x3 by its nearest rotation. */
void orthonormalise(real m[4][4]);

/* Returns whether a is 0 but for rounding errors in a sum of that size. */
bool is_zero(real a, real size);

/* Returns |printed - exact| in units in the last place of exact. */
double ulps(double printed, real exact);

/* Returns |got - exact| in units of 2^-106 size, less what low parts lost below
 * 2^-1074 explain. */
double u2_error(dd got, real exact, double size);

#endif
