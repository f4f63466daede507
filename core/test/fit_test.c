/* SPDX-License-Identifier: MIT */
/* What fit makes holds its bounds, exactly, and no double is tighter. */
#include "../derive/fit.h"

#include "claims.h"
#include "../derive/frustum.h"

/* A linear function of model space. */
struct plane {
	struct form slope[4];
};

static struct plane column(const struct truth *t, int j)
{
	struct plane p;

	for (int i = 0; i < 4; i++)
		p.slope[i] = truth_element(t, i, j);
	return p;
}

/* sign a + factor b */
static struct plane combine(const struct plane *a, double sign,
    const struct plane *b, real factor)
{
	struct plane p;
	struct form f = { factor, magnitude(factor) };

	for (int i = 0; i < 4; i++)
		p.slope[i] = form_add(form_mul(form_of(sign), a->slope[i]),
		    form_mul(f, b->slope[i]));
	return p;
}

/* Its least value over the bounds. */
static struct form least(const struct plane *p, const struct bounds *b)
{
	struct form v = p->slope[3];

	for (int i = 0; i < 3; i++) {
		bool up = mpfr_sgn(p->slope[i].value) > 0;
		double at = b->sphere ? b->center[i] :
		    up                ? b->min[i] :
					b->max[i];

		v = form_add(v, form_mul(form_of(at), p->slope[i]));
	}
	if (b->sphere)
		v = form_sub(v,
		    form_mul(form_of(b->radius), form_length(p->slope)));
	return v;
}

static double value(real a)
{
	return mpfr_get_d(a, MPFR_RNDN);
}

/* How far bounds are inside of the planes of a fitted scene, left right bottom
 * top near far, in units of length: in the plane of the section for parallel
 * projections, along the gaze for near, far and persp. */
struct fitted {
	struct scene s;
	const struct bounds *b;
	struct form gap[6];
};

/* What persp's plane k gains for each unit that the eye goes back. */
static real slope(const struct scene *s, int k, real limit)
{
	real m[4][4];
	double sign = truth_gaze(&s->convention);

	truth_matrix(s, SPACE_VIEW, SPACE_CLIP, m);
	real x = mul(number(sign), m[2][k / 2]);

	return add(mul(number(k % 2 ? -1 : 1), x),
	    mul(limit, mul(number(sign), m[2][3])));
}

static double farthest(const double eye[3])
{
	return fmax(fabs(eye[0]), fmax(fabs(eye[1]), fabs(eye[2])));
}

static void measure_sides(struct fitted *f)
{
	const struct projection *p = &f->s.projection;
	bool persp = p->type == PROJECTION_PERSP;
	real limit[2];
	struct truth t;

	truth_limits(&f->s, limit);
	truth_scene(&f->s, SPACE_MODEL, SPACE_CLIP, &t);
	struct plane w = column(&t, 3);

	for (int k = 0; k < 4; k++) {
		struct plane x = column(&t, k / 2);
		real unit = persp ? slope(&f->s, k, limit[k / 2]) :
				    number(2 / (k < 2 ? p->width : p->height));

		x = combine(&x, k % 2 ? -1 : 1, &w, limit[k / 2]);
		f->gap[k] = least(&x, f->b);
		f->gap[k].value = over(f->gap[k].value, unit);
		f->gap[k].size = over(f->gap[k].size, unit);
	}
}

static void measure(struct fitted *f)
{
	const struct scene *s = &f->s;
	struct truth t;

	measure_sides(f);
	truth_scene(s, SPACE_MODEL, SPACE_VIEW, &t);
	for (int k = 4; k < 6; k++) {
		double sign = truth_gaze(&s->convention) * (k == 4 ? 1 : -1);
		struct plane z = column(&t, 2);

		z = combine(&z, sign, &z, number(0));
		f->gap[k] = form_add(least(&z, f->b),
		    form_of(k == 4 ? -s->projection.near : s->projection.far));
		/* intrinsics may have w = z + pw */
		if (s->projection.type == PROJECTION_PERSP &&
		    s->projection.extent == EXTENT_INTRINSICS)
			f->gap[k] = form_add(f->gap[k],
			    form_of((k == 4 ? 1 : -1) *
				s->projection.intrinsics[2][3]));
	}
}

static bool holds(const struct fitted *f)
{
	bool doubtful;

	for (int k = 0; k < 6; k++)
		if (truth_sign(f->gap[k], &doubtful) < 0 && !doubtful)
			return false;
	return true;
}

/* The gap is less than one unit in the last place of v, on the side to which
 * v would go: no double is tighter. */
static bool is_tight(struct form gap, double v, double inward)
{
	struct form ulp = form_sub(form_of(nextafter(v, inward)), form_of(v));
	bool doubtful;

	ulp.value = magnitude(ulp.value);
	return truth_sign(form_sub(ulp, gap), &doubtful) > 0 || doubtful;
}

/* What an eye that is rounded can cost. */
static double terms(const struct fitted *f, int k)
{
	return farthest(f->s.camera.eye) + value(f->gap[k].size);
}

/* The eye is on the axis, as far as it is rounded. */
static bool is_centered(const struct fitted *f)
{
	for (int k = 0; k < 4; k += 2)
		if (fabs(value(sub(f->gap[k].value, f->gap[k + 1].value))) >
		    0x1p-48 * terms(f, k))
			return false;
	return true;
}

/* The shorter side may be wider than the bounds. */
static bool sides_tight(const struct fitted *f)
{
	const struct projection *p = &f->s.projection;
	bool tight[2];
	real limit[2];

	truth_limits(&f->s, limit);
	for (int j = 0; j < 2; j++) {
		double side = j == 0 ? p->width : p->height;
		const struct form *gap = &f->gap[2 * j];
		struct form less = mpfr_less_p(gap[1].value, gap[0].value) ?
		    gap[1] :
		    gap[0];
		real twice = over(number(2), limit[j]);

		/* gap / limit is half of what the side has too much */
		tight[j] = is_tight(form_mul(less,
					(struct form){ twice, twice }),
		    side, 0);
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

	if (mpfr_cmp(number(p->near),
		mul(number(p->near_ratio), number(p->far))) < 0)
		return false;
	for (int k = 0; k < 4; k++)
		if (value(f->gap[k].value) <= 0x1p-48 * terms(f, k))
			return true;
	return p->near - p->near_ratio * p->far <= 0x1p-48 * terms(f, 5);
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

/* About the gaze. */
static void sample_calibrated(struct scene *s)
{
	struct projection *p = &s->projection;
	struct viewport *v = &s->viewport;
	double(*k)[4] = p->intrinsics;

	*v = (struct viewport){ .width = 640, .height = 480, .max_z = 1 };
	s->has_viewport = true;
	p->width = v->width;
	p->height = v->height;
	memset(k, 0, sizeof p->intrinsics);
	k[0][0] = k[1][1] = sample_between(200, 2000);
	k[0][1] = sample_below(2) ? 0 : sample_between(-2, 2);
	k[0][2] = sample_between(200, 400);
	k[1][2] = sample_between(150, 300);
	k[2][2] = 1;
	for (int i = 0; i < 3 && sample_below(2); i++)
		k[i][3] = sample_between(-0.1, 0.1);
}

static void sample_fit(struct scene *s, int e)
{
	struct projection *p = &s->projection;

	sample_scene(s, e);
	s->has_camera = sample_below(8) > 0;
	s->has_viewport = sample_below(2);
	s->margin = sample_below(2) ? 0 : sample_between(0, 0.49);
	if (p->type == PROJECTION_VOLUME && p->aspect[1] == 0)
		p->aspect[0] = p->aspect[1] = 1;
	p->type = PROJECTION_PERSP + sample_below(3);
	p->extent = sample_below(p->type == PROJECTION_PERSP ? 10 : 8);
	p->edges_at = sample_below(2) ? 0 : sample_size(1);
	if (p->type != PROJECTION_PERSP)
		p->aspect[1] = sample_below(2) ? p->aspect[1] : 0;
	if (p->extent < EXTENT_FIELD && !(p->angle < 180))
		p->angle = 60;
	p->near_ratio = sample_below(2) ? 0.0005 : sample_between(0, 0.5);
	p->left = -sample_size(1);
	p->right = sample_size(1);
	p->bottom = sample_size(1);
	p->top = -p->bottom;
	p->near = sample_size(1);
	p->projector = sample_between(20, 90);
	if (p->extent == EXTENT_ANGLES) {
		p->unit = DEGREES;
		p->left = sample_between(-60, -10);
		p->right = sample_between(10, 60);
		p->bottom = sample_between(-60, -10);
		p->top = sample_between(10, 60);
	}
	if (p->extent == EXTENT_INTRINSICS)
		sample_calibrated(s);
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
		assert_true(is_tight(f.gap[4], p->near, HUGE_VAL));
		assert_true(is_tight(f.gap[5], p->far, -HUGE_VAL));
		if (p->type == PROJECTION_PERSP)
			assert_true(eye_tight(&f));
		else
			assert_true(is_centered(&f) && sides_tight(&f));
		assert_true(flags_tight(&f));
		real_release(mark);
		fitted++;
	}
	return fitted;
}

static void test_ordinary(void **state)
{
	(void)state;
	sample_seed(1);
	assert_in_range(fit_many(300, 0), 225, 300);
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
