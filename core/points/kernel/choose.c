/* SPDX-License-Identifier: MIT */
#include "kernel.h"

#include <stdbool.h>
#include <string.h>

static const struct {
	const char *name;
	const struct kernels *copy;
} copies[] = {
/* the best first */
#ifdef __x86_64__
	{ "avx512", &kernels_avx512 },
	{ "avx2", &kernels_avx2 },
#endif
#ifdef __AARCH64EL__
	{ "neon", &kernels_neon },
#endif
	{ "baseline", &kernels_baseline },
};

static bool runs(const char *name)
{
#ifdef __x86_64__
	if (strcmp(name, "avx512") == 0)
		return __builtin_cpu_supports("avx512f") != 0;
	if (strcmp(name, "avx2") == 0)
		return __builtin_cpu_supports("avx2") &&
		    __builtin_cpu_supports("fma");
#endif
#ifdef __AARCH64EL__
	if (strcmp(name, "neon") == 0)
		return true;
#endif
	return strcmp(name, "baseline") == 0;
}

const struct kernels *kernels_find(const char *name)
{
	for (size_t i = 0; i < sizeof copies / sizeof *copies; i++)
		if ((name == NULL || strcmp(copies[i].name, name) == 0) &&
		    runs(copies[i].name))
			return copies[i].copy;
	return NULL;
}
