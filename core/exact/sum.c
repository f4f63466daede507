/* SPDX-License-Identifier: MIT */
#include "sum.h"

#include <limits.h>

/* The number of words of a quotient that decide its rounding. The highest word can be
 * as small as 1; ex_divide sets the last bit if the quotient is not exact. */
enum { ROUNDED_WORDS = 2 };

const struct sum sum_one = { .value = { 1, 1, 0, { 1 } } };
const struct sum sum_minus_one = { .value = { -1, 1, 0, { 1 } } };
static const struct sum two = { .value = { 1, 1, 0, { 2 } } };

/* Returns the least e with |a| <= 2^e, or a number below -EX_RANGE / 2 if a is 0. */
static int ceil_log2(const ex *a)
{
	uint64_t lowest = a->word[0];

	return ex_exponent(a) - (a->n == 1 && (lowest & (lowest - 1)) == 0);
}

/* Returns a bound of the sum of n <= 15 errors, all in the form of `error` of struct
 * sum. The factor 1 + 2^-19 of sum.h covers errors up to 2^-40 of the largest. */
static int add_errors(int n, const int error[])
{
	int most = EX_RANGE / 2, terms = 0, e = 0;

	for (int i = 0; i < n; i++)
		most = error[i] > most ? error[i] : most;
	for (int i = 0; i < n; i++)
		terms += error[i] > most - 40;
	while (1 << e < terms)
		e++;
	return most > EX_RANGE / 2 ? most + e : 0;
}

void sum_set(struct sum *r, double exact)
{
	ex_set(&r->value, exact);
	r->error = 0;
}

void sum_copy(struct sum *r, const struct sum *a)
{
	r->value.sign = a->value.sign;
	r->value.n = a->value.n;
	r->value.e = a->value.e;
	r->error = a->error;
	for (int i = 0; i < a->value.n; i++)
		r->value.word[i] = a->value.word[i];
}

struct sum sum_of_double(double exact)
{
	struct sum r;

	sum_set(&r, exact);
	return r;
}

struct sum sum_difference(double a, double b)
{
	return sum_sub(sum_of_double(a), sum_of_double(b));
}

struct sum sum_of_power(int e)
{
	return (struct sum){ .value = ex_power(e) };
}

struct sum sum_with_error_at(const struct sum *a, int relative_error)
{
	const int error = ceil_log2(&a->value) + relative_error;
	struct sum r;

	sum_copy(&r, a);
	r.error = add_errors(1, &error);
	return r;
}

struct sum sum_truncate_at(const struct sum *a, int n)
{
	struct sum r = { .error = 0 };

	ex_truncate(&a->value, n, &r.value);
	return r;
}

struct sum sum_add_error_at(const struct sum *a, const struct sum *e)
{
	struct sum r;

	sum_copy(&r, a);
	r.error = add_errors(3,
	    (int[]){ a->error, ceil_log2(&e->value) + EX_RANGE, e->error });
	return r;
}

struct sum sum_negated_if_at(bool negates, const struct sum *a)
{
	struct sum r;

	sum_copy(&r, a);
	r.value.sign = negates ? -r.value.sign : r.value.sign;
	return r;
}

struct sum sum_abs_at(const struct sum *a)
{
	return sum_negated_if(a->value.sign < 0, *a);
}

bool sum_is_exact_zero(const struct sum *a)
{
	return a->value.n == 0 && sum_is_exact(a);
}

/* Computes the sum of the n <= 5 products *a[k] *b[k]. The error of a product is |a|
 * times the error of b, plus |b| times the error of a, plus the product of both errors.
 * Words below 2^-20 of the sum's error are dropped. */
static void dot_of_pointers(int n, const struct sum *const a[],
    const struct sum *const b[], struct sum *r)
{
	const ex *x[5], *y[5];
	int error[3 * 5], terms = 0;

	for (int k = 0; k < n; k++) {
		x[k] = &a[k]->value;
		y[k] = &b[k]->value;
		if (sum_is_exact(a[k]) && sum_is_exact(b[k]))
			continue;
		error[terms++] = ceil_log2(x[k]) + b[k]->error;
		error[terms++] = ceil_log2(y[k]) + a[k]->error;
		error[terms++] = a[k]->error + b[k]->error - EX_RANGE;
	}
	int bound = add_errors(terms, error);

	ex_dot(n, x, y, bound - EX_RANGE - 21, &r->value);
	r->error = bound;
}

void sum_dot(int n, const struct sum *a, const struct sum *b, int stride, struct sum *r)
{
	const struct sum *x[5], *y[5];

	for (int k = 0; k < n; k++) {
		x[k] = &a[k];
		y[k] = &b[k * stride];
	}
	dot_of_pointers(n, x, y, r);
}

struct sum sum_of_products(const struct sum *a, const struct sum *b,
    const struct sum *c, const struct sum *d)
{
	struct sum r;

	dot_of_pointers(2, (const struct sum *[]){ a, c },
	    (const struct sum *[]){ b, d }, &r);
	return r;
}

struct sum sum_mul_at(const struct sum *a, const struct sum *b)
{
	struct sum r;

	sum_dot(1, a, b, 1, &r);
	return r;
}

struct sum sum_scale_at(const struct sum *a, double factor)
{
	struct sum b;

	sum_set(&b, factor);
	return sum_mul(*a, b);
}

struct sum sum_minor_at(const struct sum *a, const struct sum *b, const struct sum *c,
    const struct sum *d)
{
	struct sum minus_c;

	sum_copy(&minus_c, c);
	minus_c.value.sign = -minus_c.value.sign;
	return sum_of_products(a, b, &minus_c, d);
}

bool sum_is_one(const struct sum *a)
{
	return sum_is_exact(a) && a->value.sign == 1 && a->value.n == 1 &&
	    a->value.e == 0 && a->value.word[0] == 1;
}

bool sum_is_power_of_two(const struct sum *a)
{
	return sum_is_exact(a) && ceil_log2(&a->value) < ex_exponent(&a->value);
}

/* Returns how many words, of which the first can be as small as 1, a quotient or a root
 * of a needs, so that the others are below 2^-20 of its error. */
static int words_needed(const struct sum *a)
{
	int bits = ceil_log2(&a->value) + EX_RANGE - a->error;
	int words = (bits + 20 + 63) / 64 + 1;

	return sum_is_exact(a) || words > EX_QUOTIENT_WORDS ? EX_QUOTIENT_WORDS :
	    words < EX_MIN_WORDS                            ? EX_MIN_WORDS :
							      words;
}

struct sum sum_quotient_at(const struct sum *a, const struct sum *b)
{
	/* 2^d bounds |b| from below; an error of b above 2^(d-40) halves this bound */
	int d = ex_exponent(&b->value) - 1;
	struct sum r;

	if (sum_is_exact_zero(a))
		return *a;
	if (sum_is_power_of_two(b)) {
		r = sum_of_power(-d);
		r.value.sign = b->value.sign;
		sum_dot(1, a, &r, 1, &r);
		return r;
	}
	d -= b->error - EX_RANGE > d - 40;
	int words = words_needed(a), most = words_needed(b);
	bool exact = ex_divide(&a->value, &b->value, words < most ? words : most,
	    &r.value);
	int size = ceil_log2(&r.value);

	r.error = add_errors(3,
	    (int[]){ a->error - d, size + b->error - d,
		exact ? 0 : size + SUM_QUOTIENT_ERROR });
	return r;
}

struct sum sum_sqrt_at(const struct sum *a)
{
	struct sum r = { .error = 0 };

	/* if the value is <= 0, the exact root is at most the root of a's error */
	if (a->value.sign <= 0) {
		r.error = sum_is_exact(a) ? 0 : (a->error + EX_RANGE) / 2 + 1;
		return r;
	}
	if (!ex_sqrt(&a->value, words_needed(a), &r.value) || !sum_is_exact(a))
		r.error = add_errors(2,
		    (int[]){ ceil_log2(&r.value) + SUM_QUOTIENT_ERROR,
			a->error - ex_exponent(&r.value) + 1 });
	return r;
}

/* Returns whether |value| is not above the error. */
static bool counts_as_zero(const struct sum *a)
{
	return ceil_log2(&a->value) + EX_RANGE <= a->error;
}

int sum_sign_at(const struct sum *a)
{
	return counts_as_zero(a) ? 0 : a->value.sign;
}

int sum_compare_at(const struct sum *a, const struct sum *b)
{
	return sum_sign(sum_sub(*a, *b));
}

struct sum sum_snap_zero_at(const struct sum *a)
{
	return counts_as_zero(a) ? sum_of_double(0) : *a;
}

/* Returns the double or, if single, float next to a: toward 0 unless `away` is set. */
static double neighbour(double a, bool away, bool single)
{
	double to = away ? copysign(HUGE_VAL, a) : 0;

	return single ? (double)nextafterf((float)a, (float)to) : nextafter(a, to);
}

/* Returns the double or, if single, the float nearest to n / d, where n and d have
 * errors. q is the quotient of their values; it lies between the neighbours `near` and
 * `other`. If errors could move q across the midpoint of these two, the sign of n -
 * midpoint d decides. If this difference is within its error, it is a tie. */
static double round_inexact(const struct sum *n, const struct sum *d, const ex *q,
    bool single)
{
	const double near = ex_nearest(q, single);
	const int small = EX_RANGE - 62; /* changes q by less than 2^-8 ulp */
	struct sum minus_near, minus_other, rest;

	if (!isfinite(near) ||
	    (n->error <= ceil_log2(&n->value) + small &&
		d->error <= ceil_log2(&d->value) + small &&
		!ex_is_near_midpoint(q, single)))
		return near;
	sum_set(&minus_near, -near);
	ex_dot(2, (const ex *[]){ q, &minus_near.value },
	    (const ex *[]){ &sum_one.value, &sum_one.value }, INT_MIN, &rest.value);
	int side = rest.value.sign * q->sign;

	if (side == 0)
		return near;
	double other = neighbour(near == 0 ? copysign(0, q->sign) : near, side > 0,
	    single);

	sum_set(&minus_other, -other);
	/* rest is 2 (n - midpoint d) */
	dot_of_pointers(3, (const struct sum *[]){ n, d, d },
	    (const struct sum *[]){ &two, &minus_near, &minus_other }, &rest);
	if (counts_as_zero(&rest)) /* a tie goes to even */
		return fmod(near, 2 * (other - near)) == 0 ? near : other;
	bool beyond = rest.value.sign * d->value.sign == q->sign;

	return beyond == (side > 0) ? other : near;
}

double sum_ratio_nearest(const struct sum *n, const struct sum *d, bool single)
{
	ex quotient;
	const ex *q = &quotient;

	if (counts_as_zero(n))
		return 0;
	if (sum_is_one(d))
		q = &n->value;
	else
		ex_divide(&n->value, &d->value, ROUNDED_WORDS, &quotient);
	return sum_is_exact(n) && sum_is_exact(d) ? ex_nearest(q, single) :
						    round_inexact(n, d, q, single);
}

double sum_ratio_or_nan_at(const struct sum *n, const struct sum *d)
{
	double q = sum_ratio_nearest(n, d, false);

	return isfinite(q) ? q : (double)NAN;
}

dd sum_dd_at(const struct sum *a)
{
	return counts_as_zero(a) ? (dd){ 0, 0 } : ex_round(&a->value);
}

double sum_error(const struct sum *a)
{
	int e = a->error - EX_RANGE;

	return sum_is_exact(a) ? 0 : ldexp(1, e < -1022 ? -1022 : e);
}

double sum_least_error(const struct sum *n, const struct sum *d)
{
	int e = n->error - EX_RANGE - ceil_log2(&d->value);

	return ldexp(1, e) * (1 - 0x1p-50);
}
