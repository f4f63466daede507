#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "points.h"
#include "../frustum.h"

/* A value and the sum of its products' sizes. */
struct form {
	real value, size;
};

/* Half the points to within rounding on a plane, as seen from ndc. */
static void onto_planes(const struct scene *s, enum space from, struct block *b)
{
	struct transform t;
	static struct block image;

	if (scene_transform(s, SPACE_NDC, from, false, &t) != NULL)
		return;
	for (size_t i = 0; i < POINTS; i++) {
		for (int j = 0; j < 3; j++)
			image.in[j][i] = sample_between(-1, 1);
		image.in[sample_below(3)][i] = (double)sample_below(3) - 1;
	}
	carry(&t, (struct accuracy){ PRECISION_EXACT, 0 }, &image, POINTS);
	for (size_t i = 0; i < POINTS; i += 2)
		for (int j = 0; j < 3 && !isnan(image.out[0][i]); j++)
			b->in[j][i] = image.out[j][i];
}

/* Of the side planes |X| = limit w; the viewport's scale moves them. */
static real limit_of(const struct scene *s, int k)
{
	const struct viewport *v = &s->viewport;
	double size = k == 0 ? v->width : v->height;
	real half = over(number(size), number(2));

	if (!s->has_viewport || v->scale == SCALE_FILL)
		return number(1);
	if (v->scale == SCALE_UNIFORM)
		return over(half,
		    over(number(fmax(v->width, v->height)), number(2)));
	return over(half, number(v->scales[k]));
}

/* left right bottom top near far, of clip coordinates. */
static void planes_of(const struct scene *s, real q[4], real sum[4],
    struct form form[6])
{
	for (int k = 0; k < 6; k++) {
		bool high = k & 1;
		real limit = k < 4 ? limit_of(s, k / 2) : number(1);

		if ((k == 2 || k == 3) && s->convention.ndc_y_down)
			high = !high;
		if (k >= 4 && s->projection.reverse_z)
			high = !high;
		if (k >= 4 && !high && !s->convention.minus_one)
			limit = number(0);
		real x = high ? negative(q[k / 2]) : q[k / 2];

		form[k].value = add(x, mul(limit, q[3]));
		form[k].size = add(sum[k / 2], mul(limit, sum[3]));
	}
}

/* Its sign, where it is more than 64 u^2 of its products: else 0. */
static int sign_of(struct form f, bool *known)
{
	double ratio = mpfr_zero_p(f.size) ?
	    0 :
	    mpfr_get_d(over(f.value, f.size), MPFR_RNDN);

	*known = ratio == 0 || fabs(ratio) > 0x1p-100;
	return ratio > 0 ? 1 : ratio < 0 ? -1 : 0;
}

static void check_planes(const struct scene *s, const struct truth *to_clip,
    const struct truth *to_view, bool back, const double p[4], unsigned out,
    size_t count[2])
{
	real q[4], sum[4], v[4], v_sum[4];
	struct form form[6], front;
	bool known;

	truth_image(to_clip, p, q, sum);
	front = (struct form){ q[3], sum[3] };
	if (back) {
		truth_image(to_view, p, v, v_sum);
		front = (struct form){ v[3], v_sum[3] };
	}
	int w = sign_of(front, &known);

	if (known)
		assert_int_equal(out == OUT_BEHIND, w <= 0);
	if (out == OUT_BEHIND || !known)
		return;
	planes_of(s, q, sum, form);
	for (int k = 0; k < 6; k++) {
		int sign = sign_of(form[k], &known);

		count[0]++;
		count[1] += !known || sign == 0;
		if (known)
			assert_int_equal(out >> k & 1, sign < 0);
	}
}

/* A scene seen from one of its spaces, with points on planes among others. */
static bool sample_frustum(int e, struct scene *s, enum space *from,
    struct frustum *f, struct block *b)
{
	static const enum space spaces[] = { SPACE_MODEL, SPACE_WORLD,
		SPACE_VIEW, SPACE_NDC, SPACE_DEVICE };

	sample_scene(s, e);
	s->has_viewport = sample_below(4) > 0;
	*from = spaces[sample_below(s->has_viewport ? 5 : 4)];
	if (frustum_of(s, *from, false, f) != NULL)
		return false;
	sample_points(s, *from, b, POINTS);
	onto_planes(s, *from, b);
	return true;
}

static void planes_are_told(void **state)
{
	static struct block b;
	struct scene s;
	struct frustum f;
	enum space from;
	size_t count[2] = { 0, 0 };

	(void)state;
	points_choose(NULL);
	sample_seed(1);
	for (int k = 0; k < 900; k++) {
		struct truth to_clip = { 0 }, to_view = { 0 };
		int mark = real_mark();

		if (!sample_frustum(k % 3 * 4, &s, &from, &f, &b))
			continue;
		truth_scene(&s, from, SPACE_CLIP, &to_clip);
		truth_scene(&s, from, SPACE_VIEW, &to_view);
		for (size_t i = 0; i < POINTS; i++) {
			double p[4] = { b.in[0][i], b.in[1][i], b.in[2][i], 1 };
			int point = real_mark();

			check_planes(&s, &to_clip, &to_view, from >= SPACE_NDC,
			    p, frustum_out(&f, p), count);
			real_release(point);
		}
		real_release(mark);
	}
	print_message("%zu planes, %zu of them within 2^-100 of the point\n",
	    count[0], count[1]);
	assert_true(count[0] > 10000 && count[1] > 500);
}

/* The worst kappa of a point; on the screen what is less than a unit counts as
 * one. */
static double worst_kappa(const struct transform *t, real q[4], real sum[4])
{
	double w = t->divide ? truth_kappa(q, sum, 3, false) : 1, worst = 1;

	for (int j = 0; j < 3; j++) {
		real least = t->on_screen ? q[3] : number(0);
		bool less = mpfr_cmpabs(q[j], least) < 0;
		real value = magnitude(less ? least : q[j]);

		if (!mpfr_zero_p(value))
			worst = fmax(worst,
			    mpfr_get_d(over(sum[j], value), MPFR_RNDN));
	}
	return w * worst;
}

/* As point_exact counts it, and as MPFR does but for a factor of 4. */
static void ill_is_told(void **state)
{
	static struct block b;
	struct scene s;
	struct frustum f;
	struct transform t;
	enum space from;
	size_t n[2] = { 0, 0 };

	(void)state;
	sample_seed(2);
	for (int k = 0; k < 900; k++) {
		struct truth truth = { 0 };
		int mark = real_mark();
		enum space to = sample_below(2) ? SPACE_NDC : SPACE_VIEW;

		if (!sample_frustum(k % 3 * 4, &s, &from, &f, &b) ||
		    scene_transform(&s, from, to, false, &t) != NULL)
			continue;
		truth_scene(&s, from, to, &truth);
		for (size_t i = 0; i < POINTS; i++) {
			double p[4] = { b.in[0][i], b.in[1][i], b.in[2][i], 1 };
			double image[4], kappa;
			bool ill = point_is_ill(&t, p);
			int point = real_mark();
			real q[4], sum[4];

			point_exact(&t, p, image, &kappa);
			assert_int_equal(ill, kappa > POINTS_ILL);
			n[ill]++;
			if (exact_image(&truth, &t, &b, i, q, sum)) {
				double worst = worst_kappa(&t, q, sum);

				assert_false(ill && worst < POINTS_ILL / 4);
				assert_false(!ill && worst > POINTS_ILL * 4 &&
				    worst < 0x1p80);
			}
			real_release(point);
		}
		real_release(mark);
	}
	print_message("%zu points well, %zu ill\n", n[0], n[1]);
	assert_true(n[0] > 5000 && n[1] > 500);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(planes_are_told),
		cmocka_unit_test(ill_is_told),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
