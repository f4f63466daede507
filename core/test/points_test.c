/* SPDX-License-Identifier: MIT */
/* Blocks of points by every copy of the kernels, with every precision, and points
 * alone. */
#include "claims.h"
#include "block.h"

/* Cameras and targets at small whole numbers. Some points are on the eye plane, and a
 * coordinate that is 0 comes out as 0. */
static void zeros_of_whole_numbers(void **state)
{
	static struct block b;
	struct scene s = { .has_camera = true };
	struct tally tally = { 0 };
	struct transform t;

	(void)state;
	kernels_choose(NULL);
	s.projection = (struct projection){ .type = PROJECTION_PERSP,
		.section.way = SECTION_FOVY,
		.section.angle = 90,
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
		if (!transform_of_scene(&s, SPACE_WORLD, SPACE_NDC, false, &t, NULL))
			continue;
		for (size_t i = 0; i < 27; i++) {
			b.in[0][i] = (double)(i % 3) - 1;
			b.in[1][i] = (double)(i / 3 % 3) - 1;
			b.in[2][i] = (double)(i / 9) - 1;
		}
		map_block_exactly(&t, &b, 27);
		truth_scene(&s, SPACE_WORLD, SPACE_NDC, &truth);
		judge_block(&truth, &t, &b, 27, false, &tally);
		real_release(mark);
	}
	assert_int_equal(tally.n[WITHIN_TOLERANCE] + tally.n[WRONG], 0);
	assert_true(tally.n[NEAREST] > 100000);
}

static bool sample_any(int e, struct scene *s, enum space *from, struct transform *t)
{
	struct truth truth = { 0 };
	int mark = real_mark();
	bool accepted = sample_transform(e, s, from, t, &truth);

	real_release(mark);
	return accepted;
}

static bool same_images(const struct block *a, const struct block *b, int out, size_t n)
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
	struct scene s;
	enum space from;

	(void)state;
	SAMPLES(k, 1500) {
		size_t n = 1 + sample_below(POINTS + 5);

		if (!sample_any(k % 3 * 4, &s, &from, &t))
			continue;
		sample_points(&s, from, &first, n);
		for (int e = 0; e < 3; e++) {
			kernels_choose("baseline");
			map_block(&t, (enum precision)e, &first, n);
			for (int c = 1; c < COPIES; c++) {
				memcpy(&b, &first, sizeof b);
				if (!kernels_choose(copies[c]))
					continue;
				map_block(&t, (enum precision)e, &b, n);
				assert_true(same_images(&first, &b, t.out, n));
			}
		}
	}
}

/* A point has the same image alone and in a block. */
static void points_do_not_depend_on_blocks(void **state)
{
	static struct block whole, one;
	static struct transform t;
	struct scene s;
	enum space from;

	(void)state;
	kernels_choose(NULL);
	SAMPLES(k, 500) {
		if (!sample_any(k % 2 * 5, &s, &from, &t))
			continue;
		sample_points(&s, from, &whole, POINTS);
		map_block(&t, PRECISION_EXACT, &whole, POINTS);
		for (size_t i = 0; i < POINTS; i++) {
			for (int j = 0; j < 4; j++)
				one.in[j][0] = whole.in[j][i];
			map_block(&t, PRECISION_EXACT, &one, 1);
			for (int j = 0; j < t.out; j++)
				whole.out[j][0] = whole.out[j][i];
			assert_true(same_images(&whole, &one, t.out, 1));
		}
	}
}

/* x' = x + 2^195 + z cot(45) cos(45) - cot(45) cos(45). The last two terms have
 * errors, so the noise of x' is not 0, although x and 2^195 are exact. */
static void exact_terms_keep_the_noise_of_others(void **state)
{
	const struct scene s = {
		.has_world = true,
		.world.matrix = { { 1 }, { 0, 1 }, { 0, 0, 1 }, { 0x1p195, 0, 0, 1 } },
		.projection = { .type = PROJECTION_OBLIQUE,
		    .shear.kind = OBLIQUE_CAVALIER,
		    .shear.direction = 45,
		    .shear.plane = 1,
		    .section.way = SECTION_SIZE,
		    .section.width = 2,
		    .section.height = 2,
		    .near = -10,
		    .far = 10 },
	};
	struct transform t;

	(void)state;
	assert_true(transform_of_scene(&s, SPACE_MODEL, SPACE_NDC, false, &t, NULL));
	map_set_origin(&t.map, NULL);
	transform_prepare(&t);
	assert_number(t.for_kernel.hi[3][0], 0x1p195);
	assert_true(t.for_kernel.least_noise[0] > 0);
	assert_true(t.for_kernel.least_noise[0] < TRUTH_TOLERANCE);
}

/* Moves the points to within 2^-bits of the first one, or of what
 * the camera looks at. */
static void gather_points(const struct scene *s, int bits, struct block *b)
{
	for (int k = 0; k < 3; k++) {
		double about = bits % 3 ? s->camera.at[k] : b->in[k][0];

		for (int i = 0; i < POINTS; i++)
			b->in[k][i] = about + ldexp(b->in[k][i], -bits);
	}
}

/* Points that are near to each other, but far from the eye: near the view's axis the
 * kernels of exact.h leave many of them to those of doubled.h. */
static void points_near_the_axis(void **state)
{
	static struct block b;
	static struct transform t;
	struct tally tally = { 0 };

	(void)state;
	sample_seed(7);
	for (int i = 0; i < 900; i++) {
		int mark = real_mark();
		struct truth truth = { 0 };
		struct scene s;
		enum space from;

		if (sample_transform(i % 3, &s, &from, &t, &truth)) {
			sample_points(&s, from, &b, POINTS);
			gather_points(&s, i % 50, &b);
			kernels_choose(copies[i % COPIES]);
			map_block_exactly(&t, &b, POINTS);
			judge_block(&truth, &t, &b, POINTS, false, &tally);
		}
		real_release(mark);
	}
	assert_int_equal(tally.n[WITHIN_TOLERANCE] + tally.n[WRONG], 0);
	assert_true(tally.n[NEAREST] > 40000);
}

/* Directions: the truth without its translations. */
static void directions_have_no_translation(void **state)
{
	static struct block b;
	struct tally tally = { 0 };
	int n = 0;

	(void)state;
	kernels_choose(NULL);
	SAMPLES(i, 400) {
		const enum space from = (enum space)(i % 3);
		const enum space to = (enum space)((i + 1 + i / 3 % 2) % 3);
		int mark = real_mark();
		struct truth truth = { 0 };
		struct transform t;
		struct scene s;

		sample_scene(&s, i % 2 ? 0 : 8);
		sample_answer(&s);
		if (!transform_of_directions(&s, from, to, &t, NULL))
			continue;
		for (size_t k = 0; k < 3 * POINTS; k++)
			b.in[k % 3][k / 3] = sample_number(i % 2 ? 1 : 8);
		truth_scene(&s, from, to, &truth);
		for (int j = 0; j < 3; j++)
			truth.product.m[3][j] = truth.product.size[3][j] = real_of(0);
		map_block_exactly(&t, &b, POINTS);
		judge_block(&truth, &t, &b, POINTS, false, &tally);
		real_release(mark);
		n++;
	}
	print_message("%d maps of directions: %zu numbers, %zu within the tolerance\n",
	    n, tally.n[NEAREST], tally.n[WITHIN_TOLERANCE]);
	assert_true(n > 200);
	assert_int_equal(tally.n[WRONG], 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(zeros_of_whole_numbers),
		cmocka_unit_test(copies_give_the_same_bits),
		cmocka_unit_test(points_do_not_depend_on_blocks),
		cmocka_unit_test(exact_terms_keep_the_noise_of_others),
		cmocka_unit_test(points_near_the_axis),
		cmocka_unit_test(directions_have_no_translation),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
