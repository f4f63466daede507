#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "points.h"

/* Cameras at small whole numbers looking at one another: the eye plane is
 * behind, and what is 0 prints as 0. */
static void whole_numbers_have_no_ghosts(void **state)
{
	static struct block b;
	struct scene s = { .has_camera = true };
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
		carry(&t, (struct accuracy){ PRECISION_EXACT, 0 }, &b, 27);
		truth_scene(&s, SPACE_WORLD, SPACE_NDC, &truth);
		for (size_t i = 0; i < 27; i++) {
			double p[4] = { b.in[0][i], b.in[1][i], b.in[2][i], 1 };
			real q[4], sum[4];

			truth_image(&truth, p, q, sum);
			bool front = mpfr_sgn(q[3]) > 0 &&
			    !is_zero(q[3], sum[3]);

			assert_true(isnan(b.out[0][i]) == !front);
			for (int j = 0; front && j < 3; j++)
				assert_true((b.out[j][i] == 0) ==
				    is_zero(q[j], sum[j]));
		}
		real_release(mark);
	}
}

/* From model space to the device in one step, or in five with full digits in
 * between: each step's rounding is one u of every product that it feeds, so
 * the ways differ by at most 10 u kappa. The eye is at the origin, so that a
 * world coordinate's rounding is one of its distance from the eye too. */
static void ways_agree(void **state)
{
	static struct block one, five;
	struct accuracy exact = { PRECISION_EXACT, 0 };
	size_t compared = 0;

	(void)state;
	points_choose(NULL);
	sample_seed(7);
	for (int k = 0; k < 400; k++) {
		struct scene s;
		struct transform t, step;
		int mark = real_mark();
		struct truth truth = { 0 };

		sample_scene(&s, 0);
		s.has_viewport = true;
		memset(s.camera.eye, 0, sizeof s.camera.eye);
		if (scene_transform(&s, SPACE_MODEL, SPACE_DEVICE, false, &t))
			continue;
		sample_points(&s, SPACE_VIEW, &one, POINTS);
		memcpy(&five, &one, sizeof five);
		carry(&t, exact, &one, POINTS);
		for (int from = SPACE_MODEL; from < SPACE_DEVICE; from++) {
			assert_null(scene_transform(&s, (enum space)from,
			    (enum space)(from + 1), false, &step));
			carry(&step, exact, &five, POINTS);
			memcpy(five.in, five.out, sizeof five.in);
		}
		truth_scene(&s, SPACE_MODEL, SPACE_DEVICE, &truth);
		for (size_t i = 0; i < POINTS; i++) {
			int point = real_mark();
			real q[4], sum[4];
			bool image = exact_image(&truth, &t, &one, i, q, sum);

			for (int j = 0; image && j < 3; j++) {
				double a = one.out[j][i], b = five.out[j][i];
				double kappa = truth_kappa(q, sum, j, t.divide);

				if (!(kappa < 0x1p40))
					continue;
				compared++;
				assert_true(fabs(a - b) <=
				    10 * 0x1p-53 * kappa * fabs(a));
			}
			real_release(point);
		}
		real_release(mark);
	}
	assert_true(compared > 5000);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(whole_numbers_have_no_ghosts),
		cmocka_unit_test(ways_agree),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
