/* SPDX-License-Identifier: MIT */
/* The kernels for x86-64 with AVX-512: compile with -mavx512f -mfma. */
#ifdef __AVX512F__
#include "simd_avx512.h"

#define KERNELS_NAME kernels_avx512
#define PROCESSOR PROCESSOR_AVX512
#include "copy.h"
#endif
