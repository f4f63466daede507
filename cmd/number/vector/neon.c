/* SPDX-License-Identifier: MIT */
/* Reads and writes numbers on AArch64, of which NEON is a part. */
#ifdef __AARCH64EL__
#include "../../../core/points/kernel/simd_neon.h"
#include "loops.h"
#include "powers.h"

#define LOOPS number_loops_neon

typedef uint64_t lanes __attribute__((vector_size(8 * WIDTH)));
typedef uint16_t quarters __attribute__((vector_size(8 * WIDTH)));

#define IN_SET(set, s)                                                        \
	((uint64_t)mask(in_set(set, (s) + 32), in_set(set, (s) + 48)) << 32 | \
	    mask(in_set(set, s), in_set(set, (s) + 16)))
#define MATCH(x, c) equal_bits((const uint8_t *)&(x), c)
#define LARGER(a, b) PICK((row)((a) > (b)), a, b)
#define ANY_TOP_BIT(x) any_top_bit((const uint8_t *)&(x))

/* Returns a mask: bit i is set if byte i of low, high is 255, and clear if it is 0. */
static inline uint32_t mask(uint8x16_t low, uint8x16_t high)
{
	const uint8x16_t bit = vreinterpretq_u8_u64(vdupq_n_u64(0x8040201008040201));
	uint8x16_t sum = vpaddq_u8(vandq_u8(low, bit), vandq_u8(high, bit));

	sum = vpaddq_u8(sum, sum);
	sum = vpaddq_u8(sum, sum);
	return vgetq_lane_u32(vreinterpretq_u32_u8(sum), 0);
}

static inline uint8x16_t in_set(const struct byte_set *set, const char *s)
{
	uint8x16_t x = vld1q_u8((const uint8_t *)s);
	uint8x16_t low = vqtbl1q_u8(vld1q_u8(set->low), vandq_u8(x, vdupq_n_u8(15)));

	return vtstq_u8(low, vqtbl1q_u8(vld1q_u8(set->high), vshrq_n_u8(x, 4)));
}

static inline uint32_t equal_bits(const uint8_t *x, char c)
{
	uint8x16_t all = vdupq_n_u8((uint8_t)c);

	return mask(vceqq_u8(vld1q_u8(x), all), vceqq_u8(vld1q_u8(x + 16), all));
}

static inline int any_top_bit(const uint8_t *x)
{
	return vmaxvq_u8(vorrq_u8(vld1q_u8(x), vld1q_u8(x + 16))) > 127;
}

/* Joins digits to numbers of two, then four, then eight digits, by multiply-adds. */
static inline uint64x2_t join_row(const uint8_t *row)
{
	uint8x16_t x = vmulq_u8(vld1q_u8(row),
	    vreinterpretq_u8_u16(vdupq_n_u16(0x010a)));
	uint16x8_t pairs = vmulq_u16(vpaddlq_u8(x),
	    vreinterpretq_u16_u32(vdupq_n_u32(0x00010064)));
	uint32x4_t fours = vmulq_u32(vpaddlq_u16(pairs),
	    vreinterpretq_u32_u64(vdupq_n_u64(0x0000000100002710)));

	return vpaddlq_u32(fours);
}

static inline void join_digits(const uint8_t *rows, int half, lanes *high, lanes *low)
{
	uint64x2_t a = join_row(rows + 16 * half);
	uint64x2_t b = join_row(rows + 32 + 16 * half);

	*high = (lanes)vzip1q_u64(a, b);
	*low = (lanes)vzip2q_u64(a, b);
}

#define STORE_INTS(p, a) vst1_s32(p, vmovn_s64(vcvtq_s64_f64(a)))
#define FLOOR(a) vrndmq_f64(a)
#define NEAREST(a) vrndnq_f64(a)
#define REGISTER "w"
#define MUL32(a, n) ((lanes)vmull_n_u32(vmovn_u64((uint64x2_t)(a)), n))
#define HIGH16(a, n) ((quarters)upper_product_halves((uint16x8_t)(a), n))
#define BYTES_LOW(a) ((quarters)vzip1q_u8(vdupq_n_u8(0), (uint8x16_t)(a)))
#define BYTES_HIGH(a) ((quarters)vzip2q_u8(vdupq_n_u8(0), (uint8x16_t)(a)))

static inline uint16x8_t upper_product_halves(uint16x8_t a, uint16_t n)
{
	uint32x4_t low = vmull_n_u16(vget_low_u16(a), n);
	uint32x4_t high = vmull_high_n_u16(a, n);

	return vuzp2q_u16(vreinterpretq_u16_u32(low), vreinterpretq_u16_u32(high));
}

static inline void power_of_ten(V scale, V *hi, V *lo)
{
	const double(*power)[2] = powers - POWER_MIN;
	int64x2_t k = vcvtq_s64_f64(scale);
	V a = vld1q_f64(power[vgetq_lane_s64(k, 0)]);
	V b = vld1q_f64(power[vgetq_lane_s64(k, 1)]);

	*hi = vzip1q_f64(a, b);
	*lo = vzip2q_f64(a, b);
}

/* Returns a mask: bit i is set if byte i is not 0. Sums join the bits of 8 bytes. */
static inline uint16_t nonzero_bits(uint8x16_t digits)
{
	const uint8x8_t bit = vcreate_u8(0x8040201008040201);
	uint8x16_t bits = vandq_u8(vtstq_u8(digits, digits), vcombine_u8(bit, bit));

	return (
	    uint16_t)(vaddv_u8(vget_low_u8(bits)) | vaddv_u8(vget_high_u8(bits)) << 8);
}

static inline void store_digits(char *to, size_t step, uint16_t *nonzero, quarters even,
    quarters odd)
{
	uint8x16_t a = (uint8x16_t)even, b = (uint8x16_t)odd;

	nonzero[0] = nonzero_bits(a);
	nonzero[1] = nonzero_bits(b);
	vst1q_u8((uint8_t *)to, vorrq_u8(a, vdupq_n_u8('0')));
	vst1q_u8((uint8_t *)to + step, vorrq_u8(b, vdupq_n_u8('0')));
}

#include "read_body.h"
#include "write_body.h"
#endif
