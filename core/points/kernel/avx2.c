/* SPDX-License-Identifier: MIT */
/* The kernels for x86-64 with AVX2 and FMA: compile with -mavx2 -mfma. */
#ifdef __AVX2__
#include "simd_avx2.h"

#define KERNELS_NAME kernels_avx2
#define PROCESSOR PROCESSOR_AVX2
#include "copy.h"
#endif
