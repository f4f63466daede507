/* SPDX-License-Identifier: MIT */
/* For x86-64 with AVX-512F, BW, DQ and VL. */
#ifdef __AVX512F__
#include "../../../core/points/kernel/simd_avx512.h"
#include "powers.h"
#include "vector.h"

#define I __m512i
#define STORE_INTS(p, a) \
	_mm256_storeu_si256((__m256i *)(p), _mm512_cvtpd_epi32(a))
#define FLOOR(a) \
	_mm512_roundscale_pd(a, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)
#define NEAREST(a) \
	_mm512_roundscale_pd(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC)
#define ALL_BITS(a) _mm512_set1_epi64((long long)(a))
#define REGISTER "v"
#define SHR(a, n) _mm512_srli_epi64(a, n)
#define SHR16(a, n) _mm512_srli_epi16(a, n)
#define MUL32(a, b) _mm512_mul_epu32(a, b)
#define MUL16(a, b) _mm512_mullo_epi16(a, b)
#define HIGH16(a, b) _mm512_mulhi_epu16(a, b)
#define BYTES_LOW(a) _mm512_unpacklo_epi8(_mm512_setzero_si512(), a)
#define BYTES_HIGH(a) _mm512_unpackhi_epi8(_mm512_setzero_si512(), a)

struct tens {
	V hi[4], lo[2];
};

static inline struct tens load_tens(void)
{
	const I even = _mm512_setr_epi64(0, 2, 4, 6, 8, 10, 12, 14);
	const I odd = _mm512_setr_epi64(1, 3, 5, 7, 9, 11, 13, 15);
	struct tens t;

	for (int i = 0; i < 4; i++) {
		V a = LOAD(powers[8 * i]), b = LOAD(powers[8 * i + 4]);

		t.hi[i] = _mm512_permutex2var_pd(a, even, b);
		if (i < 2)
			t.lo[i] = _mm512_permutex2var_pd(a, odd, b);
	}
	return t;
}

/* The index stands in the lowest bits of 2^52 + index. */
static inline void power_of_ten(const struct tens *t, V scale, V *hi, V *lo)
{
	I k = (I)(scale + ALL(0x1p52 - (double)POWER_MIN));
	M upper = _mm512_test_epi64_mask(k, ALL_BITS(16));

	*lo = _mm512_maskz_permutex2var_pd((M)~upper, t->lo[0], k, t->lo[1]);
	*hi = SELECT(upper, _mm512_permutex2var_pd(t->hi[2], k, t->hi[3]),
	    _mm512_permutex2var_pd(t->hi[0], k, t->hi[1]));
}

#define TO(i) ((__m128i *)(to + (i)*step))
static inline void store_digits(char *to, size_t step, uint16_t *nonzero, I a,
    I b)
{
	const I zeros = _mm512_set1_epi8('0');
	/* bits of numbers 0, 2, 4, 6 and 1, 3, 5, 7 */
	__mmask64 in_a = _mm512_test_epi8_mask(a, a);
	__mmask64 in_b = _mm512_test_epi8_mask(b, b);

	_mm_storeu_si128((__m128i *)nonzero,
	    _mm_unpacklo_epi16(_mm_cvtsi64_si128((long long)in_a),
		_mm_cvtsi64_si128((long long)in_b)));
	a |= zeros;
	b |= zeros;
	_mm_storeu_si128(TO(0), _mm512_castsi512_si128(a));
	_mm_storeu_si128(TO(1), _mm512_castsi512_si128(b));
	_mm_storeu_si128(TO(2), _mm512_extracti32x4_epi32(a, 1));
	_mm_storeu_si128(TO(3), _mm512_extracti32x4_epi32(b, 1));
	_mm_storeu_si128(TO(4), _mm512_extracti32x4_epi32(a, 2));
	_mm_storeu_si128(TO(5), _mm512_extracti32x4_epi32(b, 2));
	_mm_storeu_si128(TO(6), _mm512_extracti32x4_epi32(a, 3));
	_mm_storeu_si128(TO(7), _mm512_extracti32x4_epi32(b, 3));
}

#define WRITER number_texts_avx512
#include "write_body.h"
#endif
