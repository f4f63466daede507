/* SPDX-License-Identifier: MIT */
/* Double-double arithmetic: a value is the unevaluated sum hi + lo with
 * hi = RN(hi + lo), about 106 bits. Bounds are relative, in units of
 * u^2 = 2^-106, and hold while nothing overflows and no low part falls below
 * 2^-1022. Proofs: Joldes, Muller, Popescu, "Tight and rigorous error bounds
 * for basic building blocks of double-word arithmetic", ACM TOMS 44 (2017);
 * Muller, Rideau, "Formalization of double-word arithmetic", ACM TOMS 48
 * (2022). `make prove` counts the errors of dd_mul and dd_div again, from what
 * stands here. Compile with -ffp-contract=off: each operation below is one
 * rounding, and fma appears only where it is written. */
#ifndef DD_H
#define DD_H

#include <float.h>
#include <math.h>

#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__ || \
    defined __RECIPROCAL_MATH__ ||                           \
    (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__)
#error compile without -ffast-math and -Ofast, as with -O2: \
they leave out operations that the bounds here count on
#endif
#if FLT_EVAL_METHOD != 0
#error doubles are to be rounded to doubles: on x86 compile with \
-msse2 -mfpmath=sse
#endif

typedef struct {
	double hi, lo;
} dd;

/* a + b = hi + lo exactly (Knuth, Moeller). */
static inline dd two_sum(double a, double b)
{
	double s = a + b, t = s - a;

	return (dd){ s, (a - (s - t)) + (b - t) };
}

/* The same for |a| >= |b| or a = 0 (Dekker). */
static inline dd fast_two_sum(double a, double b)
{
	double s = a + b;

	return (dd){ s, b - (s - a) };
}

/* a b = hi + lo exactly, while |a b| > 2^-969. */
static inline dd two_prod(double a, double b)
{
	double p = a * b;

	return (dd){ p, fma(a, b, -p) };
}

static inline dd dd_neg(dd a)
{
	return (dd){ -a.hi, -a.lo };
}

static inline dd dd_scale(dd a, double power_of_two)
{
	return (dd){ a.hi * power_of_two, a.lo * power_of_two };
}

static inline dd dd_shift(dd a, int e)
{
	return (dd){ ldexp(a.hi, e), ldexp(a.lo, e) };
}

/* 3 u^2 (AccurateDWPlusDW) of the result, even where the terms cancel. */
static inline dd dd_add(dd a, dd b)
{
	dd s = two_sum(a.hi, b.hi), t = two_sum(a.lo, b.lo);

	s = fast_two_sum(s.hi, s.lo + t.hi);
	return fast_two_sum(s.hi, s.lo + t.lo);
}

/* 5 u^2; in truth 4 (DWTimesDW3). */
static inline dd dd_mul(dd a, dd b)
{
	dd p = two_prod(a.hi, b.hi);
	double t = fma(a.lo, b.hi, fma(a.hi, b.lo, a.lo * b.lo));

	return fast_two_sum(p.hi, p.lo + t);
}

/* 9 u^2 of the result, worst where a.hi and b.hi are just above powers of two:
 * the remainder a.hi - q b.hi is exact; rounding a.lo - q b.lo costs 2 u^2, their
 * sum r 2 u^2, dividing that by b.hi instead of b 3 u^2, and rounding the last
 * quotient 2 u^2. */
static inline dd dd_div(dd a, dd b)
{
	double q = a.hi / b.hi;
	dd p = two_prod(q, b.hi);
	double r = ((a.hi - p.hi) - p.lo) + fma(-q, b.lo, a.lo);

	return fast_two_sum(q, r / b.hi);
}

#endif
