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

/* The value is within error of the exact one. Where error is 0 the value is exact.
 * Otherwise an irrational number is in it, or a quotient that was not left to a map's
 * divisor, and each operation bounds what its result is off by. A difference from
 * anything that is not above the error is taken for none: so a number that is 0 by its
 * formula is 0, and one that lies midway between two doubles is rounded to even,
 * although a square root was on the way.
 *
 * An operation rounds its bound by less than 2^-45, and cuts off words that are below
 * 2^-20 of the error: together they make the true error at most 1 + 2^-19 times as
 * large as the bound says. Roots and quotients are within 2^-703 of themselves,
 * sines and cosines within 2^-313, and count as if they were within SUM_ERROR and
 * SUM_TRIG_ERROR: that has room for four million operations in
 * a row. */
#define SUM_ERROR 0x1p-690
#define SUM_TRIG_ERROR 0x1p-300

struct sum {
	ex value;
	struct magnitude error;
};

struct sum sum_of_double(double exact);
struct sum sum_diff(double a, double b); /* a - b */

/* A value that is within so much of itself; and a sum that is off by |by| more. */
struct sum sum_inexact(ex value, double error);
struct sum sum_off_by(struct sum, struct sum by);

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

/* The sum of n <= 4 products a[k] b[step k]. */
void sum_dot(int n, const struct sum *a, const struct sum *b, int step,
    struct sum *);

/* The root of a sum that is not negative; exact where the root is short. */
struct sum sum_sqrt(struct sum);

/* -1, 0 or 1; and the sign of a - b. */
int sum_sign(struct sum);
int sum_compare(struct sum a, struct sum b);

/* Exact zero; exact 1; and an exact power of two, by which every sum is divided
 * without an error. */
bool sum_is_nothing(const struct sum *);
bool sum_is_one(const struct sum *);
bool sum_is_power_of_two(const struct sum *);

/* The sum, or exact zero where its sign is 0. */
struct sum sum_settled(struct sum);

/* The nearest double or float, ties to even; infinite beyond their range: of n / d,
 * and so on. */
double sum_double(struct sum);
double sum_nearest(const struct sum *n, const struct sum *d, bool single);
double sum_over(struct sum n, struct sum d);

/* sum_over; nan where that is infinite, or none. */
double sum_over_or_nan(struct sum n, struct sum d);

/* Within EX_BOUND u^2, as ex_round. */
dd sum_dd(struct sum);

/* An upper bound of the error; and a lower one of the error of n / d, for an exact d. */
double sum_error(const struct sum *);
double sum_least_error(const struct sum *n, const struct sum *d);

#endif
