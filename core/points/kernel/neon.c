/* SPDX-License-Identifier: MIT */
/* For arm64, all of which have it. Its own minimum of a number and nan is nan. */
#ifdef __AARCH64EL__
#include <arm_neon.h>

#define COPY kernels_neon
#define PROCESSOR PROCESSOR_NEON

#define V float64x2_t
#define WIDTH 2
#define LOAD(p) vld1q_f64(p)
#define STORE(p, a) vst1q_f64(p, a)
#define ALL(a) vdupq_n_f64(a)
#define FMA(a, b, c) vfmaq_f64(c, a, b)
#define SQRT(a) vsqrtq_f64(a)
#define ABS(a) vabsq_f64(a)
#define MIN(a, b) vbslq_f64(vcltq_f64(a, b), a, b)
#define MAX(a, b) vbslq_f64(vcgtq_f64(a, b), a, b)
#define MADD FMA
#define SAME(a, b, c)          \
	vreinterpretq_f64_u64( \
	    vandq_u64(vceqq_f64(a, b), vreinterpretq_u64_f64(c)))
#define IS_POSITIVE(a) \
	(vminvq_u32(vreinterpretq_u32_u64(vcgtzq_f64(a))) == 0xffffffff)
#define CHOOSE(a, b, c) vbslq_f64(vcgtzq_f64(a), b, c)

#include "copy.h"
#endif
