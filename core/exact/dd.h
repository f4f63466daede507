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

/* a b = hi + lo exactly, while |a b| > 2^-969. */
static inline dd two_prod(double a, double b)
{
	double p = a * b;

	return (dd){ p, fma(a, b, -p) };
}

#endif
