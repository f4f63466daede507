/* SPDX-License-Identifier: MIT */
/* Blocks of points: every copy of the kernels, every cut, every tolerance. */
#include "claims.h"
#include "points.h"

/* Cameras at small whole numbers looking at one another: the eye plane is
 * behind, and what is 0 prints as 0. */
static void whole_numbers_have_no_ghosts(void **state)
{
	static struct block b;
	struct scene s = { .has_camera = true };
	struct tally tally = { 0 };
	struct transform t;

	(void)state;
	points_choose(NULL);
	s.projection = (struct projection){ .type = PROJECTION_PERSP,
		.extent = EXTENT_FOVY,
		.angle = 90,
		.aspect = { 1, 1 },
		.near = 1,
		.far = 10 };
	for (int k = 0; k < 125 * 125; k += 7) {
		struct camera *c = &s.camera;
		int mark = real_mark();
		struct truth truth = { 0 };

		for (int i = 0, a = k; i < 6; i++, a /= 5)
			(i < 3 ? c->eye : c->at)[i % 3] = a % 5 - 2;
		c->up[0] = k % 2;
		c->up[1] = 1;
		if (scene_transform(&s, SPACE_WORLD, SPACE_NDC, false, &t))
			continue;
		for (size_t i = 0; i < 27; i++) {
			b.in[0][i] = (double)(i % 3) - 1;
			b.in[1][i] = (double)(i / 3 % 3) - 1;
			b.in[2][i] = (double)(i / 9) - 1;
		}
		carry_all(&t, &b, 27);
		truth_scene(&s, SPACE_WORLD, SPACE_NDC, &truth);
		judge_block(&truth, &t, &b, 27, false, &tally);
		real_release(mark);
	}
	assert_int_equal(tally.n[RULED] + tally.n[WRONG], 0);
	assert_true(tally.n[NEAREST] > 100000);
}

static bool sample_any(int e, struct scene *s, enum space *from,
    struct transform *t)
{
	struct truth truth = { 0 };
	int mark = real_mark();
	bool good = sample_transform(e, s, from, t, &truth);

	real_release(mark);
	return good;
}

static bool same(const struct block *a, const struct block *b, int out,
    size_t n)
{
	for (int j = 0; j < out; j++)
		for (size_t i = 0; i < n; i++)
			if (!(isnan(a->out[j][i]) && isnan(b->out[j][i])) &&
			    memcmp(&a->out[j][i], &b->out[j][i], 8) != 0)
				return false;
	return true;
}

static void copies_give_the_same_bits(void **state)
{
	static struct block first, b;
	static struct transform t;
	const struct accuracy efforts[] = { { PRECISION_EXACT, { 0 } },
		{ PRECISION_DOUBLE, { 0 } }, { PRECISION_SINGLE, { 0 } },
		{ PRECISION_EXACT, { 0.5, 0.5, 0.5 } },
		{ PRECISION_EXACT, { 1e-9, 1e-6, 1e-12 } } };
	struct scene s;
	enum space from;

	(void)state;
	sample_seed(4);
	for (int k = 0; k < 1500; k++) {
		size_t n = 1 + sample_below(POINTS + 5);

		if (!sample_any(k % 3 * 4, &s, &from, &t))
			continue;
		sample_points(&s, from, &first, n);
		for (size_t e = 0; e < 5; e++) {
			points_choose("baseline");
			carry(&t, efforts[e], &first, n);
			for (int c = 1; c < COPIES; c++) {
				memcpy(&b, &first, sizeof b);
				if (!points_choose(copies[c]))
					continue;
				carry(&t, efforts[e], &b, n);
				assert_true(same(&first, &b, t.out, n));
			}
		}
	}
}

/* How a block is cut changes nothing. */
static void points_depend_on_nothing_else(void **state)
{
	static struct block whole, one;
	static struct transform t;
	struct scene s;
	enum space from;

	(void)state;
	points_choose(NULL);
	sample_seed(5);
	for (int k = 0; k < 500; k++) {
		double tolerance = k % 2 ? 1e-12 : 0;
		struct accuracy e = { PRECISION_EXACT,
			{ tolerance, tolerance, tolerance } };

		if (!sample_any(k % 2 * 5, &s, &from, &t))
			continue;
		sample_points(&s, from, &whole, POINTS);
		carry(&t, e, &whole, POINTS);
		for (size_t i = 0; i < POINTS; i++) {
			for (int j = 0; j < 4; j++)
				one.in[j][0] = whole.in[j][i];
			carry(&t, e, &one, 1);
			for (int j = 0; j < t.out; j++)
				whole.out[j][0] = whole.out[j][i];
			assert_true(same(&whole, &one, t.out, 1));
		}
	}
}

/* A number is within the tolerance, or the nearest double; whether it is not that,
 * but cheap. */
static bool check_within(double tolerance, double got, struct form n,
    struct form d)
{
	real off = sub(over(n.value, d.value), number(got));

	if (truth_verdict(got, n, d, false) != WRONG)
		return false;
	assert_true(mpfr_cmpabs(off, number(tolerance)) <= 0);
	return true;
}

static double power(double least, double most)
{
	return copysign(pow(10, sample_between(least, most)),
	    sample_between(-1, 1));
}

/* Elements about the least float or double, 10^e, before coordinates that make
 * their errors large. */
static void sample_tiny(int e, double m[4][4], struct block *b)
{
	sample_affine(m, 0);
	for (int i = 0; i < 12; i++)
		m[i / 3][i % 3] = power(e - 5, e + 4);
	for (int i = 0; i < POINTS; i++)
		for (int j = 0; j < 3; j++)
			b->in[j][i] = power(3 - e / 17, 18 - e / 17);
}

static void tolerance_counts_underflow(void **state)
{
	static struct block b;
	static struct transform t;
	size_t cheap = 0;

	(void)state;
	sample_seed(7);
	for (int k = 0; k < 500; k++) {
		int mark = real_mark(), e = k % 2 ? -40 : -318;
		struct accuracy a = { .precision = PRECISION_EXACT };
		struct truth truth = { 0 };
		double m[4][4];

		for (int j = 0; j < 3; j++)
			a.tolerance[j] = fmax(0x1p-1000,
			    pow(10, sample_between(e + 4, e + 26)));
		sample_tiny(e, m, &b);
		map_of_doubles(m, &t.map);
		transform_init(&t, SPACE_MODEL, SPACE_WORLD, false);
		set_matrix(truth_stage(&truth)->m, m);
		truth_compose(&truth);
		carry(&t, a, &b, POINTS);
		for (size_t i = 0; i < POINTS; i++) {
			int point = real_mark();
			double p[4] = { b.in[0][i], b.in[1][i], b.in[2][i], 1 };

			for (int j = 0; j < 3; j++)
				cheap += check_within(a.tolerance[j],
				    b.out[j][i], truth_column(&truth, j, p),
				    form_of(1));
			real_release(point);
		}
		real_release(mark);
	}
	print_message("%zu numbers were cheap\n", cheap);
	assert_true(cheap > 500);
}

static void tolerance_is_kept(void **state)
{
	static struct block b;
	static struct transform t;
	struct scene s;
	enum space from;
	size_t cheap = 0, all = 0;

	(void)state;
	points_choose(NULL);
	sample_seed(6);
	for (int k = 0; k < 800; k++) {
		bool any = k % 8 == 7;
		struct accuracy e = { .precision = PRECISION_EXACT };
		int mark = real_mark();
		struct truth truth = { 0 };

		for (int j = 0; j < 3; j++)
			e.tolerance[j] = pow(10,
			    any ? sample_between(-320, 150) :
				  sample_between(-12, 6));
		if (!sample_transform(k % 3 * 4, &s, &from, &t, &truth))
			continue;
		sample_points(&s, from, &b, POINTS);
		carry(&t, e, &b, POINTS);
		for (size_t i = 0; i < POINTS; i++) {
			int point = real_mark();
			struct image image;
			double p[4];

			point_of(&b, i, p);
			image_of(&truth, &t, p, &image);
			for (int j = 0; j < t.out; j++)
				if (isnan(b.out[j][i]))
					assert_true(!image.seen ||
					    image.doubtful ||
					    truth_verdict(b.out[j][i],
						image.n[j], image.d,
						false) == NEAREST);
				else
					cheap += check_within(j < 3 ?
						e.tolerance[j] :
						0,
					    b.out[j][i], image.n[j], image.d);
			all += (size_t)t.out;
			real_release(point);
		}
		real_release(mark);
	}
	print_message("%zu of %zu numbers were cheap\n", cheap, all);
	assert_true(cheap > all / 20);
}

/* Of x' = x + 2^195 + z cot(45) cos(45) - cot(45) cos(45) over a divisor, 20: what is
 * exact makes nothing none. */
static void none_is_of_what_is_irrational(void **state)
{
	const struct scene s = {
		.has_world = true,
		.world = { { 1 }, { 0, 1 }, { 0, 0, 1 }, { 0x1p195, 0, 0, 1 } },
		.projection = { .type = PROJECTION_OBLIQUE,
		    .kind = OBLIQUE_CAVALIER,
		    .direction = 45,
		    .plane = 1,
		    .extent = EXTENT_SIZE,
		    .width = 2,
		    .height = 2,
		    .near = -10,
		    .far = 10 },
	};
	struct transform t;

	(void)state;
	assert_null(scene_transform(&s, SPACE_MODEL, SPACE_NDC, false, &t));
	assert_true(t.for_kernel.hi[3][0] == 0x1p195);
	assert_true(t.for_kernel.surely_none[0] > 0);
	assert_true(t.for_kernel.surely_none[0] < 0x1p-190);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(whole_numbers_have_no_ghosts),
		cmocka_unit_test(copies_give_the_same_bits),
		cmocka_unit_test(points_depend_on_nothing_else),
		cmocka_unit_test(tolerance_is_kept),
		cmocka_unit_test(tolerance_counts_underflow),
		cmocka_unit_test(none_is_of_what_is_irrational),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
