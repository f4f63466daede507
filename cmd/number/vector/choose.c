/* SPDX-License-Identifier: MIT */
#include "vector.h"

#include "../../../core/points/kernel/kernel.h"

/* For any processor: number_write makes every text. */
static void no_texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t)
{
	(void)v, (void)single, (void)style;
	memset(t, 0, n * sizeof *t);
}

static const struct number_vector number_baseline = { no_texts };

static const struct {
	const struct number_vector *vector;
	const struct plain_reader *reader;
} copies[PROCESSORS] = {
	[PROCESSOR_BASELINE] = { &number_baseline, NULL },
#ifdef __x86_64__
	[PROCESSOR_AVX512] = { &number_avx512, &plain_avx512 },
	[PROCESSOR_AVX2] = { &number_avx2, &plain_avx2 },
#endif
#ifdef __AARCH64EL__
	[PROCESSOR_NEON] = { &number_neon, &plain_neon },
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
	copies[processor].vector->texts(v, (n + TEXTS - 1) / TEXTS * TEXTS,
	    single, style, t);
}

const struct plain_reader *plain_reader(void)
{
	return copies[processor].reader;
}
