/* SPDX-License-Identifier: MIT */
/* Numbers with a bound of their error: sums of products of a scene's parameters, and
 * their rounding to what is printed. */
#ifndef SUM_H
#define SUM_H

#include "exact.h"

/* A value within 2^(error - EX_RANGE) of the exact number; error 0 means that the value is
 * exact. An error comes from an irrational number, or from a quotient that was not put
 * into a map's divisor, and each operation bounds the error of its result.
 *
 * A difference that is not above its error counts as 0. A number that is 0 by its formula is
 * therefore 0, and a number midway between two doubles is rounded to even, although a
 * square root was computed on the way.
 *
 * An operation drops words below 2^-20 of the error. The true error is therefore at most
 * 1 + 2^-19 times the bound. Roots and quotients have relative errors of 2^-703, sines and
 * cosines of 2^-313. They count as 2^-698 and 2^-308, which leaves room for a million
 * operations in a row. */
enum { SUM_ERROR = EX_RANGE - 698, SUM_TRIG_ERROR = EX_RANGE - 308 };

struct sum {
	ex value;
	int error;
};

static inline bool sum_is_exact(const struct sum *a)
{
	return a->error == 0;
}

void sum_set(struct sum *, double exact);
struct sum sum_of_double(double exact);
struct sum sum_diff(double a, double b); /* a - b */

/* Returns the value with a relative error, 0 or one of those above. */
struct sum sum_with_error(ex value, int relative);

/* Returns the same value with an error that is larger by |more|. */
struct sum sum_add_error(struct sum, struct sum more);

struct sum sum_neg(struct sum);
struct sum sum_negated_if(bool, struct sum);
struct sum sum_abs(struct sum);
struct sum sum_add(struct sum, struct sum);
struct sum sum_sub(struct sum, struct sum);
struct sum sum_mul(struct sum, struct sum);
struct sum sum_scale(struct sum, double);
struct sum sum_quotient(struct sum, struct sum);

/* Returns the minor a b - c d. */
struct sum sum_minor(struct sum a, struct sum b, struct sum c, struct sum d);

/* Computes the sum of n <= 4 products a[k] b[k stride]. */
void sum_dot(int n, const struct sum *a, const struct sum *b, int stride,
    struct sum *);

/* Returns the root of a number that is not negative. The root is exact where it has
 * five words or fewer. */
struct sum sum_sqrt(struct sum);

/* Return the sign, -1, 0 or 1, of the sum or of a - b. It is 0 within the error. */
int sum_sign(struct sum);
int sum_compare(struct sum a, struct sum b);

/* Return whether a sum is exact and 0, 1, or a power of two with either sign. A quotient
 * by a power of two is exact. */
bool sum_is_exact_zero(const struct sum *);
bool sum_is_one(const struct sum *);
bool sum_is_power_of_two(const struct sum *);

/* Returns the sum, or exact 0 if the sign of the sum is 0. */
struct sum sum_snap_zero(struct sum);

/* Return the double, or float if single, that is nearest to the sum or to n / d. Ties go
 * to even; a number beyond the range is infinite. */
double sum_double(struct sum);
double sum_ratio(struct sum n, struct sum d);
double sum_nearest(const struct sum *n, const struct sum *d, bool single);

/* Returns sum_ratio, or nan where d is 0 or the ratio is beyond the range. */
double sum_ratio_or_nan(struct sum n, struct sum d);

/* Returns the sum as ex_round does: within EX_BOUND u^2 of its value. */
dd sum_dd(struct sum);

/* Returns an upper bound of the error. */
double sum_error(const struct sum *);

/* Returns a lower bound of the error of n / d, where d is exact. */
double sum_least_error(const struct sum *n, const struct sum *d);

#endif
