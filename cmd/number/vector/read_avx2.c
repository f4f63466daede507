/* SPDX-License-Identifier: MIT */
/* For x86-64 with AVX2 and FMA: compile with -mavx2 -mfma. */
#ifdef __AVX2__
#include "../../../core/points/kernel/simd_avx2.h"

#define READER plain_avx2
#define READ read_avx2
#define FIND find_avx2

#define IN_SET(set, s) ((uint64_t)in_set(set, (s) + 32) << 32 | in_set(set, s))
#define DOTS(x)                          \
	((uint32_t)_mm256_movemask_epi8( \
	    _mm256_cmpeq_epi8((__m256i)(x), _mm256_set1_epi8('.'))))
#define LARGER(a, b) ((row)_mm256_max_epu8((__m256i)(a), (__m256i)(b)))
#define ANY_TOP_BIT(x) (_mm256_movemask_epi8((__m256i)(x)) != 0)
#define EIGHTS(rows, first, rest) eights(rows, &(first), &(rest))

#include "../plain.h"

static inline uint32_t in_set(const struct byte_set *set, const char *s)
{
	__m256i x = _mm256_loadu_si256((const void *)s);
	__m256i four = _mm256_set1_epi8(15);
	__m256i low = _mm256_broadcastsi128_si256(
	    _mm_loadu_si128((const void *)set->low));
	__m256i high = _mm256_broadcastsi128_si256(
	    _mm_loadu_si128((const void *)set->high));

	low = _mm256_shuffle_epi8(low, _mm256_and_si256(x, four));
	high = _mm256_shuffle_epi8(high,
	    _mm256_and_si256(_mm256_srli_epi16(x, 4), four));
	return ~(uint32_t)_mm256_movemask_epi8(
	    _mm256_cmpeq_epi8(_mm256_and_si256(low, high),
		_mm256_setzero_si256()));
}

/* Two digits, then four, then eight by multiplication and addition. */
static inline void eights(const uint8_t *rows, void *first, void *rest)
{
	__m256i x[2], y;

	for (int k = 0; k < 2; k++) {
		x[k] = _mm256_loadu2_m128i((const void *)(rows + 64 * k + 32),
		    (const void *)(rows + 64 * k));
		x[k] = _mm256_maddubs_epi16(x[k], _mm256_set1_epi16(0x010a));
		x[k] = _mm256_madd_epi16(x[k], _mm256_set1_epi32(0x00010064));
	}
	y = _mm256_madd_epi16(_mm256_packus_epi32(x[0], x[1]),
	    _mm256_set1_epi32(0x00012710));
	y = _mm256_permute4x64_epi64(y, _MM_SHUFFLE(3, 1, 2, 0));
	_mm256_storeu_si256(first,
	    _mm256_and_si256(y, _mm256_set1_epi64x(0xffffffff)));
	_mm256_storeu_si256(rest, _mm256_srli_epi64(y, 32));
}

#include "read_body.h"
#endif
