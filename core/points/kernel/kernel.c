/* SPDX-License-Identifier: MIT */
#include "kernel.h"

#include <string.h>

/* The kernels that this program has, the best first. */
static const struct {
	const char *name;
	const struct kernels *kernels;
} copies[] = {
#ifdef __x86_64__
	{ "avx512", &kernels_avx512 },
	{ "avx2", &kernels_avx2 },
#endif
#ifdef __AARCH64EL__
	{ "neon", &kernels_neon },
#endif
	{ "baseline", &kernels_baseline },
};

static const struct kernels *chosen = &kernels_baseline;

/* Returns true if this processor has all instructions that files for the given kind of
 * processor use, in this folder and in cmd/number/vector. */
static bool can_run(enum processor processor)
{
#ifdef __x86_64__
	if (processor != PROCESSOR_BASELINE &&
	    !(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")))
		return false;
	if (processor == PROCESSOR_AVX512)
		return __builtin_cpu_supports("avx512f") &&
		    __builtin_cpu_supports("avx512bw") &&
		    __builtin_cpu_supports("avx512cd") &&
		    __builtin_cpu_supports("avx512dq") &&
		    __builtin_cpu_supports("avx512vl");
#endif
	(void)processor;
	return true;
}

bool kernels_choose(const char *name)
{
	for (size_t i = 0; i < sizeof copies / sizeof *copies; i++)
		if ((name == NULL || strcmp(copies[i].name, name) == 0) &&
		    can_run(copies[i].kernels->processor)) {
			chosen = copies[i].kernels;
			return true;
		}
	return false;
}

const struct kernels *kernels_chosen(void)
{
	return chosen;
}
