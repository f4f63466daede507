/* SPDX-License-Identifier: MIT */
/* Tests point_exact, which computes one point with sums of core/exact, for ties,
 * zeros, the eye plane and nan. Most cases also test the kernels. */

#include "claims.h"
#include "block.h"

/* Compares the image of a point, as doubles and as floats, with MPFR. */
static void check_point(const struct truth *truth, const struct transform *t,
    const double p[4], struct tally *tally)
{
	int mark = real_mark();
	struct image image;
	double q[4];

	image_of(truth, t, p, &image);
	point_exact(t, p, q);
	judge_image(&image, t->out, q, false, tally);
	for (int j = 0; j < t->out; j++)
		if (!isnan(q[j]))
			q[j] = (double)point_exact_float(t, p, j, q[j]);
	judge_image(&image, t->out, q, true, tally);
	real_release(mark);
}

static void random_points(void **state)
{
	static struct transform t;
	static struct block b;
	struct tally tally = { 0 };
	struct scene s;

	(void)state;
	SAMPLES(k, 200) {
		struct truth truth = { 0 };
		enum space from;
		int mark = real_mark();

		if (sample_transform(k % 4 * 5, &s, &from, &t, &truth)) {
			sample_points(&s, from, &b, POINTS);
			for (size_t i = 0; i < POINTS; i++) {
				double p[4];

				block_point(&b, i, p);
				check_point(&truth, &t, p, &tally);
			}
		}
		real_release(mark);
	}
	print_message("%zu numbers, %zu within the tolerance\n", tally.n[NEAREST],
	    tally.n[WITHIN_TOLERANCE]);
	assert_int_equal(tally.n[WRONG], 0);
	assert_true(tally.n[NEAREST] > 10000);
}

static void transform_of_rows(const double m[3][4], struct transform *t)
{
	double all[4][4] = { [3] = { 0, 0, 0, 1 } };

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 3; j++)
			all[i][j] = m[j][i];
	map_of_doubles(all, &t->map);
	transform_init(t, SPACE_MODEL, SPACE_WORLD, false);
}

static void assert_image(const struct transform *t, double x, double y, double z,
    const double expected[3])
{
	const char *const *copy = copies;
	const double p[4] = { x, y, z };
	static struct block b;
	double q[4];

	point_exact(t, p, q);
	for (int j = 0; j < 3; j++)
		assert_number(q[j], expected[j]);
	for (; copy < copies + COPIES; copy++) {
		if (!kernels_choose(*copy))
			continue;
		for (int j = 0; j < 3; j++)
			b.in[j][0] = p[j];
		map_block_exactly(t, &b, 1);
		for (int j = 0; j < 3; j++)
			assert_number(b.out[j][0], expected[j]);
	}
}

/* The rows of each matrix are the formulas of x, y and z. Numbers that are given are
 * exact, so that no part of a sum is too small to decide a tie or a sign. */
static void sums_of_given_numbers(void **state)
{
	static const double cancelling[3][4] = { { 1, 1, 1, 0 }, { 1, 1, 0x1p-1000, 0 },
		{ 1, 1, 1, 1e-150 } };
	static const double tied[3][4] = { { 1, 0, 0, 0x1p-53 },
		{ 1, 0, 0x1p-400, 0x1p-53 }, { 1, 0, -0x1p-400, 0x1p-53 } };
	static const double odd[3][4] = { { 3, 0, 0, 0x1p-52 }, { 1, 0, 0, -0x1p-54 },
		{ 1, 0x1p-1000, 0, -0x1p-54 } };
	struct transform t;

	(void)state;
	transform_of_rows(cancelling, &t);
	assert_image(&t, 1e32, -1e32, 3, (double[]){ 3, 0x3p-1000, 3 });
	assert_image(&t, 1e150, -1e150, 0, (double[]){ 0, 0, 1e-150 });
	transform_of_rows(tied, &t);
	assert_image(&t, 1, 0, 1, (double[]){ 1, 1 + 0x1p-52, 1 });
	assert_image(&t, -1, 0, 1,
	    (double[]){ -1 + 0x1p-53, -1 + 0x1p-53, -1 + 0x1p-53 });
	transform_of_rows(odd, &t);
	assert_image(&t, 1, 0x1p-60, 0, (double[]){ 3, 1, 1 });
	assert_image(&t, 1, -0x1p-60, 0, (double[]){ 3, 1, 1 - 0x1p-53 });
}

/* The image is 1 plus 2^310 times a difference of roots that is 0: it is exactly 1. */
static void one_beside_a_zero_of_roots(void **state)
{
	struct sum root = sum_sqrt(sum_of_double(2));
	struct sum none = sum_sub(sum_mul(root, root), sum_of_double(2));
	static const double zero[4][4] = { [3] = { 0, 0, 0, 1 } };
	static struct transform t;
	double out[4];

	(void)state;
	for (int i = 0; i < 3; i++)
		for (int k = 1; k < 3; k++) {
			double p[4] = { 1, 1, 1 };

			p[i] = 0x1p310;
			p[(i + k) % 3] = -0x1p310;
			map_of_doubles(zero, &t.map);
			t.map.m[i][0] = none;
			t.map.m[(i + 3 - k) % 3][0] = sum_of_double(1);
			transform_init(&t, SPACE_MODEL, SPACE_WORLD, false);
			point_exact(&t, p, out);
			assert_number(out[0], 1);
		}
}

/* Images in scenes of round numbers are the nearest doubles and floats. The divisor is
 * exact also in maps from the device back to other spaces. */
static void quotients_of_given_numbers(void **state)
{
	static struct transform t;
	static struct block b;
	struct tally tally = { 0 };
	struct scene s;

	(void)state;
	SAMPLES(k, 400) {
		struct truth truth = { 0 };
		enum space from;
		int mark = real_mark();

		sample_round_points(&b, POINTS);
		if (sample_transform(-1, &s, &from, &t, &truth)) {
			map_block_exactly(&t, &b, POINTS);
			judge_block(&truth, &t, &b, POINTS, false, &tally);
			judge_block(&truth, &t, &b, POINTS, true, &tally);
		}
		real_release(mark);
	}
	print_message("%zu round numbers\n", tally.n[NEAREST]);
	assert_int_equal(tally.n[WRONG], 0);
	assert_true(tally.n[NEAREST] > 20000);
}

/* Products below the range of doubles add up to numbers within it, or cancel, and
 * results are subnormal, some midway between two doubles. */
static void underflow(void **state)
{
	static const double m[3][4] = { { 1e-150, -1e-150, 1e150, 0 },
		{ 0x1p-500, 0, 0, 0x1p-1074 }, { 0x1p-500, 0x1p-1000, 0, 0 } };
	struct transform t;

	(void)state;
	transform_of_rows(m, &t);
	assert_image(&t, 1e-165, 1e-165, 1e-300,
	    (double[]){ 1e150 * 1e-300, 0x1p-500 * 1e-165 + 0x1p-1074,
		0x1p-500 * 1e-165 });
	/* y and z are 1.5 and 0.5, then 2.5 times the least double */
	assert_image(&t, 0x1p-575, 0, 0, (double[]){ 0x1p-575 * 1e-150, 0x1p-1073, 0 });
	assert_image(&t, 0x5p-575, 0, 0,
	    (double[]){ 0x5p-575 * 1e-150, 0x4p-1074, 0x2p-1074 });
	assert_image(&t, 0x5p-575, 0x1p-200, 0,
	    (double[]){ -0x1p-200 * 1e-150, 0x4p-1074, 0x3p-1074 });
	assert_image(&t, 0x1p-524, 0, 0,
	    (double[]){ 0x1p-524 * 1e-150, 0x1p-1024 + 0x1p-1074, 0x1p-1024 });
}

/* The camera looks along (0, 1, 1), so that y / w = (y - z) / (y + z), where both sums
 * are divided by the root of 2. With y + z = 1, y of the device is 1 + k 2^-53, which
 * is midway between two doubles if k is odd and positive. */
static void ties_of_irrational_parts(void **state)
{
	struct scene s = { .has_camera = true,
		.camera = { .way = CAMERA_GAZE, .at = { 0, 1, 1 }, .up = { 0, 1, 0 } },
		.projection = { .type = PROJECTION_PERSP,
		    .section.way = SECTION_FOVY,
		    .section.angle = 90,
		    .aspect = { 1, 1 },
		    .near = 1,
		    .far = 2 },
		.has_viewport = true,
		.viewport = { .x = 0.5, .y = 0.5, .width = 1, .height = 1, .max_z = 1 },
		.convention = { .origin_bottom_left = true } };
	struct transform t;

	(void)state;
	assert_true(transform_of_scene(&s, SPACE_WORLD, SPACE_DEVICE, false, &t, NULL));
	for (int k = -99; k < 100; k++) {
		double y = 0.5 + k * 0x1p-53, z = 0.5 - k * 0x1p-53, q[4];
		int mark = real_mark();
		real exact = add(real_of(1), real_of(k * 0x1p-53));

		if (y - z != k * 0x1p-52) {
			real_release(mark);
			continue;
		}
		point_exact(&t, (double[4]){ 0, y, z }, q);
		assert_number(q[1], mpfr_get_d(exact, MPFR_RNDN));
		assert_number(q[0], 1);
		real_release(mark);
	}
}

/* The camera rolls by 45 degrees before a parallel projection, so that x of the device
 * is 1 + (z - y) / 2, a sum whose factors are a sine and the root of 1/2. */
static void ties_of_different_irrational_parts(void **state)
{
	struct scene s = { .has_camera = true,
		.camera = { .way = CAMERA_GAZE,
		    .at = { 0, 1, 1 },
		    .up = { 0, 1, 0 },
		    .roll = 45 },
		.projection = { .type = PROJECTION_ORTHO,
		    .section.way = SECTION_SIZE,
		    .section.width = 2,
		    .section.height = 2,
		    .far = 1 },
		.has_viewport = true,
		.viewport = { .x = 0.5, .width = 1, .height = 1, .max_z = 1 } };
	static struct block b;
	static struct transform t;

	(void)state;
	assert_true(transform_of_scene(&s, SPACE_WORLD, SPACE_DEVICE, false, &t, NULL));
	for (int c = 0; c < COPIES; c++) {
		if (!kernels_choose(copies[c]))
			continue;
		for (int i = 0; i < 200; i++) {
			b.in[0][i] = 0;
			b.in[1][i] = (100 - i) * 0x1p-52;
			b.in[2][i] = -b.in[1][i];
		}
		map_block_exactly(&t, &b, 200);
		for (int i = 0; i < 200; i++) {
			int mark = real_mark();
			real exact = sub(real_of(1), real_of((100 - i) * 0x1p-53));

			assert_number(b.out[0][i], mpfr_get_d(exact, MPFR_RNDN));
			real_release(mark);
		}
	}
}

/* There is no image of points on the eye plane or behind it, nor of points with nan. */
static void no_image(void **state)
{
	struct scene s = { .projection = { .type = PROJECTION_PERSP,
			       .section.way = SECTION_SIZE,
			       .section.width = 2,
			       .section.height = 2,
			       .near = 1,
			       .far = 3 } };
	static const double z[] = { 0, -0.0, -0x1p-1074, -1, -1e150, 0x1p-1074,
		0x1p-500, 1 };
	struct transform t;

	(void)state;
	assert_true(transform_of_scene(&s, SPACE_VIEW, SPACE_NDC, false, &t, NULL));
	for (size_t i = 0; i < 8; i++) {
		static struct block b;

		for (int c = 0; c < COPIES; c++) {
			if (!kernels_choose(copies[c]))
				continue;
			for (size_t k = 0; k < 8; k++) {
				b.in[0][k] = k == 3 ? (double)NAN : 0;
				b.in[1][k] = k == 4 ? (double)NAN : 0;
				b.in[2][k] = k == 5 ? (double)NAN : z[i];
			}
			map_block_exactly(&t, &b, 8);
			for (size_t k = 0; k < 8; k++)
				for (int j = 0; j < 3; j++) {
					bool none = i < 5 || (k > 2 && k < 6);

					/* depth is beyond the range of doubles at the
					 * least z */
					none |= j == 2 && i == 5;
					assert_int_equal(isnan(b.out[j][k]) != 0, none);
				}
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(random_points),
		cmocka_unit_test(sums_of_given_numbers),
		cmocka_unit_test(one_beside_a_zero_of_roots),
		cmocka_unit_test(quotients_of_given_numbers),
		cmocka_unit_test(underflow),
		cmocka_unit_test(ties_of_irrational_parts),
		cmocka_unit_test(ties_of_different_irrational_parts),
		cmocka_unit_test(no_image),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
