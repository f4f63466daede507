/* SPDX-License-Identifier: MIT */
/* A double and what it leaves of a number. Compile with -ffp-contract=off: each
 * operation of the program is one rounding, and fma appears only where it is
 * written. */
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

/* hi + lo, unevaluated, where hi is the double nearest to the sum. */
typedef struct {
	double hi, lo;
} dd;

#endif
