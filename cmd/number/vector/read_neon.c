/* SPDX-License-Identifier: MIT */
/* For arm64. */
#ifdef __AARCH64EL__
#include "../../../core/points/kernel/simd_neon.h"

#define READER plain_neon
#define READ read_neon
#define FIND find_neon

#define IN_SET(set, s)                                                        \
	((uint64_t)bits(in_set(set, (s) + 32), in_set(set, (s) + 48)) << 32 | \
	    bits(in_set(set, s), in_set(set, (s) + 16)))
#define DOTS(x) row_dots((const uint8_t *)&(x))
#define LARGER(a, b) PICK((row)((a) > (b)), a, b)
#define ANY_TOP_BIT(x) any_top_bit((const uint8_t *)&(x))
#define EIGHTS(rows, first, rest) eights(rows, &(first), &(rest))

#include "../plain.h"

/* Bit i: whether byte i of low and high, which are 0 or 255 each, is set. */
static inline uint32_t bits(uint8x16_t low, uint8x16_t high)
{
	const uint8x16_t bit = vreinterpretq_u8_u64(
	    vdupq_n_u64(0x8040201008040201));
	uint8x16_t sum = vpaddq_u8(vandq_u8(low, bit), vandq_u8(high, bit));

	sum = vpaddq_u8(sum, sum);
	sum = vpaddq_u8(sum, sum);
	return vgetq_lane_u32(vreinterpretq_u32_u8(sum), 0);
}

static inline uint8x16_t in_set(const struct byte_set *set, const char *s)
{
	uint8x16_t x = vld1q_u8((const uint8_t *)s);
	uint8x16_t low = vqtbl1q_u8(vld1q_u8(set->low),
	    vandq_u8(x, vdupq_n_u8(15)));

	return vtstq_u8(low, vqtbl1q_u8(vld1q_u8(set->high), vshrq_n_u8(x, 4)));
}

static inline uint32_t row_dots(const uint8_t *x)
{
	return bits(vceqq_u8(vld1q_u8(x), vdupq_n_u8('.')),
	    vceqq_u8(vld1q_u8(x + 16), vdupq_n_u8('.')));
}

static inline int any_top_bit(const uint8_t *x)
{
	return vmaxvq_u8(vorrq_u8(vld1q_u8(x), vld1q_u8(x + 16))) > 127;
}

/* Two digits, then four, then eight by multiplication and addition. */
static inline uint64x2_t eights_of(const uint8_t *row)
{
	uint8x16_t x = vmulq_u8(vld1q_u8(row),
	    vreinterpretq_u8_u16(vdupq_n_u16(0x010a)));
	uint16x8_t pairs = vmulq_u16(vpaddlq_u8(x),
	    vreinterpretq_u16_u32(vdupq_n_u32(0x00010064)));
	uint32x4_t fours = vmulq_u32(vpaddlq_u16(pairs),
	    vreinterpretq_u32_u64(vdupq_n_u64(0x0000000100002710)));

	return vpaddlq_u32(fours);
}

static inline void eights(const uint8_t *rows, void *first, void *rest)
{
	uint64x2_t a = eights_of(rows), b = eights_of(rows + 32);

	vst1q_u64(first, vzip1q_u64(a, b));
	vst1q_u64(rest, vzip2q_u64(a, b));
}

#include "read_body.h"
#endif
