/* SPDX-License-Identifier: MIT */
/* Sums, products and quotients of ex, which is the type of core/exact/ex.h, for
 * tests. */
#pragma once

#include <limits.h>

#include "../exact/ex.h"

static inline ex ex_neg(ex a)
{
	a.sign = -a.sign;
	return a;
}

static inline ex ex_mul(ex a, ex b)
{
	const ex *const x[] = { &a }, *const y[] = { &b };

	ex_dot(1, x, y, INT_MIN, &a);
	return a;
}

static inline ex ex_add(ex a, ex b)
{
	const ex one = ex_of(1);
	const ex *const x[] = { &a, &b }, *const y[] = { &one, &one };

	ex_dot(2, x, y, INT_MIN, &a);
	return a;
}

static inline ex ex_sub(ex a, ex b)
{
	return ex_add(a, ex_neg(b));
}

static inline ex ex_quotient(ex a, ex b)
{
	ex r;

	ex_divide(&a, &b, EX_QUOTIENT_WORDS, &r);
	return r;
}

static inline ex ex_root(ex a)
{
	if (a.sign > 0)
		ex_sqrt(&a, EX_QUOTIENT_WORDS, &a);
	return a;
}

/* Returns the n highest words of a. */
static inline ex ex_cut(ex a, int n)
{
	ex_truncate(&a, n, &a);
	return a;
}

/* Returns a times 2^e. */
static inline ex ex_shift(ex a, int e)
{
	return ex_mul(a, ex_power(e));
}

/* Returns the sign of a - b. */
static inline int ex_compare(ex a, ex b)
{
	return ex_sub(a, b).sign;
}

static inline double ex_double(ex a)
{
	return ex_nearest(&a, false);
}
