/* SPDX-License-Identifier: MIT */
/* Reads and writes numbers on x86-64 with AVX-512: compile with -mavx512f -mavx512bw
 * -mavx512cd -mavx512dq -mavx512vl -mfma. */
#ifdef __AVX512BW__
#include "../../../core/points/kernel/simd_avx512.h"
#include "loops.h"
#include "powers.h"

#define LOOPS number_loops_avx512

typedef uint64_t lanes __attribute__((vector_size(8 * WIDTH)));
typedef uint16_t quarters __attribute__((vector_size(8 * WIDTH)));

/* Two numbers stand side by side in a row, so that one mask has 64 bits for both. */
enum { ROW_NUMBERS = 2 };
typedef uint8_t row __attribute__((vector_size(64)));
typedef uint64_t row_mask;

#define IN_SET(set, s) in_set(set, s)
#define ROW_BEFORE(end, n)                                                  \
	((row)_mm512_inserti64x4(_mm512_castsi256_si512(_mm256_loadu_si256( \
				     (const void *)((end)[0] - (n)))),      \
	    _mm256_loadu_si256((const void *)((end)[1] - (n))), 1))
#define LAST_KEYS(n) \
	((counts)_mm256_sllv_epi32(_mm256_set1_epi32(-1), (__m256i)(32 - (n))))
#define LAST_BYTES(keys) row_mask_at(keys)
#define PICK(m, a, b) ((row)_mm512_mask_mov_epi8((__m512i)(b), m, (__m512i)(a)))
#define KEEP(m, a) ((row)_mm512_maskz_mov_epi8(m, (__m512i)(a)))
#define MATCH(x, c) _mm512_cmpeq_epi8_mask((__m512i)(x), _mm512_set1_epi8(c))
#define LEADING_ZEROS(x) ((counts)_mm256_lzcnt_epi32((__m256i)(x)))
#define LARGER(a, b) ((row)_mm512_max_epu8((__m512i)(a), (__m512i)(b)))
#define ANY_TOP_BIT(x) (_mm256_movemask_epi8((__m256i)(x)) != 0)
#define ANY_ABOVE_9(x) (_mm512_cmpgt_epu8_mask((__m512i)(x), _mm512_set1_epi8(9)) != 0)

static inline row_mask row_mask_at(const uint32_t *keys)
{
	row_mask m;

	memcpy(&m, keys, sizeof m);
	return m;
}

static inline uint64_t in_set(const struct byte_set *set, const char *s)
{
	__m512i x = _mm512_loadu_si512(s), low_four = _mm512_set1_epi8(15);
	__m512i low = _mm512_broadcast_i32x4(_mm_loadu_si128((const void *)set->low));
	__m512i high = _mm512_broadcast_i32x4(_mm_loadu_si128((const void *)set->high));

	low = _mm512_shuffle_epi8(low, _mm512_and_si512(x, low_four));
	high = _mm512_shuffle_epi8(high,
	    _mm512_and_si512(_mm512_srli_epi16(x, 4), low_four));
	return _mm512_test_epi8_mask(low, high);
}

/* Joins digits to numbers of two, then four, then eight digits, by multiply-adds. */
static inline void join_digits(const uint8_t *rows, int half, lanes *high, lanes *low)
{
	const __m512i order = _mm512_setr_epi64(0, 2, 4, 6, 1, 3, 5, 7);
	__m512i x[2], y;

	for (int k = 0; k < 2; k++) {
		__m512i a = _mm512_loadu_si512(rows + 128 * k);
		__m512i b = _mm512_loadu_si512(rows + 128 * k + 64);

		x[k] = half ? _mm512_shuffle_i64x2(a, b, 0xdd) :
			      _mm512_shuffle_i64x2(a, b, 0x88);
		x[k] = _mm512_maddubs_epi16(x[k], _mm512_set1_epi16(0x010a));
		x[k] = _mm512_madd_epi16(x[k], _mm512_set1_epi32(0x00010064));
	}
	y = _mm512_madd_epi16(_mm512_packus_epi32(x[0], x[1]),
	    _mm512_set1_epi32(0x00012710));
	y = _mm512_permutexvar_epi64(order, y);
	*high = (lanes)y & 0xffffffff;
	*low = (lanes)y >> 32;
}

#define STORE_INTS(p, a) _mm256_storeu_si256((__m256i *)(p), _mm512_cvtpd_epi32(a))
#define FLOOR(a) _mm512_roundscale_pd(a, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)
#define NEAREST(a) \
	_mm512_roundscale_pd(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC)
#define REGISTER "v"
#define MUL32(a, n) ((lanes)_mm512_mul_epu32((__m512i)(a), _mm512_set1_epi64(n)))
#define HIGH16(a, n) ((quarters)_mm512_mulhi_epu16((__m512i)(a), _mm512_set1_epi16(n)))
#define BYTES_LOW(a) \
	((quarters)_mm512_unpacklo_epi8(_mm512_setzero_si512(), (__m512i)(a)))
#define BYTES_HIGH(a) \
	((quarters)_mm512_unpackhi_epi8(_mm512_setzero_si512(), (__m512i)(a)))

/* power_of_ten looks 10^scale up in registers: compilers load the table outside of the
 * caller's loop. The lowest bits of the double 2^52 + index are the index. */
#define POWERS_AT(i, order) \
	_mm512_permutex2var_pd(LOAD(powers[8 * (i)]), order, LOAD(powers[8 * (i) + 4]))
static inline void power_of_ten(V scale, V *hi, V *lo)
{
	const __m512i even = _mm512_setr_epi64(0, 2, 4, 6, 8, 10, 12, 14);
	const __m512i odd = _mm512_setr_epi64(1, 3, 5, 7, 9, 11, 13, 15);
	__m512i k = (__m512i)(scale + ALL(0x1p52 - (double)POWER_MIN));
	M upper = _mm512_test_epi64_mask(k, _mm512_set1_epi64(16));

	*lo = _mm512_maskz_permutex2var_pd((M)~upper, POWERS_AT(0, odd), k,
	    POWERS_AT(1, odd));
	*hi = SELECT(upper,
	    _mm512_permutex2var_pd(POWERS_AT(2, even), k, POWERS_AT(3, even)),
	    _mm512_permutex2var_pd(POWERS_AT(0, even), k, POWERS_AT(1, even)));
}

#define TEXT_AT(i) ((__m128i *)(to + (i)*step))
static inline void store_digits(char *to, size_t step, uint16_t *nonzero, quarters even,
    quarters odd)
{
	__m512i a = (__m512i)even, b = (__m512i)odd;
	const __m512i zeros = _mm512_set1_epi8('0');
	/* a has the digits of numbers 0, 2, 4, 6, b the digits of 1, 3, 5, 7 */
	__mmask64 in_a = _mm512_test_epi8_mask(a, a);
	__mmask64 in_b = _mm512_test_epi8_mask(b, b);

	_mm_storeu_si128((__m128i *)nonzero,
	    _mm_unpacklo_epi16(_mm_cvtsi64_si128((long long)in_a),
		_mm_cvtsi64_si128((long long)in_b)));
	a |= zeros;
	b |= zeros;
	_mm_storeu_si128(TEXT_AT(0), _mm512_castsi512_si128(a));
	_mm_storeu_si128(TEXT_AT(1), _mm512_castsi512_si128(b));
	_mm_storeu_si128(TEXT_AT(2), _mm512_extracti32x4_epi32(a, 1));
	_mm_storeu_si128(TEXT_AT(3), _mm512_extracti32x4_epi32(b, 1));
	_mm_storeu_si128(TEXT_AT(4), _mm512_extracti32x4_epi32(a, 2));
	_mm_storeu_si128(TEXT_AT(5), _mm512_extracti32x4_epi32(b, 2));
	_mm_storeu_si128(TEXT_AT(6), _mm512_extracti32x4_epi32(a, 3));
	_mm_storeu_si128(TEXT_AT(7), _mm512_extracti32x4_epi32(b, 3));
}

#include "read_body.h"
#include "write_body.h"
#endif
