/* SPDX-License-Identifier: MIT */
/* Numbers of REAL_BITS bits, for tests. The functions return results of MPFR, so that
 * formulas need no variable for each intermediate result. */
#pragma once

#include <mpfr.h>
#include <stdbool.h>

#include "../exact/ex.h"

/* Numbers from 1e-150 to 1e150 differ by up to 1000 bits, and products of two of their
 * sums by up to 2000. */
enum { REAL_BITS = 3000 };

typedef mpfr_ptr real;

/* Results stay allocated until real_release gives back all that were made since the
 * call of real_mark that returned mark. */
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

/* The angle is in radians or in degrees. cotangent divides it by part. */
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

/* Replaces the upper left 3x3 matrix by its nearest rotation. */
void orthonormalise(real m[4][4]);

/* Returns whether a is 0 but for rounding errors. size is the sum of the magnitudes of
 * the terms that add up to a. */
bool is_zero(real a, real size);

/* Returns |printed - exact| in units in the last place of exact. */
double ulps(double printed, real exact);

/* Returns |got - exact| in units of 2^-106 size. Returns 0 for a difference that the
 * underflow of low parts explains. */
double u2_error(dd got, real exact, double size);
