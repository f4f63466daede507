#include "vector.h"

/* Named as the copies of core/kernel; the best first. */
static const struct {
	const char *name;
	const struct plain_reader *copy;
} readers[] = {
#ifdef __x86_64__
	{ "avx512", &plain_avx512 },
	{ "avx2", &plain_avx2 },
#elif defined __aarch64__
	{ "neon", &plain_neon },
#endif
	{ "baseline", NULL },
};

static bool runs(const char *name)
{
#ifdef __x86_64__
	bool avx2 = __builtin_cpu_supports("avx2") &&
	    __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
	    __builtin_cpu_supports("popcnt");

	if (strcmp(name, "avx512") == 0)
		return avx2 && __builtin_cpu_supports("avx512bw") &&
		    __builtin_cpu_supports("avx512vl");
	if (strcmp(name, "avx2") == 0)
		return avx2;
#endif
	(void)name;
	return true;
}

static const struct plain_reader *reader;

bool plain_choose(const char *name)
{
	bool named = name == NULL;

	for (size_t i = 0; i < sizeof readers / sizeof *readers; i++) {
		named |= name != NULL && strcmp(readers[i].name, name) == 0;
		if (named && runs(readers[i].name)) {
			reader = readers[i].copy;
			return true;
		}
	}
	return false;
}

const struct plain_reader *plain_reader(void)
{
	return reader;
}
