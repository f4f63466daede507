/* SPDX-License-Identifier: MIT */
#include "real.h"

#include <stdlib.h>
#include <string.h>

enum { REALS_MAX = 1 << 17 };

/* A bound of the error of low parts that underflow, which lose bits below 2^-1074. */
#define LOW_PART_LOSS 0x1p-1068

static mpfr_t store[REALS_MAX];
static int made, used;

static real new_real(void)
{
	if (used == REALS_MAX)
		abort();
	if (used == made)
		mpfr_init2(store[made++], REAL_BITS);
	return store[used++];
}

int real_mark(void)
{
	return used;
}

void real_release(int mark)
{
	used = mark;
}

#define UNARY(name, type, operation)        \
	real name(type a)                   \
	{                                   \
		real r = new_real();        \
		operation(r, a, MPFR_RNDN); \
		return r;                   \
	}
#define BINARY(name, operation)                \
	real name(real a, real b)              \
	{                                      \
		real r = new_real();           \
		operation(r, a, b, MPFR_RNDN); \
		return r;                      \
	}

UNARY(real_of, double, mpfr_set_d)
UNARY(negative, real, mpfr_neg)
UNARY(magnitude, real, mpfr_abs)
UNARY(root, real, mpfr_sqrt)
BINARY(add, mpfr_add)
BINARY(sub, mpfr_sub)
BINARY(mul, mpfr_mul)
BINARY(divide, mpfr_div)
/* clang-format off */
static UNARY(cube_root, real, mpfr_cbrt)
static UNARY(sine_of, real, mpfr_sin)
static UNARY(cosine_of, real, mpfr_cos)
static UNARY(cotangent_of, real, mpfr_cot)
    /* clang-format on */

    real real_of_ex(ex a)
{
	real r = real_of(0);

	for (int i = a.n - 1; i >= 0; i--) {
		r = mul(r, real_of(0x1p64));
		r = add(r, real_of(0x1p32 * (double)(a.word[i] >> 32)));
		r = add(r, real_of((double)(uint32_t)a.word[i]));
	}
	mpfr_mul_2si(r, r, 64 * a.e, MPFR_RNDN);
	return a.sign < 0 ? negative(r) : r;
}

real real_of_dd(dd a)
{
	return add(real_of(a.hi), real_of(a.lo));
}

static real in_radians(double angle, bool radians, int part)
{
	real pi = new_real();

	mpfr_const_pi(pi, MPFR_RNDN);
	return radians ? divide(real_of(angle), real_of(part)) :
			 divide(mul(real_of(angle), pi), real_of(180.0 * part));
}

real sine(double angle, bool radians)
{
	return sine_of(in_radians(angle, radians, 1));
}

real cosine(double angle, bool radians)
{
	return cosine_of(in_radians(angle, radians, 1));
}

real cotangent(double angle, bool radians, int part)
{
	return cotangent_of(in_radians(angle, radians, part));
}

void set_reals(real r[], int n, const double a[])
{
	for (int i = 0; i < n; i++)
		r[i] = real_of(a == NULL ? 0 : a[i]);
}

void set_matrix(real r[4][4], double m[4][4])
{
	for (int i = 0; i < 4; i++)
		set_reals(r[i], 4, m[i]);
}

void set_identity(real r[4][4])
{
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			r[i][j] = real_of(i == j);
}

/* Returns the cofactor of row i and column j, or 0 if only rounding errors are left of
 * its sum. */
static real cofactor(real m[4][4], int i, int j)
{
	real s = real_of(0), size = real_of(0);

	for (int k = 1; k < 4; k++)
		for (int l = 1; l < 3; l++) {
			int a = (j + k) % 4, b = (j + 1 + (k - 1 + l) % 3) % 4;
			int c = (j + 1 + (k - 1 + 3 - l) % 3) % 4;
			real p = mul(mul(m[(i + 1) % 4][a], m[(i + 2) % 4][b]),
			    m[(i + 3) % 4][c]);

			s = l == 1 ? add(s, p) : sub(s, p);
			size = add(size, magnitude(p));
		}
	if (is_zero(s, size))
		return real_of(0);
	return (i + j) % 2 ? negative(s) : s;
}

void set_inverse(real r[4][4], real m[4][4])
{
	real det = real_of(0), a[4][4];

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			a[j][i] = cofactor(m, i, j);
	for (int j = 0; j < 4; j++)
		det = add(det, mul(m[0][j], a[j][0]));
	for (int i = 0; i < 16; i++)
		r[i / 4][i % 4] = divide(a[i / 4][i % 4], det);
}

real dot(real a[], real b[], int n)
{
	real s = real_of(0);

	for (int i = 0; i < n; i++)
		s = add(s, mul(a[i], b[i]));
	return s;
}

void cross(real a[3], real b[3], real r[3])
{
	r[0] = sub(mul(a[1], b[2]), mul(a[2], b[1]));
	r[1] = sub(mul(a[2], b[0]), mul(a[0], b[2]));
	r[2] = sub(mul(a[0], b[1]), mul(a[1], b[0]));
}

void normalise(real a[], int n)
{
	real length = root(dot(a, a, n));

	for (int i = 0; i < n; i++)
		a[i] = divide(a[i], length);
}

/* Does a step of Newton's iteration from X to its nearest rotation: X becomes (c X +
 * inv(X)' / c) / 2 with c = |det X|^(-1/3) (Higham, "Computing the polar decomposition
 * - with applications", 1986). Returns the sum of the changes of the elements. */
static real polar_step(real x[4][4])
{
	real inverse[4][4], yz[3], change = real_of(0);

	set_inverse(inverse, x);
	cross(x[1], x[2], yz);
	real c = cube_root(magnitude(dot(x[0], yz, 3)));

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			real next = divide(add(divide(x[i][j], c),
					       mul(inverse[j][i], c)),
			    real_of(2));

			change = add(change, magnitude(sub(next, x[i][j])));
			mpfr_set(x[i][j], next, MPFR_RNDN);
		}
	return change;
}

void orthonormalise(real m[4][4])
{
	bool moves = true;

	while (moves) {
		int mark = real_mark();

		moves = mpfr_cmp_d(polar_step(m), 0x1p-1000) > 0;
		real_release(mark);
	}
}

/* The limit is size times 2^-2000. Rounding errors are about size times 2^-REAL_BITS. A
 * product of two numbers from 1e-150 to 1e150 is more than 2^-1994 times any other. */
bool is_zero(real a, real size)
{
	int mark = real_mark();
	real least = new_real();

	mpfr_mul_2si(least, size, -REAL_BITS / 3 * 2, MPFR_RNDN);
	bool zero = mpfr_cmpabs(a, least) <= 0;

	real_release(mark);
	return zero;
}

double ulps(double printed, real exact)
{
	int mark = real_mark();
	real off = magnitude(sub(real_of(printed), exact));
	long e = mpfr_zero_p(exact) ? -1074 : mpfr_get_exp(exact) - 53;

	mpfr_mul_2si(off, off, e > -1074 ? -e : 1074, MPFR_RNDN);
	double r = mpfr_get_d(off, MPFR_RNDN);

	real_release(mark);
	return r;
}

double u2_error(dd got, real exact, double size)
{
	int mark = real_mark();
	real off = magnitude(sub(real_of_dd(got), exact));
	double r = 0;

	if (mpfr_cmp_d(off, LOW_PART_LOSS) > 0)
		r = mpfr_get_d(divide(off, mul(real_of(0x1p-106), real_of(size))),
		    MPFR_RNDN);
	real_release(mark);
	return r;
}
