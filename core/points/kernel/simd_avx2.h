/* SPDX-License-Identifier: MIT */
/* The operations of x86-64 with AVX2 and FMA; copy.h describes them. */
#include <immintrin.h>

#define V __m256d
#define M __m256i
#define WIDTH 4
#define LOAD(p) _mm256_loadu_pd(p)
#define STORE(p, a) _mm256_storeu_pd(p, a)
#define ALL(a) _mm256_set1_pd(a)
#define FMA(a, b, c) _mm256_fmadd_pd(a, b, c)
#define SQRT(a) _mm256_sqrt_pd(a)
#define ABS(a) _mm256_andnot_pd(_mm256_set1_pd(-0.0), a)
#define MIN(a, b) _mm256_min_pd(a, b)
#define MAX(a, b) _mm256_max_pd(a, b)
#define LESS(a, b) _mm256_castpd_si256(_mm256_cmp_pd(a, b, _CMP_LT_OQ))
#define EQUAL(a, b) _mm256_castpd_si256(_mm256_cmp_pd(a, b, _CMP_EQ_OQ))
#define MASK_BITS(m) ((unsigned)_mm256_movemask_pd(_mm256_castsi256_pd(m)))
#define SELECT(m, a, b) _mm256_blendv_pd(b, a, _mm256_castsi256_pd(m))
#define ONLY(m, a) _mm256_and_pd(_mm256_castsi256_pd(m), a)
