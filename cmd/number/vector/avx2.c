/* SPDX-License-Identifier: MIT */
/* Reads and writes numbers on x86-64 with AVX2 and FMA: compile with -mavx2 -mfma. */
#ifdef __AVX2__
#include "../../../core/points/kernel/simd_avx2.h"
#include "loops.h"
#include "powers.h"

#define LOOPS number_loops_avx2

typedef uint64_t lanes __attribute__((vector_size(8 * WIDTH)));
typedef uint16_t quarters __attribute__((vector_size(8 * WIDTH)));

#define IN_SET(set, s) ((uint64_t)in_set(set, (s) + 32) << 32 | in_set(set, s))
#define MATCH(x, c)                      \
	((uint32_t)_mm256_movemask_epi8( \
	    _mm256_cmpeq_epi8((__m256i)(x), _mm256_set1_epi8(c))))
#define LARGER(a, b) ((row)_mm256_max_epu8((__m256i)(a), (__m256i)(b)))
#define ANY_TOP_BIT(x) (_mm256_movemask_epi8((__m256i)(x)) != 0)

static inline uint32_t in_set(const struct byte_set *set, const char *s)
{
	__m256i x = _mm256_loadu_si256((const void *)s);
	__m256i low_four = _mm256_set1_epi8(15);
	__m256i low = _mm256_broadcastsi128_si256(
	    _mm_loadu_si128((const void *)set->low));
	__m256i high = _mm256_broadcastsi128_si256(
	    _mm_loadu_si128((const void *)set->high));

	low = _mm256_shuffle_epi8(low, _mm256_and_si256(x, low_four));
	high = _mm256_shuffle_epi8(high,
	    _mm256_and_si256(_mm256_srli_epi16(x, 4), low_four));
	return ~(uint32_t)_mm256_movemask_epi8(
	    _mm256_cmpeq_epi8(_mm256_and_si256(low, high), _mm256_setzero_si256()));
}

/* Joins digits to numbers of two, then four, then eight digits, by multiply-adds. */
static inline void join_digits(const uint8_t *rows, int half, lanes *high, lanes *low)
{
	__m256i x[2], y;

	for (int k = 0; k < 2; k++) {
		const uint8_t *at = rows + 64 * k + 16 * half;

		x[k] = _mm256_loadu2_m128i((const void *)(at + 32), (const void *)at);
		x[k] = _mm256_maddubs_epi16(x[k], _mm256_set1_epi16(0x010a));
		x[k] = _mm256_madd_epi16(x[k], _mm256_set1_epi32(0x00010064));
	}
	y = _mm256_madd_epi16(_mm256_packus_epi32(x[0], x[1]),
	    _mm256_set1_epi32(0x00012710));
	y = _mm256_permute4x64_epi64(y, _MM_SHUFFLE(3, 1, 2, 0));
	*high = (lanes)y & 0xffffffff;
	*low = (lanes)y >> 32;
}

#define STORE_INTS(p, a) _mm_storeu_si128((__m128i *)(p), _mm256_cvtpd_epi32(a))
#define FLOOR(a) _mm256_floor_pd(a)
#define NEAREST(a) _mm256_round_pd(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC)
#define REGISTER "x"
#define MUL32(a, n) ((lanes)_mm256_mul_epu32((__m256i)(a), _mm256_set1_epi64x(n)))
#define HIGH16(a, n) ((quarters)_mm256_mulhi_epu16((__m256i)(a), _mm256_set1_epi16(n)))
#define BYTES_LOW(a) \
	((quarters)_mm256_unpacklo_epi8(_mm256_setzero_si256(), (__m256i)(a)))
#define BYTES_HIGH(a) \
	((quarters)_mm256_unpackhi_epi8(_mm256_setzero_si256(), (__m256i)(a)))

/* Looks 10^scale up as hi + lo. Four loads take less time than two gathers. */
static inline void power_of_ten(V scale, V *hi, V *lo)
{
	const double(*power)[2] = powers - POWER_MIN;
	__m128i k = _mm256_cvtpd_epi32(scale);
	__m128d a = _mm_loadu_pd(power[_mm_extract_epi32(k, 0)]);
	__m128d b = _mm_loadu_pd(power[_mm_extract_epi32(k, 1)]);
	__m128d c = _mm_loadu_pd(power[_mm_extract_epi32(k, 2)]);
	__m128d d = _mm_loadu_pd(power[_mm_extract_epi32(k, 3)]);
	V ac = _mm256_set_m128d(c, a), bd = _mm256_set_m128d(d, b);

	*hi = _mm256_unpacklo_pd(ac, bd);
	*lo = _mm256_unpackhi_pd(ac, bd);
}

#define TEXT_AT(i) ((__m128i *)(to + (i)*step))
static inline void store_digits(char *to, size_t step, uint16_t *nonzero, quarters even,
    quarters odd)
{
	__m256i a = (__m256i)even, b = (__m256i)odd;
	const __m256i zero = _mm256_setzero_si256(), zeros = _mm256_set1_epi8('0');
	/* a has the digits of numbers 0 and 2, b the digits of 1 and 3 */
	int in_a = _mm256_movemask_epi8(_mm256_cmpgt_epi8(a, zero));
	int in_b = _mm256_movemask_epi8(_mm256_cmpgt_epi8(b, zero));

	_mm_storel_epi64((__m128i *)nonzero,
	    _mm_unpacklo_epi16(_mm_cvtsi32_si128(in_a), _mm_cvtsi32_si128(in_b)));
	a |= zeros;
	b |= zeros;
	_mm_storeu_si128(TEXT_AT(0), _mm256_castsi256_si128(a));
	_mm_storeu_si128(TEXT_AT(1), _mm256_castsi256_si128(b));
	_mm_storeu_si128(TEXT_AT(2), _mm256_extracti128_si256(a, 1));
	_mm_storeu_si128(TEXT_AT(3), _mm256_extracti128_si256(b, 1));
}

#include "read_body.h"
#include "write_body.h"
#endif
