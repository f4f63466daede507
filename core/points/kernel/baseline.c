/* SPDX-License-Identifier: MIT */
/* For any processor: fma is the C library's, exact everywhere and fast where
 * there is an instruction for it. */
#include <math.h>

#define COPY kernels_baseline
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
#define SAME(a, b, c) ((a) == (b) ? (c) : 0)
#define IS_POSITIVE(a) ((a) > 0)
#define CHOOSE(a, b, c) ((a) > 0 ? (b) : (c))

#include "copy.h"
