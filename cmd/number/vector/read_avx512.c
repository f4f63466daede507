/* SPDX-License-Identifier: MIT */
/* For x86-64 with AVX-512: compile with -mavx512f -mavx512bw -mavx512cd -mavx512dq
 * -mavx512vl -mfma. */
#ifdef __AVX512BW__
#include <immintrin.h>

#define READER plain_avx512
#define READ read_avx512
#define FIND find_avx512
#define LANES 8

#define IN_SET(set, s) in_set(set, s)
#define NEGATED_FMA(a, b, c) ((D)_mm512_fnmadd_pd(a, b, c))
#define DIFFERENT(a, b) ((unsigned)_mm512_cmp_pd_mask(a, b, _CMP_NEQ_UQ))
#define EIGHTS(rows, first, rest) eights(rows, &(first), &(rest))

#include "read_rows.h"

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
		x[k] = _mm512_loadu_si512(rows + 64 * k);
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

/* A number's 32 bytes and the next one's. */
static inline __m512i two_rows(const char *a, const char *b)
{
	return _mm512_inserti64x4(_mm512_castsi256_si512(
				      _mm256_loadu_si256((const void *)a)),
	    _mm256_loadu_si256((const void *)b), 1);
}

/* Of the bytes before each end, bits for the points, the minus signs, the digits
 * after the point and all digits; two numbers in a mask. */
struct marks {
	__mmask64 point[PLAIN_BATCH / 2], minus[PLAIN_BATCH / 2],
	    fraction[PLAIN_BATCH / 2], digits[PLAIN_BATCH / 2];
	bool many[PLAIN_BATCH / PLAIN_GROUP];
};

/* The last bytes of the rows, n <= 32 of each: two rows in a mask. */
static inline void last(__m256i n, __mmask64 to[4])
{
	_mm256_storeu_si256((void *)to,
	    _mm256_sllv_epi32(_mm256_set1_epi32(-1),
		_mm256_sub_epi32(_mm256_set1_epi32(32), n)));
}

/* 10^decimals, of which NO_POINT is 10^0 as only five bits count, or -10^decimals;
 * nan where there are no digits. */
static inline __m512d scale_of(__m256i decimals, __mmask8 minus, __mmask8 none)
{
	const double *p = power[0];
	__m512i k = _mm512_cvtepu32_epi64(decimals);
	__mmask8 upper = _mm512_test_epi64_mask(k, _mm512_set1_epi64(16));
	__m512d a = _mm512_permutex2var_pd(_mm512_loadu_pd(p), k,
	    _mm512_loadu_pd(p + 8));
	__m512d b = _mm512_permutex2var_pd(_mm512_loadu_pd(p + 16), k,
	    _mm512_loadu_pd(p + 24));

	a = _mm512_mask_mov_pd(a, upper, b);
	a = _mm512_mask_xor_pd(a, minus, a, _mm512_set1_pd(-0.0));
	return _mm512_mask_mov_pd(a, none, _mm512_set1_pd(NO));
}

static inline void find_marks(struct marks *m, size_t i, const char *const *end)
{
	__m512i x = two_rows(end[i] - 32, end[i + 1] - 32);

	m->point[i / 2] = _mm512_cmpeq_epi8_mask(x, _mm512_set1_epi8('.'));
	m->minus[i / 2] = _mm512_cmpeq_epi8_mask(x, _mm512_set1_epi8('-'));
}

static inline void count(struct marks *m, double *scale, size_t i,
    const uint8_t *size)
{
	const __m256i one = _mm256_set1_epi32(1);
	__m256i n = _mm256_cvtepu8_epi32(
	    _mm_loadl_epi64((const void *)(size + i)));
	__m256i start = _mm256_sub_epi32(_mm256_set1_epi32(32), n);
	__m256i dots = _mm256_and_si256(_mm256_loadu_si256(
					    (void *)(m->point + i / 2)),
	    _mm256_sllv_epi32(_mm256_set1_epi32(-1), start));
	__mmask8 minus = _mm256_test_epi32_mask(_mm256_loadu_si256(
						    (void *)(m->minus + i / 2)),
	    _mm256_sllv_epi32(one, start));
	__mmask8 point = _mm256_test_epi32_mask(dots, dots);
	__m256i decimals = _mm256_lzcnt_epi32(dots);
	__m256i digits = _mm256_mask_sub_epi32(n, minus, n, one);

	digits = _mm256_mask_sub_epi32(digits, point, digits, one);
	_mm512_storeu_pd(scale + i,
	    scale_of(decimals, minus, _mm256_testn_epi32_mask(digits, digits)));
	last(decimals, m->fraction + i / 2);
	last(digits, m->digits + i / 2);
	m->many[i / PLAIN_GROUP] = _mm256_cmpgt_epi32_mask(digits,
				       _mm256_set1_epi32(15)) != 0;
}

/* Loads what stands before the ends twice, one byte apart: the decimals of the
 * first and the whole digits of the second are side by side, without the point. */
static inline __m512i rows_at(const struct marks *m, size_t i,
    const char *const *end)
{
	__m512i x = two_rows(end[i] - 33, end[i + 1] - 33);

	x = _mm512_mask_mov_epi8(x, m->fraction[i / 2],
	    two_rows(end[i] - 32, end[i + 1] - 32));
	return _mm512_maskz_sub_epi8(m->digits[i / 2], x,
	    _mm512_set1_epi8('0'));
}

static inline struct look set_group(const struct marks *m, struct rows *r,
    size_t i, const struct plain_places *at)
{
	__m512i odd = _mm512_setzero_si512();

	for (size_t k = i; k < i + PLAIN_GROUP; k += 4) {
		__m512i a = rows_at(m, k, at->end),
			b = rows_at(m, k + 2, at->end);

		odd = _mm512_max_epu8(odd, _mm512_max_epu8(a, b));
		_mm512_storeu_si512(r->high[k],
		    _mm512_shuffle_i64x2(a, b, 0x88));
		_mm512_storeu_si512(r->low[k],
		    _mm512_shuffle_i64x2(a, b, 0xdd));
	}
	return (struct look){
		.others = _mm512_cmpgt_epu8_mask(odd, _mm512_set1_epi8(9)) != 0,
		.many = m->many[i / PLAIN_GROUP],
	};
}

/* One after the other, for all numbers: masks that have just been stored one by one
 * would have to be waited for as a vector. */
static inline void set_rows(struct rows *r, struct look *look, size_t n,
    const struct plain_places *at)
{
	struct marks m;

	for (size_t i = 0; i < n; i += 2)
		find_marks(&m, i, at->end);
	for (size_t i = 0; i < n; i += PLAIN_GROUP)
		count(&m, r->scale, i, at->size);
	for (size_t i = 0; i < n; i += PLAIN_GROUP)
		look[i / PLAIN_GROUP] = set_group(&m, r, i, at);
}

#include "read_body.h"
#endif
