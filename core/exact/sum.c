/* SPDX-License-Identifier: MIT */
#include "sum.h"

#include <limits.h>
#include <string.h>

/* The words of a quotient that is only rounded: one whole word, and one whose last bit
 * is set where the quotient is not exact. */
enum { ROUNDED_WORDS = 2 };

static const struct sum one = { { 1, 1, 0, { 1 } }, { 0, 0 } };
static const struct sum minus_one = { { -1, 1, 0, { 1 } }, { 0, 0 } };

/* Returns m 2^e. m is a product, quotient or sum of a few numbers that are not subnormal,
 * and so not subnormal itself. */
static struct magnitude magnitude_make(double m, int e)
{
	int more;

	m = frexp(m, &more);
	return (struct magnitude){ m, e + more };
}

static struct magnitude magnitude_times(struct magnitude a, struct magnitude b)
{
	return magnitude_make(a.m * b.m, a.e + b.e);
}

static struct magnitude magnitude_plus(struct magnitude a, struct magnitude b)
{
	if (a.m == 0 || b.m == 0)
		return a.m == 0 ? b : a;
	if (a.e < b.e)
		return magnitude_plus(b, a);
	return magnitude_make(a.m +
		(a.e - b.e < 60 ? ldexp(b.m, b.e - a.e) : 0),
	    a.e);
}

static struct magnitude magnitude_over(struct magnitude a, struct magnitude b)
{
	return magnitude_make(a.m / b.m, a.e - b.e);
}

static struct magnitude magnitude_of(const ex *a)
{
	const uint64_t *w = a->word + a->n;

	if (a->n == 0)
		return (struct magnitude){ 0, 0 };
	return magnitude_make((double)w[-1] +
		(a->n > 1 ? 0x1p-64 * (double)w[-2] : 0),
	    64 * (a->e + a->n - 1));
}

/* Returns the index of a word below which all words are less than 2^-20 of the error,
 * which is at least 2^(e - 1). */
static int lowest_word(struct magnitude error)
{
	int e = error.e - 21;

	return error.m > 0 ? ex_word_index(e) : INT_MIN;
}

struct sum sum_of_double(double exact)
{
	struct sum r;

	ex_set(&r.value, exact);
	r.error = (struct magnitude){ 0, 0 };
	return r;
}

struct sum sum_diff(double a, double b)
{
	return sum_sub(sum_of_double(a), sum_of_double(b));
}

struct sum sum_with_error(ex value, double error)
{
	return (struct sum){ value,
		magnitude_times(magnitude_of(&value),
		    magnitude_make(error, 0)) };
}

struct sum sum_add_error(struct sum a, struct sum more)
{
	a.error = magnitude_plus(a.error,
	    magnitude_plus(magnitude_of(&more.value), more.error));
	return a;
}

struct sum sum_neg(struct sum a)
{
	a.value = ex_neg(a.value);
	return a;
}

struct sum sum_negated_if(bool yes, struct sum a)
{
	return yes ? sum_neg(a) : a;
}

struct sum sum_abs(struct sum a)
{
	return sum_negated_if(a.value.sign < 0, a);
}

bool sum_is_exact_zero(const struct sum *a)
{
	return a->value.n == 0 && a->error.m == 0;
}

/* Computes the sum of n <= 4 products. The error of a product is |a| times the error of
 * b, |b| times the error of a, and the product of both errors. */
static void dot_of_pointers(int n, const struct sum *const a[],
    const struct sum *const b[], struct sum *r)
{
	const ex *x[4], *y[4];
	struct magnitude error = { 0, 0 };

	for (int k = 0; k < n; k++) {
		struct magnitude off_a = a[k]->error, off_b = b[k]->error;

		x[k] = &a[k]->value;
		y[k] = &b[k]->value;
		if (off_a.m > 0)
			error = magnitude_plus(error,
			    magnitude_times(off_a,
				magnitude_plus(magnitude_of(y[k]), off_b)));
		if (off_b.m > 0)
			error = magnitude_plus(error,
			    magnitude_times(magnitude_of(x[k]), off_b));
	}
	ex_dot(n, x, y, lowest_word(error), &r->value);
	r->error = error;
}

void sum_dot(int n, const struct sum *a, const struct sum *b, int step,
    struct sum *r)
{
	const struct sum *x[4], *y[4];

	for (int k = 0; k < n; k++) {
		x[k] = &a[k];
		y[k] = &b[k * step];
	}
	dot_of_pointers(n, x, y, r);
}

struct sum sum_add(struct sum a, struct sum b)
{
	const struct sum *const x[] = { &a, &b }, *const y[] = { &one, &one };

	dot_of_pointers(2, x, y, &a);
	return a;
}

struct sum sum_sub(struct sum a, struct sum b)
{
	const struct sum *const x[] = { &a, &b };
	const struct sum *const y[] = { &one, &minus_one };

	dot_of_pointers(2, x, y, &a);
	return a;
}

struct sum sum_mul(struct sum a, struct sum b)
{
	sum_dot(1, &a, &b, 1, &a);
	return a;
}

struct sum sum_scale(struct sum a, double by)
{
	return sum_mul(a, sum_of_double(by));
}

struct sum sum_minor(struct sum a, struct sum b, struct sum c, struct sum d)
{
	const struct sum *const x[] = { &a, &c }, *const y[] = { &b, &d };

	c.value.sign = -c.value.sign;
	dot_of_pointers(2, x, y, &a);
	return a;
}

bool sum_is_one(const struct sum *a)
{
	return a->error.m == 0 && a->value.sign == 1 && a->value.n == 1 &&
	    a->value.e == 0 && a->value.word[0] == 1;
}

bool sum_is_power_of_two(const struct sum *a)
{
	return a->error.m == 0 && a->value.n == 1 &&
	    (a->value.word[0] & (a->value.word[0] - 1)) == 0;
}

struct sum sum_quotient(struct sum a, struct sum b)
{
	struct magnitude d = magnitude_of(&b.value), error;

	if (sum_is_exact_zero(&a))
		return a;
	if (sum_is_power_of_two(&b)) {
		ex q = ex_shift(a.value, 1 - d.e);

		return (struct sum){ b.value.sign < 0 ? ex_neg(q) : q,
			magnitude_over(a.error, d) };
	}
	ex q;
	bool exact = ex_divide(&a.value, &b.value, EX_QUOTIENT, &q);

	/* 1 / b is at most 2 / |value| where b's error is at most half its value */
	error = magnitude_plus(a.error,
	    magnitude_times(magnitude_of(&q), b.error));
	error = magnitude_over(error, d);
	error.e += b.error.m > 0;
	return (struct sum){ q,
		exact ?
		    error :
		    magnitude_plus(error, sum_with_error(q, SUM_ERROR).error) };
}

struct sum sum_sqrt(struct sum a)
{
	if (a.value.sign <= 0) /* bounds the root by that of the error */
		return (struct sum){ ex_of(0),
			{ a.error.m > 0 ? 0.5 : 0, a.error.e / 2 + 2 } };
	struct sum r = sum_with_error(ex_sqrt(a.value), SUM_ERROR);

	if (a.error.m > 0)
		r.error = magnitude_plus(r.error,
		    magnitude_over(a.error, magnitude_of(&r.value)));
	else if (2 * r.value.n <= a.value.n + 2 &&
	    ex_compare(ex_mul(r.value, r.value), a.value) == 0)
		r.error.m = 0;
	return r;
}

/* Returns whether |difference| <= error. Such a difference counts as 0. */
static bool is_within_error(const ex *difference, struct magnitude error)
{
	struct magnitude d = magnitude_of(difference);

	return difference->n == 0 ||
	    (error.m > 0 && (d.e != error.e ? d.e < error.e : d.m <= error.m));
}

int sum_sign(struct sum a)
{
	return is_within_error(&a.value, a.error) ? 0 : a.value.sign;
}

int sum_compare(struct sum a, struct sum b)
{
	return sum_sign(sum_sub(a, b));
}

struct sum sum_snap_zero(struct sum a)
{
	return sum_sign(a) == 0 ? sum_of_double(0) : a;
}

/* Returns the double or float next to a, away from 0 or toward 0. */
static double neighbour(double a, bool away, bool single)
{
	double to = away ? copysign(HUGE_VAL, a) : 0;

	return single ? (double)nextafterf((float)a, (float)to) :
			nextafter(a, to);
}

/* Returns the double or float nearest to n / d, where n and d have errors. q is the
 * quotient of the values. As it can lie on the wrong side of the midpoint next to it,
 * the sign of n - midpoint d decides. A difference within its error is a tie. */
static double round_inexact(const struct sum *n, const struct sum *d,
    const ex *q, bool single)
{
	const double near = ex_nearest(q, single);
	ex rest, two = ex_of(2), a = ex_of(-near), b;

	ex_dot(2, (const ex *[]){ q, &a }, (const ex *[]){ &two, &two },
	    INT_MIN, &rest);
	int side = rest.sign * q->sign;

	if (!isfinite(near) || side == 0)
		return near;
	double other = neighbour(near == 0 ? copysign(0, q->sign) : near,
	    side > 0, single);

	ex_set(&b, -other);
	ex_dot(3, (const ex *[]){ &n->value, &d->value, &d->value },
	    (const ex *[]){ &two, &a, &b }, INT_MIN, &rest);
	struct magnitude error = magnitude_plus(
	    magnitude_times(magnitude_of(&two), n->error),
	    magnitude_times(magnitude_plus(magnitude_of(&a), magnitude_of(&b)),
		d->error));

	if (is_within_error(&rest, error)) {
		ex middle = ex_shift(ex_add(a, b), -1);

		return -ex_nearest(&middle, single);
	}
	bool beyond = rest.sign * d->value.sign == q->sign;

	return beyond == (side > 0) ? other : near;
}

double sum_nearest(const struct sum *n, const struct sum *d, bool single)
{
	bool exact = n->error.m == 0 && d->error.m == 0;
	ex quotient;
	const ex *q = &quotient;

	if (is_within_error(&n->value, n->error))
		return 0;
	if (sum_is_one(d))
		q = &n->value;
	else
		ex_divide(&n->value, &d->value, ROUNDED_WORDS, &quotient);
	return exact ? ex_nearest(q, single) : round_inexact(n, d, q, single);
}

double sum_ratio(struct sum n, struct sum d)
{
	return sum_nearest(&n, &d, false);
}

double sum_ratio_or_nan(struct sum n, struct sum d)
{
	double q = sum_ratio(n, d);

	return isfinite(q) ? q : (double)NAN;
}

double sum_double(struct sum a)
{
	return sum_nearest(&a, &one, false);
}

dd sum_dd(struct sum a)
{
	return ex_round(sum_snap_zero(a).value);
}

double sum_error(const struct sum *a)
{
	double e = ldexp(a->error.m, a->error.e) * (1 + 0x1p-50);

	return a->error.m > 0 ? e + 0x1p-1022 : 0;
}

double sum_least_error(const struct sum *n, const struct sum *d)
{
	struct magnitude s = magnitude_over(n->error, magnitude_of(&d->value));

	return ldexp(s.m, s.e) * (1 - 0x1p-50);
}
