/* SPDX-License-Identifier: MIT */
/* For AArch64, of which NEON is a part. */
#ifdef __AARCH64EL__
#include "../../../core/points/kernel/simd_neon.h"
#include "powers.h"
#include "vector.h"

#define I uint64x2_t
#define STORE_INTS(p, a) vst1_s32(p, vmovn_s64(vcvtq_s64_f64(a)))
#define FLOOR(a) vrndmq_f64(a)
#define NEAREST(a) vrndnq_f64(a)
#define ALL_BITS(a) vdupq_n_u64((uint64_t)(a))
#define REGISTER "w"
#define SHR(a, n) vshrq_n_u64(a, n)
#define QUARTERS(a) vreinterpretq_u16_u64(a)
#define WHOLE(a) vreinterpretq_u64_u16(a)
#define SHR16(a, n) WHOLE(vshrq_n_u16(QUARTERS(a), n))
#define MUL32(a, b) vmull_u32(vmovn_u64(a), vmovn_u64(b))
#define MUL16(a, b) WHOLE(vmulq_u16(QUARTERS(a), QUARTERS(b)))
#define HIGH16(a, b) WHOLE(high_halves(QUARTERS(a), QUARTERS(b)))
#define BYTES(a) vreinterpretq_u8_u64(a)
#define BYTES_LOW(a) vreinterpretq_u64_u8(vzip1q_u8(vdupq_n_u8(0), BYTES(a)))
#define BYTES_HIGH(a) vreinterpretq_u64_u8(vzip2q_u8(vdupq_n_u8(0), BYTES(a)))

static inline uint16x8_t high_halves(uint16x8_t a, uint16x8_t b)
{
	uint32x4_t low = vmull_u16(vget_low_u16(a), vget_low_u16(b));
	uint32x4_t high = vmull_high_u16(a, b);

	return vuzp2q_u16(vreinterpretq_u16_u32(low),
	    vreinterpretq_u16_u32(high));
}

struct tens {
	const double (*pair)[2]; /* of 10^0 */
};

static inline struct tens load_tens(void)
{
	return (struct tens){ powers - POWER_MIN };
}

static inline void power_of_ten(const struct tens *t, V scale, V *hi, V *lo)
{
	int64x2_t k = vcvtq_s64_f64(scale);
	V a = vld1q_f64(t->pair[vgetq_lane_s64(k, 0)]);
	V b = vld1q_f64(t->pair[vgetq_lane_s64(k, 1)]);

	*hi = vzip1q_f64(a, b);
	*lo = vzip2q_f64(a, b);
}

/* A bit for each byte that isn't 0: of each half, the sum of its bytes' bits. */
static inline uint16_t nonzero_bits(uint8x16_t digits)
{
	const uint8x8_t bit = vcreate_u8(0x8040201008040201);
	uint8x16_t bits = vandq_u8(vtstq_u8(digits, digits),
	    vcombine_u8(bit, bit));

	return (uint16_t)(vaddv_u8(vget_low_u8(bits)) |
	    vaddv_u8(vget_high_u8(bits)) << 8);
}

static inline void store_digits(char *to, size_t step, uint16_t *nonzero, I a,
    I b)
{
	nonzero[0] = nonzero_bits(BYTES(a));
	nonzero[1] = nonzero_bits(BYTES(b));
	vst1q_u8((uint8_t *)to, vorrq_u8(BYTES(a), vdupq_n_u8('0')));
	vst1q_u8((uint8_t *)to + step, vorrq_u8(BYTES(b), vdupq_n_u8('0')));
}

#define WRITER number_texts_neon
#include "write_body.h"
#endif
