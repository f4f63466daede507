/* SPDX-License-Identifier: MIT */
/* For x86-64 with AVX-512: compile with -mavx512f -mavx512bw -mavx512cd -mavx512dq
 * -mavx512vl -mfma. */
#ifdef __AVX512BW__
#include "../../../core/points/kernel/simd_avx512.h"

#define READER plain_avx512
#define READ read_avx512
#define FIND find_avx512

#define IN_SET(set, s) in_set(set, s)
#define EIGHTS(rows, first, rest) eights(rows, &(first), &(rest))

#define LAST(n) ((__mmask32)(0xffffffff00000000 >> (n)))
#define PICK(m, a, b) ((row)_mm256_mask_mov_epi8((__m256i)(b), m, (__m256i)(a)))
#define KEEP(m, a) ((row)_mm256_maskz_mov_epi8(m, (__m256i)(a)))
#define DOTS(x) _mm256_cmpeq_epi8_mask((__m256i)(x), _mm256_set1_epi8('.'))
#define LEADING_ZEROS(x) ((counts)_mm256_lzcnt_epi32((__m256i)(x)))
#define LARGER(a, b) ((row)_mm256_max_epu8((__m256i)(a), (__m256i)(b)))
#define ANY_TOP_BIT(x) (_mm256_movemask_epi8((__m256i)(x)) != 0)

#include "../plain.h"

static inline uint64_t in_set(const struct byte_set *set, const char *s)
{
	__m512i x = _mm512_loadu_si512(s), four = _mm512_set1_epi8(15);
	__m512i low = _mm512_broadcast_i32x4(
	    _mm_loadu_si128((const void *)set->low));
	__m512i high = _mm512_broadcast_i32x4(
	    _mm_loadu_si128((const void *)set->high));

	low = _mm512_shuffle_epi8(low, _mm512_and_si512(x, four));
	high = _mm512_shuffle_epi8(high,
	    _mm512_and_si512(_mm512_srli_epi16(x, 4), four));
	return _mm512_test_epi8_mask(low, high);
}

/* Two digits, then four, then eight by multiplication and addition. */
static inline void eights(const uint8_t *rows, void *first, void *rest)
{
	const __m512i order = _mm512_setr_epi64(0, 2, 4, 6, 1, 3, 5, 7);
	__m512i x[2], y;

	for (int k = 0; k < 2; k++) {
		const uint8_t *row = rows + 128 * k;

		x[k] = _mm512_shuffle_i64x2(_mm512_loadu_si512(row),
		    _mm512_loadu_si512(row + 64), 0x88);
		x[k] = _mm512_maddubs_epi16(x[k], _mm512_set1_epi16(0x010a));
		x[k] = _mm512_madd_epi16(x[k], _mm512_set1_epi32(0x00010064));
	}
	y = _mm512_madd_epi16(_mm512_packus_epi32(x[0], x[1]),
	    _mm512_set1_epi32(0x00012710));
	y = _mm512_permutexvar_epi64(order, y);
	_mm512_storeu_si512(first,
	    _mm512_and_si512(y, _mm512_set1_epi64(0xffffffff)));
	_mm512_storeu_si512(rest, _mm512_srli_epi64(y, 32));
}

#include "read_body.h"
#endif
