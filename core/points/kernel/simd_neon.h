/* SPDX-License-Identifier: MIT */
/* The operations of arm64, where every processor has NEON; copy.h describes them. MIN
 * and MAX compare and select: NEON's minimum and maximum are nan if a or b is nan. */
#include <arm_neon.h>

#define V float64x2_t
#define M uint64x2_t
#define WIDTH 2
#define LOAD(p) vld1q_f64(p)
#define STORE(p, a) vst1q_f64(p, a)
#define ALL(a) vdupq_n_f64(a)
#define FMA(a, b, c) vfmaq_f64(c, a, b)
#define SQRT(a) vsqrtq_f64(a)
#define ABS(a) vabsq_f64(a)
#define MIN(a, b) vbslq_f64(vcltq_f64(a, b), a, b)
#define MAX(a, b) vbslq_f64(vcgtq_f64(a, b), a, b)
#define LESS(a, b) vcltq_f64(a, b)
#define EQUAL(a, b) vceqq_f64(a, b)
#define MASK_BITS(m) \
	((unsigned)((vgetq_lane_u64(m, 0) & 1) | (vgetq_lane_u64(m, 1) & 2)))
#define SELECT(m, a, b) vbslq_f64(m, a, b)
#define ONLY(m, a) vreinterpretq_f64_u64(vandq_u64(m, vreinterpretq_u64_f64(a)))
