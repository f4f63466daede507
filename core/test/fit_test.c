#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../fit.h"
#include "../frustum.h"
#include "sample.h"
#include "truth.h"

/* Of the terms of a sum: more than the arithmetic's error. */
#define SLACK 0x1p-98

/* A linear function of model space, and what its terms come to. */
struct plane {
	real slope[4], sum[4];
};

static struct plane column(real m[4][4], real sum[4][4], int j)
{
	struct plane p;

	for (int i = 0; i < 4; i++) {
		p.slope[i] = m[i][j];
		p.sum[i] = sum[i][j];
	}
	return p;
}

/* sign a + factor b */
static struct plane combine(const struct plane *a, double sign,
    const struct plane *b, real factor)
{
	struct plane p;

	for (int i = 0; i < 4; i++) {
		p.slope[i] = add(mul(number(sign), a->slope[i]),
		    mul(factor, b->slope[i]));
		p.sum[i] = add(a->sum[i], mul(factor, b->sum[i]));
	}
	return p;
}

/* Its least value over the bounds, and *size its terms. */
static real least(const struct plane *p, const struct bounds *b, double *size)
{
	real v = p->slope[3], s = p->sum[3], square = number(0);

	for (int i = 0; i < 3; i++) {
		bool up = mpfr_sgn(p->slope[i]) > 0;
		double at = b->sphere ? b->center[i] :
		    up                ? b->min[i] :
					b->max[i];
		double most = fabs(at) + (b->sphere ? b->radius : 0);

		v = add(v, mul(number(at), p->slope[i]));
		s = add(s, mul(number(most), p->sum[i]));
		square = add(square, mul(p->slope[i], p->slope[i]));
	}
	if (b->sphere)
		v = sub(v, mul(number(b->radius), root(square)));
	*size = mpfr_get_d(s, MPFR_RNDU);
	return v;
}

static double value(real a)
{
	return mpfr_get_d(a, MPFR_RNDN);
}

/* The planes of a fitted scene, all inward: left right bottom top near far,
 * each in units of length: distances in the plane of the section for parallel
 * projections, along the gaze for near, far and persp. */
struct fitted {
	struct scene s;
	const struct bounds *b;
	real gap[6];
	double size[6];
};

/* |X| <= limit w in viewport units: w width / (2 sx). */
static void limits(const struct scene *s, real limit[2])
{
	const struct viewport *v = &s->viewport;
	double larger = fmax(v->width, v->height);

	limit[0] = limit[1] = number(1);
	if (!s->has_viewport || v->scale == SCALE_FILL)
		return;
	bool given = v->scale == SCALE_GIVEN;

	limit[0] = over(number(v->width / 2),
	    number(given ? v->scales[0] : larger / 2));
	limit[1] = over(number(v->height / 2),
	    number(given ? v->scales[1] : larger / 2));
}

/* What persp's plane k gains for each unit that the eye goes back; and *across,
 * for each unit across the gaze. */
static real slope(const struct scene *s, int k, real limit, double *across)
{
	struct truth t;
	real m[4][4], sum[4][4];
	double sign = s->convention.right_handed ? -1 : 1;

	truth_scene(s, SPACE_VIEW, SPACE_CLIP, &t);
	truth_matrix(&t, m, sum);
	real x = mul(number(sign), m[2][k / 2]);

	*across = fabs(value(m[k / 2][k / 2]));
	return add(mul(number(k % 2 ? -1 : 1), x),
	    mul(limit, mul(number(sign), m[2][3])));
}

static double farthest(const double eye[3])
{
	return fmax(fabs(eye[0]), fmax(fabs(eye[1]), fabs(eye[2])));
}

static void measure(struct fitted *f)
{
	const struct scene *s = &f->s;
	bool persp = s->projection.type == PROJECTION_PERSP;
	real m[4][4], sum[4][4], limit[2], unit;
	double across = 0;
	struct truth t;

	limits(s, limit);
	truth_scene(s, SPACE_MODEL, SPACE_CLIP, &t);
	truth_matrix(&t, m, sum);
	struct plane w = column(m, sum, 3);

	for (int k = 0; k < 4; k++) {
		struct plane x = column(m, sum, k / 2);

		x = combine(&x, k % 2 ? -1 : 1, &w, limit[k / 2]);
		unit = persp ?
		    slope(s, k, limit[k / 2], &across) :
		    number(2 /
			(k < 2 ? s->projection.width : s->projection.height));
		f->gap[k] = over(least(&x, f->b, &f->size[k]), unit);
		f->size[k] += across * farthest(s->camera.eye);
		f->size[k] = f->size[k] / value(unit) + farthest(s->camera.eye);
	}
	truth_scene(s, SPACE_MODEL, SPACE_VIEW, &t);
	truth_matrix(&t, m, sum);
	for (int k = 4; k < 6; k++) {
		double sign = (k == 4) == !s->convention.right_handed ? 1 : -1;
		struct plane z = column(m, sum, 2);

		z = combine(&z, sign, &z, number(0));
		f->gap[k] = least(&z, f->b, &f->size[k]);
		f->gap[k] = k == 4 ?
		    sub(f->gap[k], number(s->projection.near)) :
		    add(f->gap[k], number(s->projection.far));
	}
}

/* Nothing is outside by more than the arithmetic's error. */
static bool holds(const struct fitted *f)
{
	for (int k = 0; k < 6; k++)
		if (!(value(f->gap[k]) >= -SLACK * f->size[k]))
			return false;
	return true;
}

/* The gap is less than one unit in the last place of v, on the side to which
 * v would go: no double is tighter. */
static bool is_tight(real gap, double size, double v, double inward)
{
	real ulp = sub(number(nextafter(v, inward)), number(v));

	return value(sub(magnitude(ulp), gap)) > -SLACK * size;
}

/* The eye is on the axis, as far as it is rounded. */
static bool is_centered(const struct fitted *f)
{
	for (int k = 0; k < 4; k += 2)
		if (fabs(value(sub(f->gap[k], f->gap[k + 1]))) >
		    0x1p-48 * (farthest(f->s.camera.eye) + f->size[k]))
			return false;
	return true;
}

/* The shorter side may be wider than the bounds. */
static bool sides_tight(const struct fitted *f)
{
	const struct projection *p = &f->s.projection;
	bool tight[2];
	real limit[2];

	limits(&f->s, limit);
	for (int j = 0; j < 2; j++) {
		double side = j == 0 ? p->width : p->height;
		int k = 2 * j +
		    (value(f->gap[2 * j + 1]) < value(f->gap[2 * j]));

		/* gap / limit is half of what the side has too much */
		tight[j] = is_tight(mul(number(2), over(f->gap[k], limit[j])),
		    f->size[k] / value(limit[j]), side, 0);
	}
	if (p->aspect[1] == 0 || (tight[0] && tight[1]))
		return tight[0] && tight[1];
	real aspect = over(number(p->aspect[0]), number(p->aspect[1]));

	return tight[0] ?
	    value(over(number(p->width), aspect)) == p->height :
	    tight[1] && value(mul(number(p->height), aspect)) == p->width;
}

/* The eye is rounded across the gaze too, which a narrow view magnifies: what
 * a plane or the ratio lets it go farther is little of the terms. */
static bool eye_tight(const struct fitted *f)
{
	const struct projection *p = &f->s.projection;
	double eye = farthest(f->s.camera.eye);

	if (mpfr_cmp(number(p->near),
		mul(number(p->near_ratio), number(p->far))) < 0)
		return false;
	for (int k = 0; k < 4; k++)
		if (value(f->gap[k]) <= 0x1p-48 * f->size[k])
			return true;
	return p->near - p->near_ratio * p->far <= 0x1p-48 * (eye + f->size[5]);
}

static unsigned flags(const struct scene *s, const struct bounds *b)
{
	unsigned out;

	assert_null(bounds_out(b, s, &out));
	return out;
}

/* By the flags too, near and far could not be one double tighter; from 0 that
 * is by less than they see. */
static bool flags_tight(const struct fitted *f)
{
	struct scene near = f->s, far = f->s;

	near.projection.near = nextafter(near.projection.near, HUGE_VAL);
	far.projection.far = nextafter(far.projection.far, -HUGE_VAL);
	if (!(near.projection.near < far.projection.far))
		return true;
	return (f->s.projection.near == 0 || flags(&near, f->b) & OUT_NEAR) &&
	    (f->s.projection.far == 0 || flags(&far, f->b) & OUT_FAR);
}

static void sample_bounds(struct bounds *b, int e)
{
	memset(b, 0, sizeof *b);
	b->sphere = sample_below(2);
	b->radius = sample_size(e > 0 ? e : 1);
	for (int i = 0; i < 3; i++) {
		b->center[i] = sample_below(4) == 0 ? 0 : sample_number(e + 1);
		b->min[i] = b->center[i] - sample_size(e > 0 ? e : 1);
		b->max[i] = b->center[i] + sample_size(e > 0 ? e : 1);
		if (sample_below(3) == 0) {
			b->min[i] = floor(b->min[i]);
			b->max[i] = ceil(b->max[i]);
		}
	}
}

static void sample_fit(struct scene *s, int e)
{
	struct projection *p = &s->projection;

	sample_scene(s, e);
	s->has_camera = sample_below(8) > 0;
	s->has_viewport = sample_below(2);
	p->type = PROJECTION_PERSP + sample_below(3);
	p->extent = sample_below(7);
	if (p->type != PROJECTION_PERSP)
		p->aspect[1] = sample_below(2) ? p->aspect[1] : 0;
	else if (p->extent == EXTENT_HEIGHT)
		p->extent = EXTENT_SIZE;
	if (p->extent < EXTENT_FIELD && !(p->angle < 180))
		p->angle = 60;
	p->near_ratio = sample_below(2) ? 0.0005 : sample_between(0, 0.5);
	p->left = -sample_size(1);
	p->right = sample_size(1);
	p->bottom = sample_size(1);
	p->top = -p->bottom;
	p->near = sample_size(1);
	p->projector = sample_between(20, 90);
}

/* Fits many scenes; what is refused is not looked at. Returns how many hold in
 * every way. */
static int fit_many(int n, int e)
{
	int fitted = 0;

	for (int i = 0; i < n; i++) {
		struct bounds b;
		struct fitted f = { .b = &b };
		const struct projection *p = &f.s.projection;
		int mark = real_mark();

		sample_fit(&f.s, e);
		sample_bounds(&b, e);
		if (fit_scene(&f.s, sample_below(2), &b) != NULL)
			continue;
		measure(&f);
		assert_true(holds(&f));
		assert_int_equal(flags(&f.s, &b), 0);
		assert_true(is_tight(f.gap[4], f.size[4], p->near, HUGE_VAL));
		assert_true(is_tight(f.gap[5], f.size[5], p->far, -HUGE_VAL));
		if (p->type == PROJECTION_PERSP)
			assert_true(eye_tight(&f));
		else
			assert_true(is_centered(&f) && sides_tight(&f));
		assert_true(e > 0 || flags_tight(&f));
		real_release(mark);
		fitted++;
	}
	return fitted;
}

static void test_ordinary(void **state)
{
	(void)state;
	sample_seed(1);
	assert_in_range(fit_many(300, 0), 250, 300);
}

static void test_mixed(void **state)
{
	(void)state;
	sample_seed(2);
	assert_in_range(fit_many(250, 4), 150, 250);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ordinary),
		cmocka_unit_test(test_mixed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
