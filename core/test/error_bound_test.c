/* SPDX-License-Identifier: MIT */
/* No point of the view volume has an error above the bound that inspect
 * prints. */
#include "../derive/error_bound.h"

#include "claims.h"
#include "block.h"

/* Sets the lower and upper corner of the view volume in ndc. */
static void corners_of(const struct scene *s, real low[3], real high[3])
{
	truth_limits(s, high);
	low[0] = negative(high[0]);
	low[1] = negative(high[1]);
	low[2] = real_of(truth_answer(s)->depth_minus_one ? -1 : 0);
	high[2] = real_of(1);
}

/* Samples points of the view volume, many on its faces, rounded to doubles. */
static void sample_inside(const struct scene *s, struct block *b)
{
	struct truth truth = { 0 };
	real low[3], high[3];

	corners_of(s, low, high);
	truth_scene(s, SPACE_CLIP, SPACE_MODEL, &truth);
	for (int i = 0; i < POINTS; i++) {
		int mark = real_mark();
		real at[4] = { [3] = real_of(1) }, h[4];

		for (int j = 0; j < 3; j++) {
			unsigned side = sample_below(4);
			double t = side < 2 ? side : sample_unit();

			at[j] = add(mul(low[j], real_of(1 - t)),
			    mul(high[j], real_of(t)));
		}
		for (int j = 0; j < 4; j++) {
			real column[4];

			for (int k = 0; k < 4; k++)
				column[k] = truth.product.m[k][j];
			h[j] = dot(at, column, 4);
		}
		for (int j = 0; j < 3; j++) {
			double x = mpfr_get_d(divide(h[j], h[3]), MPFR_RNDN);

			/* coordinates of points are at most SCENE_MAGNITUDE_MAX */
			b->in[j][i] = fabs(x) <= SCENE_MAGNITUDE_MAX ? x : 0;
		}
		real_release(mark);
	}
}

/* Returns whether the image of a point is in the view volume, and the point in
 * range. */
static bool is_inside(const struct scene *s, const struct truth *to_clip,
    const double p[4])
{
	real low[3], high[3];
	struct sized w;

	corners_of(s, low, high);
	for (int j = 0; j < 3; j++)
		if (!(fabs(p[j]) <= SCENE_MAGNITUDE_MAX))
			return false;
	w = truth_column(to_clip, 3, p);
	if (truth_sign(w, NULL) <= 0)
		return false;
	for (int j = 0; j < 3; j++) {
		real x = divide(truth_column(to_clip, j, p).value, w.value);

		if (mpfr_cmp(x, low[j]) < 0 || mpfr_cmp(x, high[j]) > 0)
			return false;
	}
	return true;
}

/* Returns the worst error of a block, divided by its bound. */
static double worst_of(const struct scene *s, const struct transform *t,
    const struct truth *truth, const struct block *b, double bound, int *n)
{
	struct truth to_clip = { 0 };
	double worst = 0;

	truth_scene(s, SPACE_MODEL, SPACE_CLIP, &to_clip);
	for (int i = 0; i < POINTS; i++) {
		double p[4] = { b->in[0][i], b->in[1][i], b->in[2][i], 1 };
		int mark = real_mark();
		struct image image;
		bool inside = is_inside(s, &to_clip, p);

		if (inside)
			image_of(truth, t, p, &image);
		for (int j = 0; j < 3 && inside; j++) {
			real exact = divide(image.n[j].value, image.d.value);
			double error = fabs(
			    mpfr_get_d(sub(exact, real_of(b->out[j][i])), MPFR_RNDA));

			assert_true(error <= bound);
			worst = fmax(worst, error / bound);
			++*n;
		}
		real_release(mark);
	}
	return worst;
}

static bool bounds_of(const struct scene *s, double bound[3], struct refusals *faults)
{
	static struct lens l;

	return lens_of(s, &l, faults) && error_bound_of(&l, bound, faults);
}

static void bounds_hold(void **state)
{
	static const char *const names[] = { "exact", "double", "single" };
	static struct block b;
	static struct transform t;
	double worst[3] = { 0 };
	int n[3] = { 0 };
	struct scene s;
	double bound[3];

	(void)state;
	kernels_choose(NULL);
	SAMPLES(k, 400) {
		static const int magnitudes[] = { 0, 3, 6, 30 };
		struct truth truth = { 0 };
		int mark = real_mark();

		sample_scene(&s, magnitudes[k % 4]);
		sample_answer(&s);
		s.has_viewport = k % 3 != 0;
		enum space to = s.has_viewport ? SPACE_DEVICE : SPACE_NDC;

		if (!transform_of_scene(&s, SPACE_MODEL, to, false, &t, NULL) ||
		    !bounds_of(&s, bound, NULL) || isnan(bound[0]))
			continue;
		truth_scene(&s, SPACE_MODEL, to, &truth);
		sample_inside(&s, &b);
		for (int i = 0; i < 3; i++) {
			if (isnan(bound[i]))
				continue;
			map_block(&t, (enum precision)i, &b, POINTS);
			double w = worst_of(&s, &t, &truth, &b, bound[i], &n[i]);

			if (w > worst[i])
				worst[i] = w;
		}
		real_release(mark);
	}
	for (int i = 0; i < 3; i++) {
		print_message("%s: %d coordinates, %.3g of the bound\n", names[i], n[i],
		    worst[i]);
		assert_true(n[i] > 4000 && worst[i] > 0.05);
	}
}

/* The scenes have 640 x 480 pixels, or lie beyond the range of floats. */
static void ordinary_bounds_are_small(void **state)
{
	struct scene s = { .has_viewport = true,
		.projection = { .type = PROJECTION_PERSP,
		    .section.way = SECTION_FOVY,
		    .section.angle = 60,
		    .aspect = { 4, 3 },
		    .near = 1,
		    .far = 1000 } };
	double bound[3];

	(void)state;
	s.viewport = (struct viewport){ .width = 640, .height = 480, .max_z = 1 };
	assert_true(bounds_of(&s, bound, NULL));
	assert_true(bound[PRECISION_SINGLE] < 1e-3);
	assert_true(bound[PRECISION_DOUBLE] < 2e-12);
	assert_true(bound[PRECISION_EXACT] < 0x1.0001p-44);
	s.projection.far = 1e140;
	assert_true(bounds_of(&s, bound, NULL));
	assert_true(bound[PRECISION_SINGLE] < 1e-3);
	assert_true(bound[PRECISION_DOUBLE] < 2e-12);
	s.projection.far = HUGE_VAL;
	assert_true(bounds_of(&s, bound, NULL));
	assert_true(bound[PRECISION_SINGLE] < 1e-3);
	assert_true(bound[PRECISION_DOUBLE] < 2e-12);
	/* with a singular world matrix the volume is infinite in model space */
	s.has_world = true;
	s.world.matrix[0][0] = s.world.matrix[1][1] = s.world.matrix[3][3] = 1;
	assert_true(bounds_of(&s, bound, NULL));
	assert_true(isnan(bound[PRECISION_EXACT]) != 0);
	s.has_world = false;
	s.projection = (struct projection){ .type = PROJECTION_MATRIX };
	for (int i = 0; i < 4; i++)
		s.projection.matrix[i][i] = 1;
	assert_true(bounds_of(&s, bound, NULL));
	assert_true(bound[PRECISION_EXACT] < 0x1.0001p-44);
}

/* Edges far to the right give the same bounds as edges far up. */
static void bounds_of_x_and_y_are_alike(void **state)
{
	struct scene right = { .projection = { .type = PROJECTION_PERSP,
				   .section.way = SECTION_EDGES,
				   .section.left = 99,
				   .section.right = 101,
				   .section.bottom = -3,
				   .section.top = 4,
				   .near = 1,
				   .far = 1000 } };
	struct scene above = right;
	double a[3], b[3];

	(void)state;
	above.projection.section.left = right.projection.section.bottom;
	above.projection.section.right = right.projection.section.top;
	above.projection.section.bottom = right.projection.section.left;
	above.projection.section.top = right.projection.section.right;
	assert_true(bounds_of(&right, a, NULL));
	assert_true(bounds_of(&above, b, NULL));
	for (int i = 0; i < 3; i++)
		assert_number(a[i], b[i]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(bounds_hold),
		cmocka_unit_test(ordinary_bounds_are_small),
		cmocka_unit_test(bounds_of_x_and_y_are_alike),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
