/* SPDX-License-Identifier: MIT */
/* The kernels for any processor. fma() of the C library rounds once on all processors,
 * and is fast on those that have an instruction for it. */
#include <math.h>

#define KERNELS_NAME kernels_baseline
#define PROCESSOR PROCESSOR_BASELINE

#define V double
#define WIDTH 1
#define LOAD(p) (*(p))
#define STORE(p, a) (*(p) = (a))
#define ALL(a) ((double)(a))
#define FMA(a, b, c) fma(a, b, c)
#define SQRT(a) sqrt(a)
#define ABS(a) fabs(a)
#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define MAX(a, b) ((a) > (b) ? (a) : (b))
#define MADD(a, b, c) ((a) * (b) + (c))
#define LESS(a, b) ((a) < (b))
#define EQUAL(a, b) ((a) == (b))
#define MASK_BITS(m) ((unsigned)(m))
#define SELECT(m, a, b) ((m) ? (a) : (b))
#define ONLY(m, a) ((m) ? (a) : 0)

#include "copy.h"
