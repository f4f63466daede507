/* For x86-64 with AVX2 and FMA: compile with -mavx2 -mfma. */
#ifdef __AVX2__
#include <immintrin.h>
#include <math.h>

#define COPY kernels_avx2
#define V __m256d
#define WIDTH 4
#define LOAD(p) _mm256_loadu_pd(p)
#define STORE(p, a) _mm256_storeu_pd(p, a)
#define ALL(a) _mm256_set1_pd(a)
#define FMA(a, b, c) _mm256_fmadd_pd(a, b, c)
#define ABS(a) _mm256_andnot_pd(_mm256_set1_pd(-0.0), a)
#define MIN(a, b) _mm256_min_pd(a, b)
#define POSITIVE(a, b) _mm256_blendv_pd(_mm256_set1_pd((double)NAN), b, \
	_mm256_cmp_pd(a, _mm256_setzero_pd(), _CMP_GT_OQ))

#include "kernel_body.h"
#endif
