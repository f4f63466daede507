/* SPDX-License-Identifier: MIT */
/* number_texts writes many numbers as number_write writes each, in every copy of the
 * loops that this processor runs. The command texts_test COUNT tests COUNT numbers for
 * each style. */
#include "random.h"

#include <float.h>

#include "../../core/points/transform.h"
#include "../number/vector/loops.h"

enum { BLOCK = 512, SURPLUS = 64, GUARD = 64 };

static const char *const copies[] = { "avx512", "avx2", "neon", "baseline" };

static const struct number_style styles[] = {
	{ NUMBER_SHORTEST, 0 },
	{ NUMBER_DECIMALS, 0 },
	{ NUMBER_DECIMALS, 2 },
	{ NUMBER_DECIMALS, 6 },
	{ NUMBER_DECIMALS, 15 },
	{ NUMBER_DECIMALS, 16 },
	{ NUMBER_DIGITS, 9 },
	{ NUMBER_DIGITS, 1 },
	{ NUMBER_DIGITS, 3 },
	{ NUMBER_DIGITS, 6 },
	{ NUMBER_DIGITS, 12 },
	{ NUMBER_DIGITS, 15 },
	{ NUMBER_DECIMALS, 13 },
	{ NUMBER_DECIMALS, 14 },
	{ NUMBER_DIGITS, 16 },
	{ NUMBER_DIGITS, 17 },
};

static long count = 60000;

/* Returns a random number from 0 to below 1. */
static double random_unit(void)
{
	return (double)(next_random() >> 11) / 0x1p53;
}

static double from_bits(uint64_t bits)
{
	double v;

	memcpy(&v, &bits, sizeof v);
	return v;
}

/* Returns v, or the double or float next to v. */
static double neighbour_or_same(double v, bool single)
{
	double to[] = { -HUGE_VAL, v, HUGE_VAL };
	int way = random_below(3);

	if (way == 1)
		return v;
	return single ? (double)nextafterf((float)v, (float)to[way]) :
			nextafter(v, to[way]);
}

/* Returns a number next to a short end of the interval that rounds to it: an odd half
 * of the number's last place, which a power of ten divides. */
static double short_end(bool single)
{
	int digits = single ? FLT_MANT_DIG : DBL_MANT_DIG;
	int tens = 1 + random_below(5), log2 = digits + tens + random_below(10);
	uint64_t ten = 1;

	if (log2 > 63)
		log2 = 63;
	for (int i = 0; i < tens; i++)
		ten *= 10;
	int place = log2 - digits + 1;
	uint64_t x = next_random() >> (63 - log2) | 1ull << log2;

	x = x / ten * ten;
	for (int i = 0; i < 1 << 12; i++, x -= ten)
		if ((x & ((1ull << place) - 1)) == 1ull << (place - 1))
			break;
	x += random_below(2) ? 1ull << (place - 1) : -(1ull << (place - 1));
	return (double)x;
}

/* Returns a number with up to 6 binary places. Its last decimal is 5, so that it is a
 * tie at one decimal less. */
static double late_tie(bool single)
{
	int digits = single ? FLT_MANT_DIG : DBL_MANT_DIG;
	double whole = (double)(next_random() >> (64 - digits) | 1ull << (digits - 1));

	return ldexp(whole, -1 - random_below(6));
}

static double any_number(bool single)
{
	double v = 2 * random_unit() - 1;

	switch (random_below(14)) {
	case 0:
		return from_bits(next_random());
	case 1: /* magnitudes that are written without an exponent */
		return ldexp(v, random_below(92) - 20);
	case 2: /* up to 15 decimals */
		return floor(v * pow(10, random_below(16))) / pow(10, random_below(16));
	case 3:
		return (double)(int64_t)(next_random() >> (1 + random_below(63)));
	case 4: /* integers, and numbers that are ties for few decimals */
		return floor(ldexp(v, random_below(70))) / pow(2, random_below(30));
	case 5: /* powers of two: the double below is half as far as that above */
		return neighbour_or_same(ldexp(v < 0 ? -1 : 1,
					     random_below(2098) - 1074),
		    single);
	case 6:
		return neighbour_or_same(ldexp(1, random_below(93) - 20), single);
	case 7:
		return neighbour_or_same(pow(10, random_below(32) - 9), single);
	case 8: /* next to a tie of up to 15 decimals */
		return neighbour_or_same((floor(v * pow(10, random_below(9))) + 0.5) /
			pow(10, random_below(16)),
		    single);
	case 9:
		return short_end(single);
	case 10:
		return late_tie(single);
	case 11: /* subnormal */
		return from_bits(next_random() >> (12 + random_below(52)));
	case 12: /* next to a number of up to three digits */
		return neighbour_or_same((double)(1 + random_below(999)) *
			pow(10, random_below(28) - 9),
		    single);
	default: {
		const double few[] = { 0, -0.0, 1, -1, 0.5, HUGE_VAL, -HUGE_VAL,
			(double)NAN, 1e-6, 1e21, 1e-5, 0.1, 999999.5, 9007199254740992,
			4503599627370496, 0.0000005, 2.5e-7, 9.5e-7, 0x1p57, 1e15 };

		return neighbour_or_same(few[random_below(sizeof few / sizeof *few)],
		    single);
	}
	}
}

static void fill_random(double v[BLOCK + SURPLUS], bool single)
{
	for (int i = 0; i < BLOCK + SURPLUS; i++) {
		v[i] = any_number(single);
		if (random_below(4) == 0)
			v[i] = -v[i];
		if (single)
			v[i] = (double)(float)v[i];
	}
}

static char *write_one(char *s, double v, bool single, struct number_style style)
{
	return single ? number_write_float(s, (float)v, style) :
			number_write(s, v, style);
}

static void check_texts(const char *copy, const double *v, size_t n, bool single,
    struct number_style style, char (*expected)[NUMBER_MAX + 1])
{
	struct number_text t[BLOCK + SURPLUS], none;
	size_t room = (n + 63) / 64 * 64;
	char text[NUMBER_MAX + GUARD];

	memset(t, '#', sizeof t);
	memset(&none, '#', sizeof none);
	number_texts(v, n, single, style, t);
	assert_memory_equal(t + room, &none, sizeof none);
	for (size_t i = 0; i < n; i++) {
		char *end = number_text_put(text, &t[i], v[i], single, style);

		*end = '\0';
		if (strcmp(text, expected[i]) != 0)
			fail_msg("%s, style %u %d%s: %a: came %s, "
				 "expected %s",
			    copy, style.kind, style.n, single ? ", float" : "", v[i],
			    text, expected[i]);
	}
}

static void check_style(struct number_style style, bool single)
{
	static char expected[BLOCK][NUMBER_MAX + 1];
	double v[BLOCK + SURPLUS];

	for (long k = 0; k < count; k += BLOCK) {
		size_t n = (size_t)(BLOCK - random_below(SURPLUS));

		fill_random(v, single);
		for (size_t i = 0; i < n; i++)
			*write_one(expected[i], v[i], single, style) = '\0';
		for (size_t c = 0; c < sizeof copies / sizeof *copies; c++)
			if (kernels_choose(copies[c]))
				check_texts(copies[c], v, n, single, style, expected);
	}
}

static void texts_are_those_of_number_write(void **unused)
{
	(void)unused;
	for (size_t i = 0; i < sizeof styles / sizeof *styles; i++) {
		check_style(styles[i], false);
		check_style(styles[i], true);
	}
}

/* If there are vector loops, they make the texts of nearly all numbers that points
 * have. */
static void vector_makes_usual_texts(void **unused)
{
	const struct number_style usual[] = { { NUMBER_SHORTEST, 0 },
		{ NUMBER_DECIMALS, 6 }, { NUMBER_DIGITS, 6 } };
	/* limit for each style: larger numbers are too long or are ties, which are
	 * left to the scalar code */
	const double limit[] = { 1e9, 9e9, 1e6 };
	double v[BLOCK];
	struct number_text t[BLOCK];

	(void)unused;
	for (size_t c = 0; c < 3; c++) {
		if (!kernels_choose(copies[c]))
			continue;
		number_texts(memset(v, 0, sizeof v), BLOCK, false, usual[0], t);
		if (t->layout == 0)
			continue; /* this copy has no vector loops */
		for (size_t k = 0; k < 6; k++) {
			for (int i = 0; i < BLOCK; i++)
				v[i] = (double)(float)ldexp(2 * random_unit() - 1,
				    random_below(42) - 18);
			number_texts(v, BLOCK, k % 2, usual[k / 2], t);
			for (int i = 0; i < BLOCK; i++)
				if (t[i].layout == 0 && fabs(v[i]) > 0x1p-17 &&
				    fabs(v[i]) < limit[k / 2])
					fail_msg("%a: expected a text by the "
						 "vector loops, came none",
					    v[i]);
		}
	}
}

static void copies_are_chosen_by_name(void **unused)
{
	(void)unused;
	assert_true(kernels_choose(NULL));
	assert_true(kernels_choose("baseline"));
	assert_false(kernels_choose("pentium"));
}

int main(int argc, char **argv)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(texts_are_those_of_number_write),
		cmocka_unit_test(vector_makes_usual_texts),
		cmocka_unit_test(copies_are_chosen_by_name),
	};

	if (argc > 1)
		count = atol(argv[1]);
	return cmocka_run_group_tests(tests, NULL, NULL);
}
