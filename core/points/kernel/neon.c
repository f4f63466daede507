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

#define F float32x4_t
#define F_WIDTH 4
#define F_HALF(p, o) vcvt_f32_f64(vsubq_f64(vld1q_f64(p), vdupq_n_f64(o)))
#define F_NEAR(p, o) vcombine_f32(F_HALF(p, o), F_HALF((p) + 2, o))
#define F_STORE(p, a)                                 \
	(vst1q_f64(p, vcvt_f64_f32(vget_low_f32(a))), \
	    vst1q_f64((p) + 2, vcvt_high_f64_f32(a)))
#define F_LOAD(p) vld1q_f32(p)
#define F_SAVE(p, a) vst1q_f32(p, a)
#define F_FAR_HALF(p, o) \
	vcvt_f32_f64(vsubq_f64(vcvt_f64_f32(vld1_f32(p)), vdupq_n_f64(o)))
#define F_FAR(p, o) vcombine_f32(F_FAR_HALF(p, o), F_FAR_HALF((p) + 2, o))
#define F_ALL(a) vdupq_n_f32(a)
#define F_FMA(a, b, c) vfmaq_f32(c, a, b)
#define F_POSITIVE(a, b) vbslq_f32(vcgtzq_f32(a), b, vdupq_n_f32(NAN))

#include "copy.h"
#endif
