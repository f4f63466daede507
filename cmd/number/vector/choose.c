/* SPDX-License-Identifier: MIT */
#include "vector.h"

#include "../../../core/points/transform.h"

static const struct {
	number_writer *writer;
	const struct plain_reader *reader;
} copies[PROCESSORS] = {
#ifdef __x86_64__
	[PROCESSOR_AVX512] = { number_texts_avx512, &plain_avx512 },
	[PROCESSOR_AVX2] = { number_texts_avx2, &plain_avx2 },
#endif
#ifdef __AARCH64EL__
	[PROCESSOR_NEON] = { number_texts_neon, &plain_neon },
#endif
};

void number_texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t)
{
	number_writer *write = copies[points_kernels()->processor].writer;

	if (write != NULL)
		write(v, (n + TEXTS - 1) / TEXTS * TEXTS, single, style, t);
	else /* number_write makes every text */
		memset(t, 0, n * sizeof *t);
}

const struct plain_reader *plain_reader(void)
{
	return copies[points_kernels()->processor].reader;
}
