/* SPDX-License-Identifier: MIT */
/* For x86-64 with AVX2 and FMA: compile with -mavx2 -mfma. */
#ifdef __AVX2__
#include <immintrin.h>

#define COPY kernels_avx2
#define PROCESSOR PROCESSOR_AVX2

#define V __m256d
#define WIDTH 4
#define LOAD(p) _mm256_loadu_pd(p)
#define STORE(p, a) _mm256_storeu_pd(p, a)
#define ALL(a) _mm256_set1_pd(a)
#define FMA(a, b, c) _mm256_fmadd_pd(a, b, c)
#define SQRT(a) _mm256_sqrt_pd(a)
#define ABS(a) _mm256_andnot_pd(_mm256_set1_pd(-0.0), a)
#define MIN(a, b) _mm256_min_pd(a, b)
#define MAX(a, b) _mm256_max_pd(a, b)
#define MADD FMA
#define SAME(a, b, c) _mm256_and_pd(c, _mm256_cmp_pd(a, b, _CMP_EQ_OQ))
#define IS_POSITIVE(a)       \
	(_mm256_movemask_pd( \
	     _mm256_cmp_pd(a, _mm256_setzero_pd(), _CMP_GT_OQ)) == 0xf)
#define CHOOSE(a, b, c)        \
	_mm256_blendv_pd(c, b, \
	    _mm256_cmp_pd(a, _mm256_setzero_pd(), _CMP_GT_OQ))

#include "copy.h"
#endif
