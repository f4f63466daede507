#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "../error_bound.h"
#include "../points.h"
#include "sample.h"
#include "../taxonomy.h"
#include "truth.h"

enum { POINTS = 40 };

struct block {
	double in[3][POINTS_BLOCK], out[3][POINTS_BLOCK];
	bool single[POINTS_BLOCK];
};

static void carry(const struct transform *t, enum precision precision,
    struct block *b)
{
	const struct accuracy e = { precision, 0 };
	const double *const in[4] = { b->in[0], b->in[1], b->in[2] };
	double *const out[4] = { b->out[0], b->out[1], b->out[2] };

	points_carry(t, &e, in, out, b->single, POINTS);
}

/* Points of the view volume, many on its edges, rounded to doubles. */
static void sample_points(const struct scene *s, struct block *b)
{
	double low = s->convention.minus_one ? -1 : 0;
	dd limit[2] = { { 1, 0 }, { 1, 0 } };
	struct truth truth;
	real m[4][4], sum[4][4];

	if (s->has_viewport)
		viewport_limits(&s->viewport, limit);
	truth_scene(s, SPACE_CLIP, SPACE_MODEL, &truth);
	truth_matrix(&truth, m, sum);
	for (int i = 0; i < POINTS; i++) {
		int mark = real_mark();
		double at[4] = { limit[0].hi, limit[1].hi, 1, 1 };
		real h[4];

		for (int j = 0; j < 3; j++) {
			double from = j == 2 ? low : -at[j];
			unsigned side = sample_below(4);

			at[j] = side == 0 ? from :
			    side == 1     ? at[j] :
					    sample_between(from, at[j]);
		}
		for (int j = 0; j < 4; j++) {
			h[j] = number(0);
			for (int k = 0; k < 4; k++)
				h[j] = add(h[j], mul(number(at[k]), m[k][j]));
		}
		for (int j = 0; j < 3; j++)
			b->in[j][i] = mpfr_get_d(over(h[j], h[3]), MPFR_RNDN);
		real_release(mark);
	}
}

/* A point whose image is in the view volume, and in the range of points. */
static bool is_inside(const struct scene *s, const struct truth *to_clip,
    const double p[4])
{
	double low = s->convention.minus_one ? -1 : 0;
	dd limit[2] = { { 1, 0 }, { 1, 0 } };
	real q[4], sum[4];

	if (s->has_viewport)
		viewport_limits(&s->viewport, limit);
	for (int j = 0; j < 3; j++)
		if (!(fabs(p[j]) < 1e150))
			return false;
	truth_image(to_clip, p, q, sum);
	if (mpfr_sgn(q[3]) <= 0)
		return false;
	for (int j = 0; j < 3; j++) {
		real x = over(q[j], q[3]);

		if (mpfr_cmp_d(x, j < 2 ? limit[j].hi : 1) > 0 ||
		    mpfr_cmp_d(x, j < 2 ? -limit[j].hi : low) < 0)
			return false;
	}
	return true;
}

/* The worst error of a block over its bound. */
static double worst_of(const struct scene *s, const struct block *b,
    double bound, int *n)
{
	struct truth to_clip, truth;
	double worst = 0;

	truth_scene(s, SPACE_MODEL, SPACE_CLIP, &to_clip);
	truth_scene(s, SPACE_MODEL, s->has_viewport ? SPACE_DEVICE : SPACE_NDC,
	    &truth);
	for (int i = 0; i < POINTS; i++) {
		double p[4] = { b->in[0][i], b->in[1][i], b->in[2][i], 1 };
		int mark = real_mark();
		real q[4], sum[4];
		bool inside = is_inside(s, &to_clip, p);

		truth_image(&truth, p, q, sum);
		for (int j = 0; j < 3 && inside; j++) {
			real exact = over(q[j], q[3]);
			double error = fabs(
			    mpfr_get_d(sub(exact, number(b->out[j][i])),
				MPFR_RNDA));

			assert_true(error <= bound);
			worst = fmax(worst, error / bound);
			++*n;
		}
		real_release(mark);
	}
	return worst;
}

static void bounds_hold(void **state)
{
	static const char *const names[] = { "exact", "double", "single" };
	static struct block b;
	double worst[3] = { 0 };
	int n[3] = { 0 };
	struct scene s;
	struct transform t;
	double bound[3];

	(void)state;
	points_choose(NULL);
	sample_seed(33);
	for (int k = 0; k < 300; k++) {
		int mark = real_mark(), hostile = k % 3 * 3;
		struct taxonomy kind;

		sample_scene(&s, hostile);
		s.has_viewport = k % 4 != 0;
		enum space to = s.has_viewport ? SPACE_DEVICE : SPACE_NDC;

		if (taxonomy_of(&s, &kind) != NULL ||
		    scene_transform(&s, SPACE_MODEL, to, false, &t) != NULL ||
		    error_bounds(&s, bound) != NULL || isnan(bound[0]))
			continue;
		sample_points(&s, &b);
		for (int i = 0; i < 3; i++) {
			if (isnan(bound[i]))
				continue;
			carry(&t, (enum precision)i, &b);
			double w = worst_of(&s, &b, bound[i], &n[i]);

			if (w > worst[i])
				worst[i] = w;
		}
		real_release(mark);
	}
	for (int i = 0; i < 3; i++) {
		print_message("%s: %d coordinates, %.3g of the bound\n",
		    names[i], n[i], worst[i]);
		assert_true(n[i] > 4000 && worst[i] > 0.05);
	}
}

/* Of 640 x 480 pixels, and beyond the range of floats. */
static void ordinary_bounds_are_small(void **state)
{
	struct scene s = { .has_viewport = true,
		.projection = { .type = PROJECTION_PERSP,
		    .extent = EXTENT_FOVY,
		    .angle = 60,
		    .aspect = { 4, 3 },
		    .near = 1,
		    .far = 1000 } };
	double bound[3];

	(void)state;
	s.viewport = (struct viewport){ .width = 640,
		.height = 480,
		.max_z = 1 };
	assert_null(error_bounds(&s, bound));
	assert_true(bound[PRECISION_SINGLE] < 1e-3);
	assert_true(bound[PRECISION_DOUBLE] < 2e-12);
	assert_true(bound[PRECISION_EXACT] < 0x1.0001p-44);
	s.projection.far = 1e140;
	assert_null(error_bounds(&s, bound));
	assert_true(isnan(bound[PRECISION_SINGLE]) != 0);
	assert_true(bound[PRECISION_DOUBLE] < 2e-12);
	s.projection.far = HUGE_VAL;
	assert_null(error_bounds(&s, bound));
	assert_true(isnan(bound[PRECISION_SINGLE]) != 0);
	assert_true(bound[PRECISION_DOUBLE] < 2e-12);
	/* a world that flattens holds its volume nowhere */
	s.has_world = true;
	s.world[0][0] = s.world[1][1] = s.world[3][3] = 1;
	assert_null(error_bounds(&s, bound));
	assert_true(isnan(bound[PRECISION_EXACT]) != 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(bounds_hold),
		cmocka_unit_test(ordinary_bounds_are_small),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
