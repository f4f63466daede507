/* SPDX-License-Identifier: MIT */
/* The operations of x86-64 with AVX-512; copy.h describes them. */
#include <immintrin.h>

#define V __m512d
#define M __mmask8
#define WIDTH 8
#define LOAD(p) _mm512_loadu_pd(p)
#define STORE(p, a) _mm512_storeu_pd(p, a)
#define ALL(a) _mm512_set1_pd(a)
#define FMA(a, b, c) _mm512_fmadd_pd(a, b, c)
#define SQRT(a) _mm512_sqrt_pd(a)
#define ABS(a) _mm512_abs_pd(a)
#define MIN(a, b) _mm512_min_pd(a, b)
#define MAX(a, b) _mm512_max_pd(a, b)
#define LESS(a, b) _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ)
#define EQUAL(a, b) _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ)
#define MASK_BITS(m) ((unsigned)(m))
#define SELECT(m, a, b) _mm512_mask_blend_pd((M)(m), b, a)
#define ONLY(m, a) _mm512_maskz_mov_pd((M)(m), a)
