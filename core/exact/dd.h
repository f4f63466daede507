/* SPDX-License-Identifier: MIT */
/* Double-double numbers, and checks of the compiler's floating-point arithmetic.
 * Compile with -ffp-contract=off: the error bounds hold if a b + c has two roundings
 * where the source does not call fma. */
#pragma once

#include <float.h>
#include <math.h>

#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__ || \
    defined __RECIPROCAL_MATH__ ||                           \
    (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__)
#error compile without -ffast-math and -Ofast, as with -O2: \
they remove operations that the error bounds count
#endif
#if FLT_EVAL_METHOD != 0
#error each operation must round to double: on x86 compile with \
-msse2 -mfpmath=sse
#endif

/* The unevaluated sum hi + lo, where hi is the double nearest to the sum. */
typedef struct {
	double hi, lo;
} dd;
