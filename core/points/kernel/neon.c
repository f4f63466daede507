/* SPDX-License-Identifier: MIT */
/* For arm64, all of which have it. */
#ifdef __AARCH64EL__
#include "simd_neon.h"

#define COPY kernels_neon
#define PROCESSOR PROCESSOR_NEON
#include "copy.h"
#endif
