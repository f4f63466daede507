/* SPDX-License-Identifier: MIT */
#include "kernel.h"

#include <stdbool.h>
#include <string.h>

/* The copies that this program has, the best first. */
static const struct kernels *const copies[] = {
#ifdef __x86_64__
	&kernels_avx512,
	&kernels_avx2,
#endif
#ifdef __AARCH64EL__
	&kernels_neon,
#endif
	&kernels_baseline,
};

/* Returns true if this processor has all instructions of the copies for one kind of
 * processor, here and in cmd/number/vector. */
static bool is_here(enum processor processor)
{
	switch (processor) {
	case PROCESSOR_BASELINE:
	case PROCESSOR_NEON:
		return true;
#ifdef __x86_64__
	case PROCESSOR_AVX2:
		return __builtin_cpu_supports("avx2") &&
		    __builtin_cpu_supports("fma");
	case PROCESSOR_AVX512:
		return __builtin_cpu_supports("avx512f") &&
		    __builtin_cpu_supports("avx512bw") &&
		    __builtin_cpu_supports("avx512cd") &&
		    __builtin_cpu_supports("avx512dq") &&
		    __builtin_cpu_supports("avx512vl") &&
		    __builtin_cpu_supports("fma");
#else
	case PROCESSOR_AVX2:
	case PROCESSOR_AVX512:
#endif
	case PROCESSORS:
		break;
	}
	return false;
}

const struct kernels *kernels_find(const char *name)
{
	static const char *const names[PROCESSORS] = {
		[PROCESSOR_BASELINE] = "baseline",
		[PROCESSOR_AVX2] = "avx2",
		[PROCESSOR_AVX512] = "avx512",
		[PROCESSOR_NEON] = "neon",
	};

	for (size_t i = 0; i < sizeof copies / sizeof *copies; i++) {
		enum processor processor = copies[i]->processor;

		if ((name == NULL || strcmp(names[processor], name) == 0) &&
		    is_here(processor))
			return copies[i];
	}
	return NULL;
}
