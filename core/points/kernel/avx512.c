/* SPDX-License-Identifier: MIT */
/* For x86-64 with AVX-512: compile with -mavx512f -mfma. */
#ifdef __AVX512F__
#include <immintrin.h>

#define COPY kernels_avx512
#define PROCESSOR PROCESSOR_AVX512

#define V __m512d
#define WIDTH 8
#define LOAD(p) _mm512_loadu_pd(p)
#define STORE(p, a) _mm512_storeu_pd(p, a)
#define ALL(a) _mm512_set1_pd(a)
#define FMA(a, b, c) _mm512_fmadd_pd(a, b, c)
#define SQRT(a) _mm512_sqrt_pd(a)
#define ABS(a) _mm512_abs_pd(a)
#define MIN(a, b) _mm512_min_pd(a, b)
#define MAX(a, b) _mm512_max_pd(a, b)
#define MADD FMA
#define SAME(a, b, c) \
	_mm512_maskz_mov_pd(_mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ), c)
#define IS_POSITIVE(a) \
	(_mm512_cmp_pd_mask(a, _mm512_setzero_pd(), _CMP_GT_OQ) == 0xff)
#define CHOOSE(a, b, c)                                                 \
	_mm512_mask_blend_pd(_mm512_cmp_pd_mask(a, _mm512_setzero_pd(), \
				 _CMP_GT_OQ),                           \
	    c, b)

#include "copy.h"
#endif
