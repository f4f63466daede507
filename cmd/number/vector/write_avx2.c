/* SPDX-License-Identifier: MIT */
/* For x86-64 with AVX2 and FMA: compile with -mavx2 -mfma. */
#ifdef __AVX2__
#include "../../../core/points/kernel/simd_avx2.h"
#include "powers.h"
#include "vector.h"

#define I __m256i
#define STORE_INTS(p, a) _mm_storeu_si128((__m128i *)(p), _mm256_cvtpd_epi32(a))
#define FLOOR(a) _mm256_floor_pd(a)
#define NEAREST(a) \
	_mm256_round_pd(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC)
#define ALL_BITS(a) _mm256_set1_epi64x((long long)(a))
#define REGISTER "x"
#define SHR(a, n) _mm256_srli_epi64(a, n)
#define SHR16(a, n) _mm256_srli_epi16(a, n)
#define MUL32(a, b) _mm256_mul_epu32(a, b)
#define MUL16(a, b) _mm256_mullo_epi16(a, b)
#define HIGH16(a, b) _mm256_mulhi_epu16(a, b)
#define BYTES_LOW(a) _mm256_unpacklo_epi8(_mm256_setzero_si256(), a)
#define BYTES_HIGH(a) _mm256_unpackhi_epi8(_mm256_setzero_si256(), a)

struct tens {
	const double (*pair)[2]; /* of 10^0 */
};

static inline struct tens load_tens(void)
{
	return (struct tens){ powers - POWER_MIN };
}

/* Four loads of hi and lo take less time than two gathers. */
static inline void power_of_ten(const struct tens *t, V scale, V *hi, V *lo)
{
	__m128i k = _mm256_cvtpd_epi32(scale);
	__m128d a = _mm_loadu_pd(t->pair[_mm_extract_epi32(k, 0)]);
	__m128d b = _mm_loadu_pd(t->pair[_mm_extract_epi32(k, 1)]);
	__m128d c = _mm_loadu_pd(t->pair[_mm_extract_epi32(k, 2)]);
	__m128d d = _mm_loadu_pd(t->pair[_mm_extract_epi32(k, 3)]);
	V ac = _mm256_set_m128d(c, a), bd = _mm256_set_m128d(d, b);

	*hi = _mm256_unpacklo_pd(ac, bd);
	*lo = _mm256_unpackhi_pd(ac, bd);
}

#define TO(i) ((__m128i *)(to + (i)*step))
static inline void store_digits(char *to, size_t step, uint16_t *nonzero, I a,
    I b)
{
	const I zero = _mm256_setzero_si256(), zeros = _mm256_set1_epi8('0');
	/* bits of numbers 0, 2 and 1, 3 */
	int in_a = _mm256_movemask_epi8(_mm256_cmpgt_epi8(a, zero));
	int in_b = _mm256_movemask_epi8(_mm256_cmpgt_epi8(b, zero));

	_mm_storel_epi64((__m128i *)nonzero,
	    _mm_unpacklo_epi16(_mm_cvtsi32_si128(in_a),
		_mm_cvtsi32_si128(in_b)));
	a |= zeros;
	b |= zeros;
	_mm_storeu_si128(TO(0), _mm256_castsi256_si128(a));
	_mm_storeu_si128(TO(1), _mm256_castsi256_si128(b));
	_mm_storeu_si128(TO(2), _mm256_extracti128_si256(a, 1));
	_mm_storeu_si128(TO(3), _mm256_extracti128_si256(b, 1));
}

#define WRITER number_texts_avx2
#include "write_body.h"
#endif
