/* SPDX-License-Identifier: MIT */
#include "vector.h"

/* For any processor: number_write makes every text. */
static void no_texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t)
{
	(void)v, (void)single, (void)style;
	memset(t, 0, n * sizeof *t);
}

static const struct number_vector number_baseline = { no_texts };

/* The best first, named as core/kernel's. Where the named one can't run, the next
 * that can stands in for it: the first processors with AVX-512 have not all that
 * its copy takes here. */
static const struct {
	const char *name;
	const struct number_vector *copy;
	const struct plain_reader *reader;
} copies[] = {
#ifdef __x86_64__
	{ "avx512", &number_avx512, &plain_avx512 },
	{ "avx2", &number_avx2, &plain_avx2 },
#endif
#ifdef __AARCH64EL__
	{ "neon", &number_neon, &plain_neon },
#endif
	{ "baseline", &number_baseline, NULL },
};

static bool runs(const char *name)
{
#ifdef __x86_64__
	if (strcmp(name, "avx512") == 0)
		return __builtin_cpu_supports("avx512f") &&
		    __builtin_cpu_supports("avx512bw") &&
		    __builtin_cpu_supports("avx512cd") &&
		    __builtin_cpu_supports("avx512dq") &&
		    __builtin_cpu_supports("avx512vl") &&
		    __builtin_cpu_supports("fma");
	if (strcmp(name, "avx2") == 0)
		return __builtin_cpu_supports("avx2") &&
		    __builtin_cpu_supports("fma");
#endif
	return strcmp(name, "baseline") == 0 || strcmp(name, "neon") == 0;
}

static const struct number_vector *vector = &number_baseline;
static const struct plain_reader *reader;

bool number_choose(const char *name)
{
	bool named = name == NULL;

	for (size_t i = 0; i < sizeof copies / sizeof *copies; i++) {
		named |= name != NULL && strcmp(copies[i].name, name) == 0;
		if (named && runs(copies[i].name)) {
			vector = copies[i].copy;
			reader = copies[i].reader;
			return true;
		}
	}
	return false;
}

void number_texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t)
{
	vector->texts(v, (n + TEXTS - 1) / TEXTS * TEXTS, single, style, t);
}

const struct plain_reader *plain_reader(void)
{
	return reader;
}
