/* SPDX-License-Identifier: MIT */
/* Numbers with a bound of their error. Maps, and the images of points that the kernels
 * cannot round, are computed as such numbers, and then rounded to nearest doubles. */
#pragma once

#include "ex.h"

/* The value is exact if error is 0. If not, it is within 2^(error - EX_RANGE) of the
 * exact number. Sines, cosines, roots and most quotients have errors. Each operation
 * bounds the error of its result.
 *
 * A number whose magnitude is not above its error counts as 0. So a result that has
 * come from roots can still be found to be 0, or a tie between two doubles. */
struct sum {
	union {
		struct {
			ex value;
			int error;
		};
		char at[1]; /* see SUM_AT */
	};
};

/* Returns the address of a sum, which may be the result of a call: C keeps it to the
 * end of the expression. So calls nest without copies of 900 bytes. */
#define SUM_AT(a) ((const struct sum *)(a).at)

/* Each operation drops words below 2^-20 of the bound of its error: the bound is then
 * too small, by a factor of up to 1 + 2^-19, or 2^5 after a million operations in a
 * row. So bounds begin 2^5 times as large as the relative error: 2^-698 for roots and
 * quotients (error 2^-703), and 2^-309 for sines and cosines (error 2^-314). */
enum { SUM_QUOTIENT_ERROR = EX_RANGE - 698, SUM_TRIG_ERROR = EX_RANGE - 309 };

static inline bool sum_is_exact(const struct sum *a)
{
	return a->error == 0;
}

extern const struct sum sum_one, sum_minus_one; /* 1 and -1 */

void sum_set(struct sum *, double exact);

/* Copies a sum: only the words that it has, where an assignment copies 900 bytes. */
void sum_copy(struct sum *, const struct sum *);

struct sum sum_of_double(double exact);
struct sum sum_difference(double a, double b); /* a - b */
struct sum sum_of_power(int e);                /* 2^e */

/* Returns the value of a sum with another error, SUM_*_ERROR relative to the value. */
struct sum sum_with_error_at(const struct sum *, int relative_error);

/* Returns the n highest words of the value of a sum, as an exact number. */
struct sum sum_truncate_at(const struct sum *, int n);

/* Returns `a` with the bound of its error increased by |e|. */
struct sum sum_add_error_at(const struct sum *a, const struct sum *e);

struct sum sum_negated_if_at(bool, const struct sum *);
struct sum sum_abs_at(const struct sum *);
struct sum sum_mul_at(const struct sum *, const struct sum *);
struct sum sum_scale_at(const struct sum *, double factor);
struct sum sum_quotient_at(const struct sum *, const struct sum *);

/* Return a b + c d, and the minor a b - c d. */
struct sum sum_of_products(const struct sum *a, const struct sum *b,
    const struct sum *c, const struct sum *d);
struct sum sum_minor_at(const struct sum *a, const struct sum *b, const struct sum *c,
    const struct sum *d);

/* Computes the sum of the n <= 5 products a[k] b[k * stride]. */
void sum_dot(int n, const struct sum *a, const struct sum *b, int stride, struct sum *);

/* Returns the root of a number >= 0. It is exact if five words can hold it. */
struct sum sum_sqrt_at(const struct sum *);

/* Return the sign, -1, 0 or 1, of a sum or of a - b. The sign of a number is 0 if its
 * magnitude is not above its error. */
int sum_sign_at(const struct sum *);
int sum_compare_at(const struct sum *a, const struct sum *b);

/* Return whether a sum is exact and is 0, is 1, or is plus or minus a power of two.
 * sum_quotient divides by powers of two exactly. */
bool sum_is_exact_zero(const struct sum *);
bool sum_is_one(const struct sum *);
bool sum_is_power_of_two(const struct sum *);

/* Returns the sum, or exact 0 if the sign of the sum is 0. */
struct sum sum_snap_zero_at(const struct sum *);

/* Returns the double or, if single, the float nearest to n / d. Ties go to even; a
 * number beyond the range becomes infinite. sum_ratio and sum_double, which are macros
 * below, return the double nearest to n / d and to a sum. */
double sum_ratio_nearest(const struct sum *n, const struct sum *d, bool single);

/* Returns the double nearest to n / d, or nan if d is 0 or n / d is beyond the
 * range. */
double sum_ratio_or_nan_at(const struct sum *n, const struct sum *d);

/* Returns the value, rounded by ex_round, or 0 if the sign of the sum is 0. */
dd sum_dd_at(const struct sum *);

/* Returns an upper bound of the error of a sum. */
double sum_error(const struct sum *);

/* Returns a lower bound of e / |d|, where e bounds the error of n, and d is exact. */
double sum_least_error(const struct sum *n, const struct sum *d);

/* Of a function whose name ends in _at callers use the macro without the ending: its
 * operands are the sums themselves, not their addresses. */
#define sum_add_error(a, b) sum_add_error_at(SUM_AT(a), SUM_AT(b))
#define sum_with_error(a, b) sum_with_error_at(SUM_AT(a), b)
#define sum_truncate(a, b) sum_truncate_at(SUM_AT(a), b)
#define sum_neg(a) sum_negated_if(true, a)
#define sum_negated_if(a, b) sum_negated_if_at(a, SUM_AT(b))
#define sum_abs(a) sum_abs_at(SUM_AT(a))
#define sum_add(a, b) sum_of_products(SUM_AT(a), &sum_one, SUM_AT(b), &sum_one)
#define sum_sub(a, b) sum_of_products(SUM_AT(a), &sum_one, SUM_AT(b), &sum_minus_one)
#define sum_mul(a, b) sum_mul_at(SUM_AT(a), SUM_AT(b))
#define sum_scale(a, b) sum_scale_at(SUM_AT(a), b)
#define sum_quotient(a, b) sum_quotient_at(SUM_AT(a), SUM_AT(b))
#define sum_minor(a, b, c, d) sum_minor_at(SUM_AT(a), SUM_AT(b), SUM_AT(c), SUM_AT(d))
#define sum_sqrt(a) sum_sqrt_at(SUM_AT(a))
#define sum_sign(a) sum_sign_at(SUM_AT(a))
#define sum_compare(a, b) sum_compare_at(SUM_AT(a), SUM_AT(b))
#define sum_snap_zero(a) sum_snap_zero_at(SUM_AT(a))
#define sum_double(a) sum_ratio(a, sum_one)
#define sum_ratio(a, b) sum_ratio_nearest(SUM_AT(a), SUM_AT(b), false)
#define sum_ratio_or_nan(a, b) sum_ratio_or_nan_at(SUM_AT(a), SUM_AT(b))
#define sum_dd(a) sum_dd_at(SUM_AT(a))
