/* SPDX-License-Identifier: MIT */
/* The volume of the scene that fit makes contains its bounds, or all points of a cloud,
 * exactly. No double for near, far or a size makes the volume smaller. */
#include "../derive/fit.h"

#include "claims.h"
#include "../derive/frustum.h"

static struct refusals faults, faults_of_all;

/* Points in columns, padded to a multiple of 16 numbers. */
struct cloud {
	size_t n;
	COLUMN_ALIGNED double in[3][32];
};

/* The linear function of a plane: the gradient in model space, and the constant. */
struct plane {
	struct sized slope[4];
};

static struct plane plane_of_column(const struct truth *t, int j)
{
	struct plane p;

	for (int i = 0; i < 4; i++)
		p.slope[i] = truth_element(t, i, j);
	return p;
}

/* Returns the function sign a + factor b. */
static struct plane combine(const struct plane *a, double sign, const struct plane *b,
    real factor)
{
	struct plane p;
	struct sized f = { factor, magnitude(factor) };

	for (int i = 0; i < 4; i++)
		p.slope[i] = sized_add(sized_mul(sized_of(sign), a->slope[i]),
		    sized_mul(f, b->slope[i]));
	return p;
}

static struct sized value_at_point(const struct plane *p, const struct cloud *c,
    size_t n)
{
	struct sized v = p->slope[3];

	for (int i = 0; i < 3; i++)
		v = sized_add(v, sized_mul(sized_of(c->in[i][n]), p->slope[i]));
	return v;
}

/* Returns the least value of a function on the bounds or, if there is a cloud, on its
 * points. */
static struct sized least(const struct plane *p, const struct bounds *b,
    const struct cloud *c)
{
	struct sized lowest = p->slope[3];

	for (size_t n = 0; n < c->n; n++) {
		struct sized at = value_at_point(p, c, n);

		if (n == 0 || mpfr_less_p(at.value, lowest.value))
			lowest = at;
	}
	if (c->n > 0)
		return lowest;
	struct sized v = p->slope[3];

	for (int i = 0; i < 3; i++) {
		bool up = mpfr_sgn(p->slope[i].value) > 0;
		double at = b->sphere ? b->center[i] : up ? b->min[i] : b->max[i];

		v = sized_add(v, sized_mul(sized_of(at), p->slope[i]));
	}
	if (b->sphere)
		v = sized_sub(v,
		    sized_mul(sized_of(b->radius), sized_length(p->slope)));
	return v;
}

static double nearest_double(real a)
{
	return mpfr_get_d(a, MPFR_RNDN);
}

/* A fitted scene, and the gaps between the bounds and the planes left, right, bottom,
 * top, near and far. The gap of near, far and a plane of persp is measured along the
 * gaze, the gap of another side plane in the plane of the cross-section. */
struct fitted {
	struct scene s;
	const struct bounds *b;
	struct cloud cloud; /* empty if b is not of points */
	struct sized gap[6];
};

/* Returns how much the function of side plane k of a perspective grows at a fixed point
 * while the eye moves back by 1. */
static real slope(const struct scene *s, int k, real limit)
{
	real m[4][4];
	double sign = truth_gaze_sign(&s->convention);

	truth_matrix(s, SPACE_VIEW, SPACE_CLIP, m);
	real x = mul(real_of(sign), m[2][k / 2]);

	return add(mul(real_of(k % 2 ? -1 : 1), x),
	    mul(limit, mul(real_of(sign), m[2][3])));
}

static double largest_coordinate(const double eye[3])
{
	return fmax(fabs(eye[0]), fmax(fabs(eye[1]), fabs(eye[2])));
}

static void measure_side_gaps(struct fitted *f)
{
	const struct projection *p = &f->s.projection;
	bool persp = projection_family(p) == FAMILY_PERSP;
	real limit[2];
	struct truth t;

	truth_limits(&f->s, limit);
	truth_scene(&f->s, SPACE_MODEL, SPACE_CLIP, &t);
	struct plane w = plane_of_column(&t, 3);

	for (int k = 0; k < 4; k++) {
		struct plane x = plane_of_column(&t, k / 2);
		real unit = persp ?
		    slope(&f->s, k, limit[k / 2]) :
		    real_of(2 / (k < 2 ? p->section.width : p->section.height));

		x = combine(&x, k % 2 ? -1 : 1, &w, limit[k / 2]);
		f->gap[k] = least(&x, f->b, &f->cloud);
		f->gap[k].value = divide(f->gap[k].value, unit);
		f->gap[k].size = divide(f->gap[k].size, unit);
	}
}

static void measure_gaps(struct fitted *f)
{
	const struct scene *s = &f->s;
	struct truth t;

	measure_side_gaps(f);
	truth_scene(s, SPACE_MODEL, SPACE_VIEW, &t);
	for (int k = 4; k < 6; k++) {
		double sign = truth_gaze_sign(&s->convention) * (k == 4 ? 1 : -1);
		struct plane z = plane_of_column(&t, 2);

		z = combine(&z, sign, &z, real_of(0));
		f->gap[k] = sized_add(least(&z, f->b, &f->cloud),
		    sized_of(k == 4 ? -s->projection.near : s->projection.far));
		/* w of intrinsics may be z plus a constant */
		if (projection_family(&s->projection) == FAMILY_PERSP &&
		    s->projection.section.way == SECTION_INTRINSICS)
			f->gap[k] = sized_add(f->gap[k],
			    sized_of((k == 4 ? 1 : -1) *
				s->projection.section.intrinsics[2][3]));
	}
}

static bool contains_bounds(const struct fitted *f)
{
	bool doubtful;

	for (int k = 0; k < 6; k++)
		if (truth_sign(f->gap[k], &doubtful) < 0 && !doubtful)
			return false;
	return true;
}

/* Returns whether the gap is less than the distance from v to the next double inward,
 * so that no double is tighter. */
static bool is_tight(struct sized gap, double v, double inward)
{
	struct sized ulp = sized_sub(sized_of(nextafter(v, inward)), sized_of(v));
	bool doubtful;

	ulp.value = magnitude(ulp.value);
	return truth_sign(sized_sub(ulp, gap), &doubtful) > 0 || doubtful;
}

/* Returns whether the bounds have an extent between planes k and k + 1, which are at
 * the given distance. If not, extents_widen has made the distance. */
static bool is_filled(const struct fitted *f, int k, double distance)
{
	real gaps = add(f->gap[k].value, f->gap[k + 1].value);

	return nearest_double(gaps) < distance * (1 - 0x1p-30);
}

static bool depth_tight(const struct fitted *f)
{
	const struct projection *p = &f->s.projection;

	return !is_filled(f, 4, p->far - p->near) ||
	    (is_tight(f->gap[4], p->near, HUGE_VAL) &&
		is_tight(f->gap[5], p->far, -HUGE_VAL));
}

/* Returns the size of the numbers whose rounding can change gap k. */
static double rounded_size(const struct fitted *f, int k)
{
	return largest_coordinate(f->s.camera.eye) + nearest_double(f->gap[k].size);
}

/* Returns whether opposite gaps are equal but for rounding. */
static bool is_centered(const struct fitted *f)
{
	for (int k = 0; k < 4; k += 2)
		if (fabs(nearest_double(sub(f->gap[k].value, f->gap[k + 1].value))) >
		    0x1p-48 * rounded_size(f, k))
			return false;
	return true;
}

/* Returns whether width and height are the tightest doubles. With an aspect, only one
 * of width and height has to be tight: the aspect gives the other. */
static bool sides_are_tight(const struct fitted *f)
{
	const struct projection *p = &f->s.projection;
	bool tight[2];
	real limit[2];

	truth_limits(&f->s, limit);
	for (int j = 0; j < 2; j++) {
		double side = j == 0 ? p->section.width : p->section.height;
		const struct sized *gap = &f->gap[2 * j];
		struct sized less = mpfr_less_p(gap[1].value, gap[0].value) ? gap[1] :
									      gap[0];
		real twice = divide(real_of(2), limit[j]);

		/* the side is too large by 2 gap / limit */
		tight[j] = !is_filled(f, 2 * j, side * nearest_double(limit[j])) ||
		    is_tight(sized_mul(less, (struct sized){ twice, twice }), side, 0);
	}
	if (p->aspect[1] == 0 || (tight[0] && tight[1]))
		return tight[0] && tight[1];
	real aspect = divide(real_of(p->aspect[0]), real_of(p->aspect[1]));

	return tight[0] ? nearest_double(divide(real_of(p->section.width), aspect)) ==
		p->section.height :
			  tight[1] &&
		nearest_double(mul(real_of(p->section.height), aspect)) ==
		    p->section.width;
}

/* Returns the size of the numbers whose rounding can move the eye along the gaze. A
 * rounding across the gaze moves it back by as much times the cotangent of the angle
 * between the gaze and a side plane. */
static double retreat_size(const struct fitted *f, const real limit[2])
{
	real m[4][4];
	int mark = real_mark();
	double most = rounded_size(f, 5);

	truth_matrix(&f->s, SPACE_VIEW, SPACE_CLIP, m);
	for (int k = 0; k < 4; k++) {
		real across = divide(magnitude(m[k / 2][k / 2]),
		    slope(&f->s, k, limit[k / 2]));

		most = fmax(most, rounded_size(f, k) * (1 + nearest_double(across)));
	}
	real_release(mark);
	return most;
}

/* Returns whether near is as near as near_ratio and min_near allow. */
static bool near_is_least(const struct fitted *f, const real limit[2])
{
	const struct projection *p = &f->s.projection;

	return p->near - fmax(p->near_ratio * p->far, p->min_near) <=
	    0x1p-48 * retreat_size(f, limit);
}

/* Returns whether the eye is as near as a side plane, near_ratio or min_near allows,
 * but for the rounding of the eye, also across the gaze. */
static bool eye_is_tight(const struct fitted *f)
{
	const struct projection *p = &f->s.projection;
	real limit[2];

	truth_limits(&f->s, limit);
	if (mpfr_cmp(real_of(p->near), mul(real_of(p->near_ratio), real_of(p->far))) <
		0 ||
	    p->near < p->min_near)
		return false;
	for (int k = 0; k < 4; k++)
		if (nearest_double(f->gap[k].value) <= 0x1p-48 * retreat_size(f, limit))
			return true;
	return near_is_least(f, limit);
}

/* Returns whether the functions of the planes of each pair have the same least value,
 * and one pair touches the bounds, or near is as near as it may be. */
static bool is_balanced(const struct fitted *f)
{
	real limit[2];
	bool touches = false;

	truth_limits(&f->s, limit);
	for (int k = 0; k < 4; k += 2) {
		real low = mul(f->gap[k].value, slope(&f->s, k, limit[k / 2]));
		real high = mul(f->gap[k + 1].value, slope(&f->s, k + 1, limit[k / 2]));
		real all = mul(real_of(retreat_size(f, limit)),
		    add(slope(&f->s, k, limit[k / 2]),
			slope(&f->s, k + 1, limit[k / 2])));

		if (fabs(nearest_double(sub(low, high))) >
		    0x1p-48 * nearest_double(all))
			return false;
		touches |= nearest_double(low) <= 0x1p-48 * nearest_double(all);
	}
	return touches || near_is_least(f, limit);
}

static unsigned out_bits(const struct scene *s, const struct fitted *f)
{
	struct frustum frustum;
	unsigned out = 0;

	if (f->cloud.n == 0) {
		struct hull h;

		assert_true(hull_of(f->b, 3, &h, NULL));
		return hull_outside(&h, s);
	}
	assert_true(frustum_of(s, SPACE_MODEL, false, &frustum, NULL));
	for (size_t n = 0; n < f->cloud.n; n++)
		out |= frustum_outside(&frustum,
		    (double[4]){ f->cloud.in[0][n], f->cloud.in[1][n],
			f->cloud.in[2][n] });
	return out;
}

/* Returns whether near and far would cut the bounds if they were one double tighter, as
 * the OUT_ bits say. A step from 0 is too small for the bits. */
static bool near_and_far_are_tight(const struct fitted *f)
{
	struct scene near = f->s, far = f->s;

	near.projection.near = nextafter(near.projection.near, HUGE_VAL);
	far.projection.far = nextafter(far.projection.far, -HUGE_VAL);
	if (!(near.projection.near < far.projection.far) ||
	    !is_filled(f, 4, far.projection.far - near.projection.near))
		return true;
	return (f->s.projection.near == 0 || out_bits(&near, f) & OUT_NEAR) &&
	    (f->s.projection.far == 0 || out_bits(&far, f) & OUT_FAR);
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

/* Samples points at random, on a lattice, on a line, or on a plane of the world, some
 * of them more than once. Sets *b to the bounds of the points. Returns false if a scene
 * or its points have none. */
static bool sample_cloud(const struct scene *s, bool has_eye, int e, struct fitted *f,
    struct bounds *b)
{
	struct cloud *c = &f->cloud;
	unsigned kind = sample_below(5);
	struct directions d;
	struct extremes extremes = { 0 };
	const double *const in[3] = { c->in[0], c->in[1], c->in[2] };
	double along[3] = { 1, sample_number(1), sample_number(1) };

	c->n = 2 + sample_below(19);
	for (size_t n = 0; n < 32; n++) {
		double t = sample_number(e > 0 ? e : 1);
		size_t as = n > 1 ? sample_below(2) : 0;

		for (int i = 0; i < 3; i++)
			c->in[i][n] = n >= c->n || (n > 0 && kind == 4) ? c->in[i][as] :
			    kind == 1           ? sample_below(4) :
			    kind == 2           ? t * along[i] :
			    kind == 3 && i == 2 ? along[1] :
						  sample_number(e > 0 ? e : 1);
	}
	if (!fit_directions(s, has_eye, &d, NULL))
		return false;
	extremes_add(&extremes, &d, in, c->n);
	return extremes_bounds(&extremes, &d, b);
}

/* Samples a K or P whose principal point is inside the picture. */
static void sample_calibrated(struct scene *s)
{
	struct projection *p = &s->projection;
	struct viewport *v = &s->viewport;
	double(*k)[4] = p->section.intrinsics;

	*v = (struct viewport){ .width = 640, .height = 480, .max_z = 1 };
	s->has_viewport = true;
	p->section.is_sized = false;
	p->section.width = v->width;
	p->section.height = v->height;
	memset(k, 0, sizeof p->section.intrinsics);
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
	/* others are refused */
	s->camera.has_axes &= !camera_mirrors(&s->camera, &s->convention);
	s->has_viewport = sample_below(2);
	s->margin = sample_below(2) ? 0 : sample_between(0, 0.49);
	if (p->aspect[1] == 0)
		p->aspect[0] = p->aspect[1] = 1;
	do
		p->type = 1 + sample_below(PROJECTION_TYPES - 1);
	while (projection_family(p) != FAMILY_PERSP &&
	    projection_family(p) != FAMILY_PARALLEL);
	bool persp = projection_family(p) == FAMILY_PERSP;

	p->section.way = sample_below(persp ? SECTION_WAYS : SECTION_ANGLES);
	p->section.edges_at = sample_below(2) ? 0 : sample_size(1);
	if (!persp)
		p->aspect[1] = sample_below(2) ? p->aspect[1] : 0;
	if (p->section.way < SECTION_FIELD && !(p->section.angle < 180))
		p->section.angle = 60;
	p->near_ratio = sample_below(2) ? 0.0005 : sample_between(0, 0.5);
	p->min_near = sample_below(3) ? 0 : sample_size(1);
	p->section.left = -sample_size(1);
	p->section.right = sample_size(1);
	p->section.bottom = sample_size(1);
	p->section.top = -p->section.bottom;
	p->near = sample_size(1);
	p->shear.projector_angle = sample_between(20, 90);
	if (p->section.way == SECTION_ANGLES) {
		p->unit = ANGLE_DEGREES;
		for (int i = 0; i < 4; i++)
			p->section.angles[i] = i % 2 ? sample_between(10, 60) :
						       sample_between(-60, -10);
	}
	if (p->section.way == SECTION_INTRINSICS)
		sample_calibrated(s);
	sample_remember(p);
}

/* Fits n scenes, without those that fit refuses. Returns the number of fitted scenes,
 * each of which passes every check. */
static int fit_many(int n, int e, bool points)
{
	int fitted = 0;

	SAMPLES(i, n) {
		struct bounds b;
		struct fitted f = { .b = &b };
		const struct projection *p = &f.s.projection;
		int mark = real_mark();
		bool has_eye = sample_below(2);

		sample_fit(&f.s, e);
		if (points && sample_below(4) == 0) {
			f.s.projection.type = PROJECTION_PERSP;
			f.s.projection.section.way = SECTION_INTRINSICS;
			f.s.margin = 0;
			sample_calibrated(&f.s);
		}
		if (!points)
			sample_bounds(&b, e);
		else if (!sample_cloud(&f.s, has_eye, e, &f, &b))
			continue;
		if (!fit_scene(&f.s, has_eye, &b, NULL))
			continue;
		/* the full picture is fitted */
		f.s.viewport.has_full = f.s.viewport.has_offset = false;
		measure_gaps(&f);
		assert_true(contains_bounds(&f));
		assert_int_equal(out_bits(&f.s, &f), 0);
		assert_true(depth_tight(&f));
		bool persp = projection_family(p) == FAMILY_PERSP;

		if (persp && points && !has_eye)
			assert_true(is_balanced(&f));
		else if (persp)
			assert_true(eye_is_tight(&f));
		else
			assert_true(is_centered(&f) && sides_are_tight(&f));
		assert_true(near_and_far_are_tight(&f));
		real_release(mark);
		fitted++;
	}
	return fitted;
}

static void test_ordinary(void **state)
{
	(void)state;
	assert_in_range(fit_many(300, 0, false), 225, 300);
}

static void test_mixed(void **state)
{
	(void)state;
	assert_in_range(fit_many(250, 4, false), 150, 250);
}

static void test_points(void **state)
{
	(void)state;
	assert_in_range(fit_many(300, 0, true), 150, 300);
	assert_in_range(fit_many(200, 4, true), 80, 200);
}

/* The points farthest along fit_directions make the same scene as all points. */
static void test_farthest(void **state)
{
	int fitted = 0;

	(void)state;
	SAMPLES(i, 1500) {
		struct bounds b, all = { 0 };
		struct fitted f = { .b = &b };
		struct scene s;
		bool has_eye = sample_below(2), volume = sample_below(3) == 0;

		sample_fit(&f.s, 1);
		while (volume && projection_family(&f.s.projection) != FAMILY_VOLUME)
			sample_scene(&f.s, 1);
		if (!sample_cloud(&f.s, has_eye, 1, &f, &b) ||
		    f.cloud.n > BOUNDS_POINTS)
			continue;
		s = f.s;
		all.n = (int)f.cloud.n;
		for (int k = 0; k < 3 * all.n; k++)
			all.point[k / 3][k % 3] = f.cloud.in[k % 3][k / 3];

		const struct projection *p = &f.s.projection, *q = &s.projection;
		bool is = fit_scene(&f.s, has_eye, &b, &faults);

		assert_int_equal(fit_scene(&s, has_eye, &all, &faults_of_all), is);
		if (!is) {
			const struct refusal *r = &faults_of_all.list[0];

			assert_refusal(is, &faults, r->where, r->what, r->remedy);
			assert_int_equal(faults_of_all.n, 1);
			faults_of_all.n = 0;
			continue;
		}
		for (int k = 0; k < 3; k++)
			assert_number(f.s.camera.eye[k], s.camera.eye[k]);
		assert_number(p->near, q->near);
		assert_number(p->far, q->far);
		assert_number(p->section.width, q->section.width);
		assert_number(p->section.height, q->section.height);
		assert_number(p->volume.z_near, q->volume.z_near);
		assert_number(p->volume.z_far, q->volume.z_far);
		fitted++;
	}
	assert_in_range(fitted, 300, 1500);
}

/* Each type of projection can be fitted, or is refused as one that has no
 * parameters. */
static void every_type_is_fitted_or_refused(void **state)
{
	(void)state;
	for (int type = 0; type < PROJECTION_TYPES; type++) {
		const struct bounds ball = { .sphere = 1, .radius = 1 };
		bool fits = false;

		SAMPLES(i, 100) {
			struct scene s;

			sample_scene(&s, 0);
			s.projection.type = (enum projection_type)type;
			if (fits)
				continue;
			faults.n = 0;
			fits = fit_scene(&s, false, &ball, &faults);
			if (fits)
				assert_true(scene_is_valid(&s));
		}
		/* assert_refusal prints the reason of a type that is never fitted */
		if (!fits)
			assert_refusal(fits, &faults, "/projection/type", NULL, NULL);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ordinary),
		cmocka_unit_test(test_mixed),
		cmocka_unit_test(test_points),
		cmocka_unit_test(test_farthest),
		cmocka_unit_test(every_type_is_fitted_or_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
