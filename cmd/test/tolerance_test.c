/* SPDX-License-Identifier: MIT */
/* What -t promises of each number printed, beside the truth of core/test. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/test/points.h"
#include "../call/arguments.h"

static struct tolerances tolerances(const char *list)
{
	char text[400];

	snprintf(text, sizeof text, "%s", list);
	return tolerances_of("tolerance", text);
}

static void decimals_come_from_the_text(void **state)
{
	static const struct {
		const char *text;
		int decimals;
	} cases[] = { { "1", 0 }, { "3", 0 }, { "1e150", 0 }, { "0.5", 1 },
		{ ".1", 1 }, { "0.01", 2 }, { "0.099", 2 }, { "1e-6", 6 },
		{ "9.99e-7", 7 }, { "0.00001e-1", 6 }, { "1000e-6", 3 },
		{ "1.e-3", 3 }, { "+0.20", 1 }, { "1E-23", 23 },
		{ "0.99999999999999999999999", 1 },
		{ "0.00999999999999999999999", 3 }, { "1e-150", 150 },
		{ "00010e-1", 0 }, { "0010e-2", 1 }, { "100e-0002", 0 } };

	(void)state;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
		assert_int_equal(tolerances(cases[i].text).decimals[0],
		    cases[i].decimals);
	struct tolerances t = tolerances("0.01,5,1e-9");

	assert_int_equal(t.n, 3);
	assert_int_equal(t.decimals[1], 0);
	assert_int_equal(t.decimals[2], 9);
	assert_int_equal(t.decimals[5], 9);
	assert_true(t.least == 1e-9 && t.within[5] == 1e-9);
	/* what rounding to these decimals takes */
	assert_true(
	    tolerance_left(&t, 0) <= 0.005 && tolerance_left(&t, 0) > 0.0049);
	assert_true(
	    tolerance_left(&t, 1) < 4.5 && tolerance_left(&t, 1) > 4.49);
}

static real real_of(const char *text)
{
	real r = number(0);

	mpfr_set_str(r, text, 10, MPFR_RNDN);
	return r;
}

/* So many decimals as text, plain or with an exponent. */
static int decimals(const char *text)
{
	const char *point = strchr(text, '.'), *e = strchr(text, 'e');
	const char *end = e != NULL ? e : text + strlen(text);

	return (point != NULL ? (int)(end - point) - 1 : 0) -
	    (e != NULL ? atoi(e + 1) : 0);
}

/* The text of v is within the tolerance of n / d, or the shortest of the nearest
 * double; it has no digit more. Returns whether it has fewer than the shortest. */
static bool check_text(double v, int n_decimals, const char *tolerance,
    struct form n, struct form d)
{
	char text[NUMBER_MAX + 1], shortest[NUMBER_MAX + 1];

	*number_write(text, v,
	    (struct number_style){ NUMBER_WITHIN, n_decimals }) = '\0';
	*number_write(shortest, v,
	    (struct number_style){ NUMBER_SHORTEST, 0 }) = '\0';

	real off = sub(over(n.value, d.value), real_of(text));
	bool fewer = strcmp(text, shortest) != 0;

	if (mpfr_cmpabs(off, real_of(tolerance)) > 0) {
		assert_false(fewer);
		assert_int_not_equal(truth_verdict(v, n, d, false), WRONG);
	}
	assert_true(decimals(text) <= n_decimals || decimals(text) <= 0);
	assert_true(strlen(text) <= strlen(shortest) ||
	    decimals(text) < decimals(shortest));
	if (decimals(text) > 0)
		assert_int_not_equal(text[strcspn(text, "e") - 1], '0');
	return fewer;
}

/* As sample_between gives them, as they are typed, with a first digit 1 often. */
static void sample_tolerance(double low, double high, char text[32])
{
	int digits = (int)sample_below(4);

	snprintf(text, 32, "%.*e", digits, pow(10, sample_between(low, high)));
	if (sample_below(3) == 0)
		snprintf(text, 32, "1e%d", (int)sample_between(low, high));
}

static void texts_are_within(void **state)
{
	static struct block b;
	static struct transform t;
	struct scene s;
	enum space from;
	size_t all = 0, fewer = 0;

	(void)state;
	points_choose(NULL);
	sample_seed(61);
	for (int k = 0; k < 900; k++) {
		char text[4][32], list[140];
		struct accuracy a = { .precision = PRECISION_EXACT };
		int mark = real_mark();
		struct truth truth = { 0 };

		for (int j = 0; j < 4; j++)
			sample_tolerance(k % 9 == 8 ? -149 : -12, 6, text[j]);
		if (!sample_transform(k % 3 * 4, &s, &from, &t, &truth))
			continue;
		snprintf(list, sizeof list, "%s,%s,%s,%s", text[0], text[1],
		    text[2], text[3]);
		struct tolerances typed = tolerances(list);

		for (int j = 0; j < 3; j++)
			a.tolerance[j] = tolerance_left(&typed, j);
		sample_points(&s, from, &b, POINTS);
		carry(&t, a, &b, POINTS);
		for (size_t i = 0; i < POINTS; i++) {
			int point = real_mark();
			struct image image;
			double p[4];

			point_of(&b, i, p);
			image_of(&truth, &t, p, &image);
			for (int j = 0; j < t.out; j++) {
				if (isnan(b.out[j][i]))
					continue;
				fewer += check_text(b.out[j][i],
				    typed.decimals[j], text[j], image.n[j],
				    image.d);
				all++;
			}
			real_release(point);
		}
		real_release(mark);
	}
	print_message("%zu of %zu numbers have fewer digits\n", fewer, all);
	assert_true(fewer > all / 10);
}

/* Sums that are midway between two texts, or a little off, whose double is worse
 * than exact: x + y + z with terms that cancel. */
static void ties_are_within(void **state)
{
	static struct block b;
	static struct transform t;
	double m[4][4] = { { 1, 1, 1 }, { 1, -1, 1 }, { 1, 1, -1 },
		{ 0, 0, 0, 1 } };
	struct truth truth = { 0 };

	(void)state;
	sample_seed(62);
	map_of_doubles(m, &t.map);
	transform_init(&t, SPACE_MODEL, SPACE_WORLD, false);
	set_matrix(truth_stage(&truth)->m, m);
	truth_compose(&truth);
	for (int k = 0; k < 500; k++) {
		int n = (int)sample_below(10), mark = real_mark();
		double unit = pow(10, -n), far = pow(10, sample_between(0, 6));
		struct accuracy a = { .precision = PRECISION_EXACT };
		char text[32];

		snprintf(text, sizeof text, "1e-%d", n);
		struct tolerances typed = tolerances(text);

		for (int j = 0; j < 3; j++)
			a.tolerance[j] = tolerance_left(&typed, j);
		for (int i = 0; i < POINTS; i++) {
			double tie = ((double)sample_below(2000) - 999.5) *
			    unit;

			b.in[0][i] = tie *
			    (1 + 0x1p-52 * ((double)sample_below(5) - 2));
			b.in[1][i] = rint(sample_between(-far, far));
			b.in[2][i] = -b.in[1][i];
		}
		carry(&t, a, &b, POINTS);
		for (size_t i = 0; i < POINTS; i++) {
			double p[4] = { b.in[0][i], b.in[1][i], b.in[2][i], 1 };

			for (int j = 0; j < 3; j++)
				check_text(b.out[j][i], n, text,
				    truth_column(&truth, j, p), form_of(1));
		}
		real_release(mark);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(decimals_come_from_the_text),
		cmocka_unit_test(texts_are_within),
		cmocka_unit_test(ties_are_within),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
