/* SPDX-License-Identifier: MIT */
#include "loops.h"

#include "../../../core/points/kernel/kernel.h"

const struct number_loops *number_loops_chosen(void)
{
	static const struct number_loops *const copies[PROCESSORS] = {
#ifdef __x86_64__
		[PROCESSOR_AVX512] = &number_loops_avx512,
		[PROCESSOR_AVX2] = &number_loops_avx2,
#endif
#ifdef __AARCH64EL__
		[PROCESSOR_NEON] = &number_loops_neon,
#endif
	};

	return copies[kernels_chosen()->processor];
}

void number_texts(const double *v, size_t n, bool single, struct number_style style,
    struct number_text *t)
{
	const struct number_loops *loops = number_loops_chosen();

	if (loops != NULL)
		loops->write(v, n, single, style, t);
	else /* number_write makes every text */
		memset(t, 0, n * sizeof *t);
}
