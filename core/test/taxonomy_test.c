#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "sample.h"
#include "../taxonomy.h"
#include "truth.h"

/* How far what was got is off, in units of kappa 2^-47 units in the last place
 * beyond half a one. */
static double excess(double got, real exact, real kappa)
{
	double k = mpfr_get_d(kappa, MPFR_RNDU);

	/* all digits may be lost */
	if (!(k < 0x1p90))
		return 0;
	assert_true(!isnan(got));
	return (ulps(got, exact) - 0.5) / k * 0x1p47;
}

static void keep_worst(double *worst, double e)
{
	assert_true(e <= 1);
	if (e > *worst)
		*worst = e;
}

static void check_point(const double *got, real h[4], real size[4], int n,
    double *worst)
{
	for (int j = 0; j < n; j++) {
		real exact = over(h[j], h[3]);
		real kappa = mul(over(size[j], magnitude(h[j])),
		    over(size[3], magnitude(h[3])));

		if (got[j] == 0 && is_zero(h[j], size[j]))
			continue;
		keep_worst(worst, excess(got[j], exact, kappa));
	}
}

static void check_vanishing_points(const struct scene *s,
    const struct taxonomy *t, double *worst)
{
	struct truth truth;
	real m[4][4], sum[4][4];

	truth_scene(s, SPACE_WORLD, SPACE_DEVICE, &truth);
	truth_matrix(&truth, m, sum);
	real all = add(add(sum[0][3], sum[1][3]), sum[2][3]);

	for (int i = 0; i < 3; i++) {
		if (is_zero(m[i][3], all))
			assert_true(isnan(t->vanishing_point[i][0]) != 0);
		else
			check_point(t->vanishing_point[i], m[i], sum[i], 2,
			    worst);
	}
}

/* From the inverse matrix: the eye where x, y and w are 0, and the corners, at
 * the sides that the viewport's scale cuts. */
static void check_places(const struct scene *s, const struct taxonomy *t,
    double *worst)
{
	static const int side[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 },
		{ -1, 1 } };
	const struct viewport *v = &s->viewport;
	double larger = fmax(v->width, v->height) / 2;
	double sx = v->scale == SCALE_GIVEN ? v->scales[0] :
	    v->scale == SCALE_FILL          ? v->width / 2 :
					      larger;
	double sy = v->scale == SCALE_GIVEN ? v->scales[1] :
	    v->scale == SCALE_FILL          ? v->height / 2 :
					      larger;
	struct truth truth;
	real m[4][4], sum[4][4], clip[4] = { [3] = number(1) };

	truth_scene(s, SPACE_CLIP, SPACE_WORLD, &truth);
	truth_matrix(&truth, m, sum);
	real row = add(add(sum[2][0], sum[2][1]), add(sum[2][2], sum[2][3]));
	real all = add(add(sum[0][3], sum[1][3]), add(sum[2][3], sum[3][3]));

	if (is_zero(m[2][3], row))
		assert_true(isnan(t->eye[0]) != 0);
	else
		check_point(t->eye, m[2], sum[2], 3, worst);
	for (int c = 0; c < 8; c++) {
		double y = side[c % 4][1] * (s->convention.ndc_y_down ? -1 : 1);
		real h[4], size[4];

		clip[0] = number(side[c % 4][0] * v->width / 2);
		clip[0] = over(clip[0], number(sx));
		clip[1] = over(number(y * v->height / 2), number(sy));
		clip[2] = number((c >= 4) != t->reversed ? 1 :
			s->convention.minus_one          ? -1 :
							   0);
		for (int j = 0; j < 4; j++) {
			h[j] = size[j] = number(0);
			for (int i = 0; i < 4; i++) {
				h[j] = add(h[j], mul(clip[i], m[i][j]));
				size[j] = add(size[j],
				    mul(magnitude(clip[i]), sum[i][j]));
			}
		}
		if (mpfr_sgn(h[3]) <= 0 || is_zero(h[3], all))
			assert_true(isnan(t->corner[c][0]) != 0);
		else
			check_point(t->corner[c], h, size, 3, worst);
	}
}

/* Between the planes' normals, by the law of cosines. */
static void check_fov(const struct scene *s, const struct taxonomy *t,
    double *worst)
{
	const struct viewport *v = &s->viewport;
	double side[2] = { v->width, v->height };
	double larger = fmax(v->width, v->height);
	struct truth truth;
	real m[4][4], sum[4][4];

	truth_scene(s, SPACE_VIEW, SPACE_CLIP, &truth);
	truth_matrix(&truth, m, sum);
	for (int k = 0; k < 2; k++) {
		double scale = v->scale == SCALE_FILL ? side[k] :
		    v->scale == SCALE_UNIFORM         ? larger :
							2 * v->scales[k];
		real limit = over(number(side[k]), number(scale)), a[3], b[3];

		for (int i = 0; i < 3; i++) {
			real w = mul(limit, m[i][3]);

			a[i] = add(w, m[i][k]);
			b[i] = sub(m[i][k], w);
		}
		normalise(a, 3);
		normalise(b, 3);
		real angle = dot(a, b, 3);

		mpfr_acos(angle, angle, MPFR_RNDN);
		mpfr_mul_ui(angle, angle, 180, MPFR_RNDN);
		mpfr_const_pi(a[0], MPFR_RNDN);
		double e = ulps(t->fov[k], over(angle, a[0])) - 0.5;

		assert_true(e < 0x1p-40);
		if (e * 0x1p40 > *worst)
			*worst = e * 0x1p40;
	}
}

static void axes_of(const struct scene *s, real axis[4][4])
{
	struct truth truth;
	real sum[4][4];

	truth_scene(s, SPACE_WORLD, SPACE_VIEW, &truth);
	truth_matrix(&truth, axis, sum);
}

/* An axis is a combination of the projector and two perpendicular directions in
 * the plane; its image has the length of the latter. */
static void check_foreshortening(const struct scene *s,
    const struct taxonomy *t, double *worst)
{
	struct truth truth;
	real m[4][4], sum[4][4], axis[4][4], basis[4][4], in[4][4];
	real x[3], y[3], n[3], zero[3], *d = basis[0];

	truth_scene(s, SPACE_VIEW, SPACE_CLIP, &truth);
	truth_matrix(&truth, m, sum);
	axes_of(s, axis);
	set_unit(basis);
	for (int i = 0; i < 3; i++) {
		x[i] = m[i][0];
		y[i] = m[i][1];
		n[i] = m[i][2];
	}
	normalise(n, 3);
	cross(x, y, d);
	normalise(d, 3);
	set(zero, 3, (double[]){ 0.6, -0.48, 0.64 });
	cross(n, zero, basis[1]);
	normalise(basis[1], 3);
	cross(n, basis[1], basis[2]);
	set_inverse(in, basis);
	for (int i = 0; i < 3; i++) {
		real part[3], size = root(dot(axis[i], axis[i], 3));

		for (int k = 0; k < 3; k++) {
			real column[3] = { in[0][k], in[1][k], in[2][k] };

			part[k] = dot(axis[i], column, 3);
		}
		real f = root(dot(part + 1, part + 1, 2));
		real kappa = over(size, mul(f, magnitude(dot(n, d, 3))));

		if (t->foreshortening[i] > 0 || !is_zero(f, size))
			keep_worst(worst,
			    excess(t->foreshortening[i], f, kappa));
	}
}

/* The gradient of what is constant on the plane, and it leads to far. */
static void check_gaze(const struct scene *s, const struct taxonomy *t,
    double *worst)
{
	bool parallel = t->taxon <= TAXON_OBLIQUE;
	struct truth truth;
	real m[4][4], sum[4][4], n[3], size[3];

	truth_scene(s, SPACE_WORLD, SPACE_CLIP, &truth);
	truth_matrix(&truth, m, sum);
	for (int i = 0; i < 3; i++) {
		n[i] = m[i][parallel ? 2 : 3];
		size[i] = over(sum[i][parallel ? 2 : 3], magnitude(n[i]));
	}
	normalise(n, 3);
	for (int i = 0; i < 3; i++)
		if (t->gaze[i] != 0)
			keep_worst(worst,
			    excess(fabs(t->gaze[i]), magnitude(n[i]), size[i]));
	for (int i = 0; i < 4; i++) {
		double ahead = 0, least = 0;

		for (int j = 0; j < 3; j++) {
			ahead += t->gaze[j] * t->corner[4 + i][j];
			ahead -= t->gaze[j] * t->corner[i][j];
			least += 0x1p-40 *
			    (fabs(t->corner[i][j]) + fabs(t->corner[4 + i][j]));
		}
		assert_true(ahead >= -least || isnan(ahead));
	}
}

static void numbers_are_true(void **state)
{
	double worst[5] = { 0 };
	struct scene s;
	struct taxonomy t;
	int n[2] = { 0, 0 };

	(void)state;
	sample_seed(31);
	for (int k = 0; k < 400; k++) {
		int mark = real_mark();

		sample_scene(&s, k % 3 * 10);
		if (taxonomy_of(&s, &t) != NULL)
			continue;
		bool parallel = t.taxon <= TAXON_OBLIQUE;

		n[parallel]++;
		assert_true(isnan(t.fov[0]) == parallel);
		assert_true(isnan(t.foreshortening[0]) == !parallel);
		check_places(&s, &t, &worst[0]);
		check_gaze(&s, &t, &worst[1]);
		if (parallel) {
			check_foreshortening(&s, &t, &worst[2]);
		} else {
			check_vanishing_points(&s, &t, &worst[3]);
			check_fov(&s, &t, &worst[4]);
		}
		real_release(mark);
	}
	print_message(
	    "%d perspective, %d parallel; of their bounds: places "
	    "%.3g, gazes %.3g, foreshortenings %.3g, vanishing points %.3g, "
	    "angles %.3g\n",
	    n[0], n[1], worst[0], worst[1], worst[2], worst[3], worst[4]);
	assert_true(n[0] > 90 && n[1] > 90);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(numbers_are_true),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
