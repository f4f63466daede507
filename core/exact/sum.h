/* SPDX-License-Identifier: MIT */
/* A number that is a sum of products of a scene's parameters, exactly or all
 * but exactly, and its rounding to what is printed. */
#ifndef SUM_H
#define SUM_H

#include "exact.h"

/* m 2^e with 1/2 <= m < 1, or 0: never too small or large for a double. */
struct magnitude {
	double m;
	int e;
};

/* Where size is 0 the value is exact. Otherwise an irrational number is in it, or a
 * quotient that was not left to a map's divisor; multiplied out into the parameters
 * it is a sum of terms, of which those that are not exact have magnitudes that sum
 * to size. It is within 2^-250 size, and a difference of at most 2^-190 size from
 * anything is taken for none: so what is 0 by its formula is 0, and what lies midway
 * between two doubles is rounded to even, although a square root was on the way. */
struct sum {
	ex value;
	struct magnitude size;
};

struct sum sum_of(ex exact);
struct sum sum_of_double(double exact);
struct sum sum_diff(double a, double b); /* a - b */

/* Something within 2^-319 of itself. */
struct sum sum_inexact(ex value);

struct sum sum_neg(struct sum);
struct sum sum_negated_if(bool, struct sum);
struct sum sum_abs(struct sum);
struct sum sum_add(struct sum, struct sum);
struct sum sum_sub(struct sum, struct sum);
struct sum sum_mul(struct sum, struct sum);
struct sum sum_scale(struct sum, double);
struct sum sum_quotient(struct sum, struct sum);

/* a b - c d */
struct sum sum_minor(struct sum a, struct sum b, struct sum c, struct sum d);

/* The sum of n <= 4 products. */
void sum_dot(int n, const struct sum *const a[], const struct sum *const b[],
    struct sum *);

/* Of something not negative; exact where the root is short. */
struct sum sum_sqrt(struct sum);

/* -1, 0 or 1; and the sign of a - b. */
int sum_sign(struct sum);
int sum_compare(struct sum a, struct sum b);

/* What counts for nothing in any sum; 1, exactly; and that by which anything is
 * divided exactly, however many digits it has. */
bool sum_is_nothing(const struct sum *);
bool sum_is_one(const struct sum *);
bool sum_is_power_of_two(const struct sum *);

/* The same, or exactly 0 where that is its sign. */
struct sum sum_settled(struct sum);

/* The nearest double or float, ties to even; infinite beyond their range: of n / d,
 * and so on. */
double sum_double(struct sum);
double sum_nearest(const struct sum *n, const struct sum *d, bool single);
double sum_over(struct sum n, struct sum d);
float sum_over_float(struct sum n, struct sum d);

/* sum_over; nan where that is infinite, or none. */
double sum_over_or_nan(struct sum n, struct sum d);

/* Within EX_BOUND u^2, as ex_round. */
dd sum_dd(struct sum);

/* An upper bound of |value| and size, in doubles. */
double sum_most(struct sum);

/* So much of n / d, where d is exact, is none, or half of it, in doubles. */
double sum_surely_none(const struct sum *n, const struct sum *d);

#endif
