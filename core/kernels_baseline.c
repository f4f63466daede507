/* For any processor: fma is the C library's, exact everywhere and fast where
 * there is an instruction for it. */
#include <math.h>

#define COPY kernels_baseline
#define V double
#define WIDTH 1
#define LOAD(p) (*(p))
#define STORE(p, a) (*(p) = (a))
#define ALL(a) ((double)(a))
#define FMA(a, b, c) fma(a, b, c)
#define ABS(a) fabs(a)
#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define POSITIVE(a, b) ((a) > 0 ? (b) : (double)NAN)

#include "kernel_body.h"
