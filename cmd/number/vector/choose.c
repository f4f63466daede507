#include "vector.h"

/* For any processor: number_write makes every text. */
static void no_texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t)
{
	(void)v, (void)single, (void)style;
	memset(t, 0, n * sizeof *t);
}

static const struct number_vector number_baseline = { no_texts };

/* What a copy named as one of core/kernel's needs; the best first. Where the
 * named one cannot run, the next that can stands in for it: an older processor
 * with AVX-512 has not all that its copy here takes. */
static const struct {
	const char *name;
	const struct number_vector *copy;
} copies[] = {
	{ "baseline", &number_baseline },
};

static bool runs(const char *name)
{
	return strcmp(name, "baseline") == 0;
}

static const struct number_vector *vector = &number_baseline;

bool number_choose(const char *name)
{
	bool named = name == NULL;

	for (size_t i = 0; i < sizeof copies / sizeof *copies; i++) {
		named |= name != NULL && strcmp(copies[i].name, name) == 0;
		if (named && runs(copies[i].name)) {
			vector = copies[i].copy;
			plain_choose(name);
			return true;
		}
	}
	return plain_choose(name);
}

void number_texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t)
{
	vector->texts(v, (n + 63) / 64 * 64, single, style, t);
}
