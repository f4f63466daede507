/* SPDX-License-Identifier: MIT */
/* Numbers with a bound of their error. Maps, and the images of points that the kernels
 * cannot round, are computed as such numbers, and then rounded to nearest doubles. */
#ifndef SUM_H
#define SUM_H

#include "ex.h"

/* The value is exact if error is 0. If not, it is within 2^(error - EX_RANGE) of the
 * exact number. Sines, cosines, roots and most quotients have errors. Each operation
 * bounds the error of its result.
 *
 * A number whose magnitude is not above its error counts as 0. So a result that has
 * come from roots can still be found to be 0, or a tie between two doubles. */
struct sum {
	ex value;
	int error;
};

/* Each operation drops words below 2^-20 of the bound of its error: the bound is then
 * too small, by a factor of up to 1 + 2^-19, or 2^5 after a million operations in a
 * row. So bounds begin 2^5 times as large as the relative error: 2^-698 for roots and
 * quotients (error 2^-703), and 2^-308 for sines and cosines (error 2^-313). */
enum { SUM_QUOTIENT_ERROR = EX_RANGE - 698, SUM_TRIG_ERROR = EX_RANGE - 308 };

static inline bool sum_is_exact(const struct sum *a)
{
	return a->error == 0;
}

void sum_set(struct sum *, double exact);
struct sum sum_of_double(double exact);
struct sum sum_diff(double a, double b); /* a - b */

/* Returns a struct sum of this value; relative_error is SUM_*_ERROR, or 0 if exact. */
struct sum sum_with_error(ex value, int relative_error);

/* Returns `a` with the bound of its error increased by |e|. */
struct sum sum_add_error(struct sum a, struct sum e);

struct sum sum_neg(struct sum);
struct sum sum_negated_if(bool, struct sum);
struct sum sum_abs(struct sum);
struct sum sum_add(struct sum, struct sum);
struct sum sum_sub(struct sum, struct sum);
struct sum sum_mul(struct sum, struct sum);
struct sum sum_scale(struct sum, double factor);
struct sum sum_quotient(struct sum, struct sum);

/* Returns the minor a b - c d. */
struct sum sum_minor(struct sum a, struct sum b, struct sum c, struct sum d);

/* Computes the sum of the n <= 5 products a[k] b[k * stride]. */
void sum_dot(int n, const struct sum *a, const struct sum *b, int stride,
    struct sum *);

/* Returns the root of a number >= 0. It is exact if five words can hold it. */
struct sum sum_sqrt(struct sum);

/* Return the sign, -1, 0 or 1, of a sum or of a - b. The sign of a number is 0 if its
 * magnitude is not above its error. */
int sum_sign(struct sum);
int sum_compare(struct sum a, struct sum b);

/* Return whether a sum is exact and is 0, is 1, or is plus or minus a power of two.
 * sum_quotient divides by powers of two exactly. */
bool sum_is_exact_zero(const struct sum *);
bool sum_is_one(const struct sum *);
bool sum_is_power_of_two(const struct sum *);

/* Returns the sum, or exact 0 if the sign of the sum is 0. */
struct sum sum_snap_zero(struct sum);

/* Return the double nearest to a sum or to n / d; sum_nearest, if single, the nearest
 * float. Ties go to even; a number beyond the range becomes infinite. */
double sum_double(struct sum);
double sum_ratio(struct sum n, struct sum d);
double sum_nearest(const struct sum *n, const struct sum *d, bool single);

/* Returns sum_ratio, or nan if d is 0 or the ratio is beyond the range. */
double sum_ratio_or_nan(struct sum n, struct sum d);

/* Returns the value, rounded by ex_round, or 0 if the sign of the sum is 0. */
dd sum_dd(struct sum);

/* Returns an upper bound of the error of a sum. */
double sum_error(const struct sum *);

/* Returns a lower bound of e / |d|, where e bounds the error of n, and d is exact. */
double sum_least_error(const struct sum *n, const struct sum *d);

#endif
