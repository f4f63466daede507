/* SPDX-License-Identifier: MIT */
/* The loop of plain.c in types that are wider than double. The points are doubles, and
 * an image is rounded to doubles at its end, so that only what lies between costs more.
 */
#include <float.h>
#include <math.h>
#include <mpfr.h>

#include "peer.h"

#if defined(__AVX512F__) && !defined(__clang__)
#pragma GCC target("prefer-vector-width=512")
#endif

/* Declares x, y, z and p, q, r as columns of in and out. */
#define COLUMNS_OF(in, out)                                                      \
	const double *restrict x = in, *y = x + PEER_BLOCK, *z = y + PEER_BLOCK; \
	double *restrict p = out, *q = p + PEER_BLOCK, *r = q + PEER_BLOCK

static long double matrix[4][4];

static void prepare_long(const struct view *v)
{
	for (int i = 0; i < 16; i++)
		matrix[i / 4][i % 4] = (long double)v->matrix[i / 4][i % 4] +
		    (long double)v->matrix_rest[0][i / 4][i % 4];
}

static void carry_long(const void *in, void *out, size_t n)
{
	COLUMNS_OF(in, out);

	for (size_t i = 0; i < n; i++) {
		long double image[4];

		for (int k = 0; k < 4; k++)
			image[k] = matrix[k][0] * (long double)x[i] +
			    matrix[k][1] * (long double)y[i] +
			    matrix[k][2] * (long double)z[i] + matrix[k][3];
		image[3] = 1 / image[3];
		p[i] = (double)(image[0] * image[3]);
		q[i] = (double)(image[1] * image[3]);
		r[i] = (double)(image[2] * image[3]);
	}
}

/* Double-double: a number is the sum of two doubles, of which the first is the double
 * nearest to it. The compiler must not contract these sums and products. */
struct double_double {
	double high, low;
};

static struct double_double dd_matrix[4][4];

static void prepare_dd(const struct view *v)
{
	for (int i = 0; i < 16; i++)
		dd_matrix[i / 4][i % 4] = (struct double_double){
			v->matrix[i / 4][i % 4], v->matrix_rest[0][i / 4][i % 4]
		};
}

/* Knuth's TwoSum. */
static inline struct double_double dd_two_sum(double a, double b)
{
	double sum = a + b, part = sum - a;

	return (struct double_double){ sum, (a - (sum - part)) + (b - part) };
}

/* Dekker's Fast2Sum, for |a| >= |b|. */
static inline struct double_double dd_quick_sum(double a, double b)
{
	double sum = a + b;

	return (struct double_double){ sum, b - (sum - a) };
}

/* The accurate sum of libqd, with a relative error below 2^-104 even if a and b cancel.
 */
static inline struct double_double dd_add(struct double_double a,
    struct double_double b)
{
	struct double_double s = dd_two_sum(a.high, b.high),
			     t = dd_two_sum(a.low, b.low);

	s = dd_quick_sum(s.high, s.low + t.high);
	return dd_quick_sum(s.high, s.low + t.low);
}

static inline struct double_double dd_scale(struct double_double a, double b)
{
	double product = a.high * b;

	return dd_quick_sum(product, fma(a.high, b, -product) + a.low * b);
}

static inline struct double_double dd_mul(struct double_double a,
    struct double_double b)
{
	double product = a.high * b.high;

	return dd_quick_sum(product,
	    fma(a.high, b.high, -product) + (a.high * b.low + a.low * b.high));
}

/* One step of Newton's method from the nearest double. */
static inline struct double_double dd_inverse(struct double_double a)
{
	double nearest = 1 / a.high;
	double rest = fma(-nearest, a.high, 1) - nearest * a.low;

	return dd_quick_sum(nearest, nearest * rest);
}

static inline struct double_double dd_row(const struct double_double m[4], double x,
    double y, double z)
{
	return dd_add(dd_add(dd_scale(m[0], x), dd_scale(m[1], y)),
	    dd_add(dd_scale(m[2], z), m[3]));
}

static void carry_dd(const void *in, void *out, size_t n)
{
	COLUMNS_OF(in, out);
	struct double_double m[4][4];

	/* In a copy the compiler sees that the loop does not write to it. */
	for (int i = 0; i < 16; i++)
		m[i / 4][i % 4] = dd_matrix[i / 4][i % 4];
	for (size_t i = 0; i < n; i++) {
		struct double_double w = dd_inverse(dd_row(m[3], x[i], y[i], z[i]));

		p[i] = dd_mul(dd_row(m[0], x[i], y[i], z[i]), w).high;
		q[i] = dd_mul(dd_row(m[1], x[i], y[i], z[i]), w).high;
		r[i] = dd_mul(dd_row(m[2], x[i], y[i], z[i]), w).high;
	}
}

/* The precision of a quadruple. MPFR has shortcuts for numbers of two words. */
enum { MPFR_BITS = 113 };

static mpfr_t mpfr_matrix[4][4], mpfr_point[3], mpfr_image[4], mpfr_term;

static void prepare_mpfr(const struct view *v)
{
	static bool made;

	for (int i = 0; i < 16 && !made; i++)
		mpfr_init2(mpfr_matrix[i / 4][i % 4], MPFR_BITS);
	for (int i = 0; i < 4 && !made; i++) {
		mpfr_init2(mpfr_image[i], MPFR_BITS);
		mpfr_init2(i < 3 ? mpfr_point[i] : mpfr_term, MPFR_BITS);
	}
	made = true;
	for (int i = 0; i < 16; i++) {
		mpfr_ptr entry = mpfr_matrix[i / 4][i % 4];

		mpfr_set_d(entry, v->matrix_rest[1][i / 4][i % 4], MPFR_RNDN);
		mpfr_add_d(entry, entry, v->matrix_rest[0][i / 4][i % 4], MPFR_RNDN);
		mpfr_add_d(entry, entry, v->matrix[i / 4][i % 4], MPFR_RNDN);
	}
}

static void carry_mpfr(const void *in, void *out, size_t n)
{
	const double *from = in;
	double *to = out;

	for (size_t i = 0; i < n; i++) {
		for (size_t j = 0; j < 3; j++)
			mpfr_set_d(mpfr_point[j], from[j * PEER_BLOCK + i], MPFR_RNDN);
		for (size_t k = 0; k < 4; k++) {
			mpfr_ptr sum = mpfr_image[k];

			mpfr_mul(sum, mpfr_matrix[k][0], mpfr_point[0], MPFR_RNDN);
			for (size_t j = 1; j < 3; j++) {
				mpfr_mul(mpfr_term, mpfr_matrix[k][j], mpfr_point[j],
				    MPFR_RNDN);
				mpfr_add(sum, sum, mpfr_term, MPFR_RNDN);
			}
			mpfr_add(sum, sum, mpfr_matrix[k][3], MPFR_RNDN);
		}
		mpfr_ui_div(mpfr_image[3], 1, mpfr_image[3], MPFR_RNDN);
		for (size_t k = 0; k < 3; k++) {
			mpfr_mul(mpfr_image[k], mpfr_image[k], mpfr_image[3],
			    MPFR_RNDN);
			to[k * PEER_BLOCK + i] = mpfr_get_d(mpfr_image[k], MPFR_RNDN);
		}
	}
}

const struct peer peers_wide[] = {
/* Some processors have no long double of their own; it is a double there. */
#if LDBL_MANT_DIG > DBL_MANT_DIG
	{ "loop, long double", NULL, false, { COLUMNS }, prepare_long, carry_long,
	    NULL },
#endif
	{ "loop, double-double", NULL, false, { COLUMNS }, prepare_dd, carry_dd, NULL },
	{ "MPFR, 113 bits", MPFR_VERSION_STRING, false, { COLUMNS }, prepare_mpfr,
	    carry_mpfr, NULL },
	{ 0 },
};
