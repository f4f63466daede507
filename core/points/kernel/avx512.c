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

#define F __m512
#define F_WIDTH 16
#define F_HALF(p, o) \
	_mm512_cvtpd_ps(_mm512_sub_pd(_mm512_loadu_pd(p), _mm512_set1_pd(o)))
#define F_JOIN(a, b)                                                        \
	_mm512_castpd_ps(                                                   \
	    _mm512_insertf64x4(_mm512_castps_pd(_mm512_castps256_ps512(a)), \
		_mm256_castps_pd(b), 1))
#define F_NEAR(p, o) F_JOIN(F_HALF(p, o), F_HALF((p) + 8, o))
#define F_STORE(p, a)                                                     \
	(_mm512_storeu_pd(p, _mm512_cvtps_pd(_mm512_castps512_ps256(a))), \
	    _mm512_storeu_pd((p) + 8,                                     \
		_mm512_cvtps_pd(_mm256_castpd_ps(                         \
		    _mm512_extractf64x4_pd(_mm512_castps_pd(a), 1)))))
#define F_LOAD(p) _mm512_loadu_ps(p)
#define F_SAVE(p, a) _mm512_storeu_ps(p, a)
#define F_FAR_HALF(p, o)                                                   \
	_mm512_cvtpd_ps(_mm512_sub_pd(_mm512_cvtps_pd(_mm256_loadu_ps(p)), \
	    _mm512_set1_pd(o)))
#define F_FAR(p, o) F_JOIN(F_FAR_HALF(p, o), F_FAR_HALF((p) + 8, o))
#define F_ALL(a) _mm512_set1_ps(a)
#define F_FMA(a, b, c) _mm512_fmadd_ps(a, b, c)
#define F_POSITIVE(a, b)                                                \
	_mm512_mask_blend_ps(_mm512_cmp_ps_mask(a, _mm512_setzero_ps(), \
				 _CMP_GT_OQ),                           \
	    _mm512_set1_ps(NAN), b)

#include "copy.h"
#endif
