/* SPDX-License-Identifier: MIT */
/* The kernels for arm64, where every processor has NEON. */
#ifdef __AARCH64EL__
#include "simd_neon.h"

#define KERNELS_NAME kernels_neon
#define PROCESSOR PROCESSOR_NEON
#include "copy.h"
#endif
