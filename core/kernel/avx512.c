/* SPDX-License-Identifier: MIT */
/* For x86-64 with AVX-512: compile with -mavx512f -mfma. */
#ifdef __AVX512F__
#include <immintrin.h>

#define COPY kernels_avx512

#define V __m512d
#define WIDTH 8
#define LOAD(p) _mm512_loadu_pd(p)
#define STORE(p, a) _mm512_storeu_pd(p, a)
#define LOAD_BYTES(p) _mm512_loadu_pd(p)
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

/* Numbers from 0 to 7 are of a, from 8 to 15 of b. */
#define PICK(a, b, ...) \
	_mm512_permutex2var_pd(a, _mm512_setr_epi64(__VA_ARGS__), b)

static inline void split_three(const char *rows, __m512d p[3])
{
	__m512d a = _mm512_loadu_pd(rows), b = _mm512_loadu_pd(rows + 64);
	__m512d c = _mm512_loadu_pd(rows + 128);

	p[0] = PICK(a, b, 0, 3, 6, 9, 12, 15, 0, 0);
	p[1] = PICK(a, b, 1, 4, 7, 10, 13, 0, 0, 0);
	p[2] = PICK(a, b, 2, 5, 8, 11, 14, 0, 0, 0);
	p[0] = PICK(p[0], c, 0, 1, 2, 3, 4, 5, 10, 13);
	p[1] = PICK(p[1], c, 0, 1, 2, 3, 4, 8, 11, 14);
	p[2] = PICK(p[2], c, 0, 1, 2, 3, 4, 9, 12, 15);
}

static inline void join_three(char *rows, const __m512d q[3])
{
	__m512d a = PICK(q[0], q[1], 0, 8, 0, 1, 9, 0, 2, 10);
	__m512d b = PICK(q[0], q[1], 0, 3, 11, 0, 4, 12, 0, 5);
	__m512d c = PICK(q[0], q[1], 13, 0, 6, 14, 0, 7, 15, 0);

	a = PICK(a, q[2], 0, 1, 8, 3, 4, 9, 6, 7);
	b = PICK(b, q[2], 10, 1, 2, 11, 4, 5, 12, 7);
	c = PICK(c, q[2], 0, 13, 2, 3, 14, 5, 6, 15);
	_mm512_storeu_pd(rows, a);
	_mm512_storeu_pd(rows + 64, b);
	_mm512_storeu_pd(rows + 128, c);
}

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
#define F_ABS(a) _mm512_abs_ps(a)
#define F_MAX(a, b) _mm512_max_ps(a, b)
#define F_POSITIVE(a, b)                                                \
	_mm512_mask_blend_ps(_mm512_cmp_ps_mask(a, _mm512_setzero_ps(), \
				 _CMP_GT_OQ),                           \
	    _mm512_set1_ps(NAN), b)

#include "copy.h"
#endif
