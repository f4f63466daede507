/* SPDX-License-Identifier: MIT */
#include "vector.h"

#include "../../../core/points/kernel/kernel.h"

/* Without a writer number_write makes every text. */
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

static enum processor processor = PROCESSOR_BASELINE;

bool number_choose(const char *name)
{
	const struct kernels *found = kernels_find(name);

	if (found != NULL)
		processor = found->processor;
	return found != NULL;
}

void number_texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t)
{
	number_writer *write = copies[processor].writer;

	if (write != NULL)
		write(v, (n + TEXTS - 1) / TEXTS * TEXTS, single, style, t);
	else
		memset(t, 0, n * sizeof *t);
}

const struct plain_reader *plain_reader(void)
{
	return copies[processor].reader;
}
