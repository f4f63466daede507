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

#define F float
#define F_WIDTH 1
#define F_NEAR(p, o) ((float)(*(p) - (o)))
#define F_STORE(p, a) (*(p) = (double)(a))
#define F_LOAD(p) (*(p))
#define F_SAVE(p, a) (*(p) = (a))
#define F_FAR(p, o) ((float)((double)*(p) - (o)))
#define F_ALL(a) ((float)(a))
#define F_FMA(a, b, c) fmaf(a, b, c)
#define F_POSITIVE(a, b) ((a) > 0 ? (b) : NAN)

#include "copy.h"
