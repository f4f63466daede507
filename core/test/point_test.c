#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "points.h"

static const char *const copies[] = { "baseline", "avx2", "avx512" };

/* A scene with all that project needs, or false where it is degenerate. */
static bool sample_transform(struct scene *s, int e, enum space *from,
    enum space *to, struct transform *t)
{
	sample_scene(s, e);
	s->has_viewport = true;
	*from = (enum space)sample_below(6);
	*to = (enum space)sample_below(6);
	return scene_transform(s, *from, *to,
		   *from != SPACE_DEVICE && sample_below(4) == 0, t) == NULL;
}

/* Counts coordinates, and those that are not the nearest double. */
static void check_exact(int e, unsigned seed, int scenes, size_t count[2])
{
	static struct block b;
	struct scene s;
	struct transform t;
	enum space from, to;

	sample_seed(seed);
	for (int k = 0; k < scenes; k++) {
		int mark = real_mark();
		struct truth truth = { 0 };

		if (!sample_transform(&s, e, &from, &to, &t))
			continue;
		sample_points(&s, from, &b, POINTS);
		carry(&t, (struct accuracy){ PRECISION_EXACT, 0 }, &b, POINTS);
		truth_scene(&s, from, to, &truth);
		for (size_t i = 0; i < POINTS; i++) {
			int point = real_mark();
			real q[4], sum[4];

			if (!exact_image(&truth, &t, &b, i, q, sum)) {
				real_release(point);
				continue;
			}
			for (int j = 0; j < t.out; j++) {
				double kappa = truth_kappa(q, sum, j, t.divide);
				real exact = t.divide ? over(q[j], q[3]) : q[j];
				double magnitude = fabs(
				    mpfr_get_d(exact, MPFR_RNDN));
				double lost = kappa * POINTS_BOUND;
				double error = ulps(b.out[j][i], exact);

				/* all digits may be lost; no digits below */
				if (!(kappa < 0x1p90) || magnitude < 0x1p-960 ||
				    magnitude > 0x1p960)
					continue;
				if (b.out[j][i] == 0 && kappa > 0x1p95)
					continue;
				double excess = (error - 0.5) / lost;

				count[0]++;
				count[1] += error > 0.5;
				if (!(excess <= 1))
					print_error(
					    "scene %d from %d to %d "
					    "coordinate %d: %.17g is %g ulp "
					    "off, kappa %g\n",
					    k, from, to, j, b.out[j][i], error,
					    kappa);
				assert_true(excess <= 1);
			}
			real_release(point);
		}
		real_release(mark);
	}
}

/* Every copy that this processor runs, against MPFR. */
static void exact_keeps_its_bound(void **state)
{
	(void)state;
	for (size_t c = 0; c < sizeof copies / sizeof *copies; c++) {
		size_t count[2] = { 0, 0 };

		if (!points_choose(copies[c]))
			continue;
		check_exact(0, 1, 250, count);
		check_exact(3, 2, 250, count);
		check_exact(9, 3, 250, count);
		print_message("%s: %zu coordinates, %zu not the nearest "
			      "double\n",
		    copies[c], count[0], count[1]);
		assert_true(count[0] > 10000);
	}
}

static bool same(const struct block *a, const struct block *b, int out,
    size_t n)
{
	for (int j = 0; j < out; j++)
		for (size_t i = 0; i < n; i++)
			if (!(isnan(a->out[j][i]) && isnan(b->out[j][i])) &&
			    memcmp(&a->out[j][i], &b->out[j][i], 8) != 0)
				return false;
	return memcmp(a->single, b->single, n) == 0;
}

static void copies_give_the_same_bits(void **state)
{
	static struct block first, b;
	const struct accuracy efforts[] = { { PRECISION_EXACT, 0 },
		{ PRECISION_DOUBLE, 0 }, { PRECISION_SINGLE, 0 },
		{ PRECISION_EXACT, 0.5 }, { PRECISION_EXACT, 1e-9 } };
	struct scene s;
	struct transform t;
	enum space from, to;

	(void)state;
	sample_seed(4);
	for (int k = 0; k < 2000; k++) {
		if (!sample_transform(&s, k % 3 * 4, &from, &to, &t))
			continue;
		sample_points(&s, from, &first, POINTS + 5);
		for (size_t e = 0; e < 5; e++) {
			points_choose("baseline");
			carry(&t, efforts[e], &first, POINTS + 5);
			for (int c = 1; c < 3; c++) {
				memcpy(&b, &first, sizeof b);
				if (!points_choose(copies[c]))
					continue;
				carry(&t, efforts[e], &b, POINTS + 5);
				assert_true(
				    same(&first, &b, t.out, POINTS + 5));
			}
		}
	}
}

/* How a block is cut changes nothing. */
static void points_depend_on_nothing_else(void **state)
{
	static struct block whole, one;
	struct scene s;
	struct transform t;
	enum space from, to;

	(void)state;
	points_choose(NULL);
	sample_seed(5);
	for (int k = 0; k < 500; k++) {
		struct accuracy e = { PRECISION_EXACT, k % 2 ? 1e-3 : 0 };

		if (!sample_transform(&s, k % 2 * 5, &from, &to, &t))
			continue;
		sample_points(&s, from, &whole, POINTS);
		carry(&t, e, &whole, POINTS);
		for (size_t i = 0; i < POINTS; i++) {
			for (int j = 0; j < 4; j++)
				one.in[j][0] = whole.in[j][i];
			carry(&t, e, &one, 1);
			for (int j = 0; j < t.out; j++)
				whole.out[j][0] = whole.out[j][i];
			whole.single[0] = whole.single[i];
			assert_true(same(&whole, &one, t.out, 1));
		}
	}
}

/* -t keeps what it promises, printed digits included. */
static void tolerance_is_kept(void **state)
{
	static struct block b;
	struct scene s;
	struct transform t;
	enum space from, to;
	size_t cheap = 0, all = 0;

	(void)state;
	points_choose(NULL);
	sample_seed(6);
	for (int k = 0; k < 1200; k++) {
		double tolerance = pow(10, sample_between(-12, 1));
		struct accuracy e = { PRECISION_EXACT, tolerance };
		int mark = real_mark();
		struct truth truth = { 0 };

		if (!sample_transform(&s, k % 3 * 4, &from, &to, &t))
			continue;
		sample_points(&s, from, &b, POINTS);
		carry(&t, e, &b, POINTS);
		truth_scene(&s, from, to, &truth);
		for (size_t i = 0; i < POINTS; i++) {
			int point = real_mark();
			real q[4], sum[4];
			bool image = exact_image(&truth, &t, &b, i, q, sum);

			all++;
			cheap += b.single[i];
			for (int j = 0; image && j < t.out; j++) {
				real exact = t.divide ? over(q[j], q[3]) : q[j];
				double error = mpfr_get_d(
				    magnitude(sub(exact, number(b.out[j][i]))),
				    MPFR_RNDU);
				double value = fabs(
				    mpfr_get_d(exact, MPFR_RNDN));
				double kappa = truth_kappa(q, sum, j, t.divide);

				if (isnan(b.out[j][i]))
					continue;
				/* what exact itself cannot do better */
				assert_true(error <= tolerance ||
				    error <= value * 0x1p-53 *
					    (1 + 0x1p-40 * kappa));
			}
			real_release(point);
		}
		real_release(mark);
	}
	print_message("%zu of %zu points were cheap\n", cheap, all);
	assert_true(cheap > all / 8);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(exact_keeps_its_bound),
		cmocka_unit_test(copies_give_the_same_bits),
		cmocka_unit_test(points_depend_on_nothing_else),
		cmocka_unit_test(tolerance_is_kept),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
