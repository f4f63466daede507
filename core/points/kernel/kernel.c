/* SPDX-License-Identifier: MIT */
#include "kernel.h"

#ifdef __x86_64__
#include <cpuid.h>
#endif
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
 * processor use, in this folder and in cmd/number/vector. __builtin_cpu_supports would
 * ask at the start of every call: 50 us on a virtual machine, where cpuid is slow. */
static bool can_run(enum processor processor)
{
#ifdef __x86_64__
	const unsigned first = bit_FMA | bit_OSXSAVE;
	unsigned seventh = bit_AVX2, saved = 0x06, a, b, c, d;

	if (processor == PROCESSOR_BASELINE)
		return true;
	if (processor == PROCESSOR_AVX512) {
		seventh |= bit_AVX512F | bit_AVX512BW | bit_AVX512CD | bit_AVX512DQ |
		    bit_AVX512VL;
		saved = 0xe6;
	}
	if (!__get_cpuid(1, &a, &b, &c, &d) || (c & first) != first ||
	    !__get_cpuid_count(7, 0, &a, &b, &c, &d) || (b & seventh) != seventh)
		return false;
	/* the system must save these registers: bits 1, 2 and 5 to 7 of XCR0 */
	__asm__("xgetbv" : "=a"(a), "=d"(d) : "c"(0));
	return (a & saved) == saved;
#else
	(void)processor;
	return true;
#endif
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
