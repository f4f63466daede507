/* SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "../derive/picture.h"
#include "claims.h"

static const double most[DEPTH_BUFFERS] = { 65535, 16777215, 0 };

/* The normal of the projection plane from the near or far plane toward the other plane,
 * and the device depth along it. In a perspective the normal goes through the eye. */
struct projector {
	real from[3], along[3]; /* the start on the plane, and a unit vector */
	real m[4][4];           /* from view to device space */
	double z;               /* device depth of the plane */
	bool up;                /* device depth grows along the normal */
};

/* Returns the depth that is one step of the buffer above z or, if up is false, below
 * z. */
static real next_step_depth(double z, enum depth_buffer b, bool up)
{
	float f = (float)z;

	if (b < DEPTH_FLOAT32)
		return add(real_of(z), divide(real_of(up ? 1 : -1), real_of(most[b])));
	if (isinf(f) || (up ? (double)f <= z : (double)f >= z))
		f = nextafterf(f, up ? HUGE_VALF : -HUGE_VALF);
	return real_of((double)f);
}

/* Returns whether the depth at a distance from the plane is at or beyond the next step
 * of the buffer. */
static bool reaches_step(const struct projector *p, double distance,
    enum depth_buffer b)
{
	int mark = real_mark();
	real z = p->m[3][2], w = p->m[3][3];

	for (int i = 0; i < 3; i++) {
		real x = add(p->from[i], mul(p->along[i], real_of(distance)));

		z = add(z, mul(x, p->m[i][2]));
		w = add(w, mul(x, p->m[i][3]));
	}
	real off = sub(divide(z, w), next_step_depth(p->z, b, p->up));
	bool is = p->up ? mpfr_sgn(off) >= 0 : mpfr_sgn(off) <= 0;

	real_release(mark);
	return is;
}

/* n / d is the distance from the origin of the normal to the point where ndc z is a. d
 * is positive if the point is visible. Let z be clip z at the origin, and slope the
 * gradient of clip z along the normal. In a perspective, where clip w is 0 at the
 * origin, let w be the gradient of clip w: z + slope n / d = a w n / d. In a parallel
 * projection, where w is constant, z + slope n / d = a w. */
struct quotient {
	real n, d;
};

static struct quotient normal_distance(real z, real slope, real w, bool parallel,
    double a)
{
	struct quotient p = { z, sub(mul(real_of(a), w), slope) };

	if (parallel)
		p = (struct quotient){ sub(mul(real_of(a), w), z), slope };
	if (mpfr_sgn(parallel ? p.d : p.n) < 0)
		p = (struct quotient){ sub(real_of(0), p.n), sub(real_of(0), p.d) };
	if (is_zero(p.d, slope))
		p.d = real_of(0);
	return p;
}

/* Sets the normal of the near plane, if plane is 0, or of the far plane. Returns false
 * if the plane is at infinity or behind the eye. */
static bool projector_of(const struct scene *s, const struct picture *t, int plane,
    struct projector *p)
{
	double low = truth_answer(s)->depth_minus_one ? -1 : 0;
	bool deep = plane == 1 ? !t->reverse_z : t->reverse_z;
	bool parallel = t->taxonomy.taxon <= TAXON_OBLIQUE;
	real inverse[4][4], normal[3], gradient[3];

	truth_matrix(s, SPACE_CLIP, SPACE_VIEW, inverse);
	truth_matrix(s, SPACE_VIEW, SPACE_CLIP, p->m);
	real *eye = inverse[parallel ? 3 : 2], z = p->m[3][2];

	for (int i = 0; i < 3; i++) {
		gradient[i] = p->m[i][2];
		normal[i] = p->m[i][parallel ? 2 : 3];
		p->from[i] = divide(eye[i], eye[3]);
		z = add(z, mul(p->from[i], gradient[i]));
	}
	real w = p->m[3][3];

	if (!parallel)
		w = root(dot(normal, normal, 3));
	normalise(normal, 3);
	real slope = dot(gradient, normal, 3);
	struct quotient at = normal_distance(z, slope, w, parallel, deep ? 1 : low);
	struct quotient to = normal_distance(z, slope, w, parallel, deep ? low : 1);

	if (mpfr_sgn(at.d) <= 0 || (parallel && mpfr_sgn(w) <= 0))
		return false;
	int inward = mpfr_sgn(sub(mul(to.n, at.d), mul(at.n, to.d)));

	for (int i = 0; i < 3; i++) {
		p->from[i] = add(p->from[i], mul(normal[i], divide(at.n, at.d)));
		p->along[i] = mul(normal[i], real_of(inward));
	}
	truth_matrix(s, SPACE_VIEW, SPACE_DEVICE, p->m);
	p->z = deep ? s->viewport.max_z : s->viewport.min_z;
	p->up = deep == (s->viewport.max_z < s->viewport.min_z);
	return inward != 0;
}

/* Returns the least double up to end at which the next step is reached, by bisection of
 * the doubles' bits. */
static double first_distance(const struct projector *p, enum depth_buffer b, double end)
{
	uint64_t low = 0, high;

	memcpy(&high, &end, sizeof high);
	while (high - low > 1) {
		uint64_t middle = low + (high - low) / 2;
		double d;

		memcpy(&d, &middle, sizeof d);
		if (reaches_step(p, d, b))
			high = middle;
		else
			low = middle;
	}
	memcpy(&end, &high, sizeof end);
	return end;
}

static double plane_step(const struct scene *s, enum depth_buffer b, bool far)
{
	struct picture p;

	assert_true(picture_of(s, &p, NULL));
	return depth_step(&p.depth, b, far);
}

/* The nearest double to a step's length is the least double at which the next step is
 * reached, or the double before it. */
static void steps_are_nearest(void **state)
{
	int found = 0, none = 0;
	struct scene s;
	struct picture t;

	(void)state;
	SAMPLES(k, 250) {
		sample_scene(&s, k % 5 == 0 ? 2 : 0);
		sample_answer(&s);
		if (!picture_of(&s, &t, NULL))
			continue;
		for (int i = 0; i < 6; i++) {
			enum depth_buffer b = (enum depth_buffer)(i / 2);
			double d = depth_step(&t.depth, b, i % 2), least;
			int mark = real_mark();
			struct projector p;

			if (!projector_of(&s, &t, i % 2, &p) || isnan(d)) {
				assert_true(isnan(d) != 0);
				none++;
				real_release(mark);
				continue;
			}
			double next = nextafter(d, HUGE_VAL);

			least = first_distance(&p, b, nextafter(next, HUGE_VAL));
			assert_true(d == least || next == least);
			found++;
			real_release(mark);
		}
	}
	print_message("%d steps, %d times none\n", found, none);
	assert_true(found > 900 && none > 30);
}

static struct scene near_and_far(double near, double far)
{
	struct scene s = { .has_viewport = true };

	s.projection = (struct projection){ .type = PROJECTION_PERSP,
		.section.way = SECTION_SIZE,
		.section.width = 1,
		.section.height = 1,
		.near = near,
		.far = far };
	s.viewport = (struct viewport){ .width = 1, .height = 1, .max_z = 1 };
	return s;
}

static void infinite_far_has_steps(void **state)
{
	struct scene s = near_and_far(1, HUGE_VAL);
	struct picture p;

	(void)state;
	/* depth 1 - 1/z is 1/65535 at z = 65535/65534 */
	assert_true(picture_of(&s, &p, NULL));
	assert_number(plane_step(&s, DEPTH_UNORM16, false), 1.0 / 65534);
	assert_number(plane_step(&s, DEPTH_FLOAT32, false), 0x1p-149);
	for (enum depth_buffer b = 0; b < DEPTH_BUFFERS; b++)
		assert_true(isnan(plane_step(&s, b, true)) != 0);
	/* steps from depth 1/2 at z = 2 to 1/2 - 1/65535 and 1/2 - 2^-25 */
	assert_number(depth_step_at(&p.depth, DEPTH_UNORM16, 2), 4.0 / 65537);
	assert_number(depth_step_at(&p.depth, DEPTH_FLOAT32, 2),
	    0x1p-23 / (1 + 0x1p-24));
	/* reversed depth 1/z is 1 - 2^-24 at z = 1 / (1 - 2^-24) */
	s.projection.reverse_z = true;
	assert_true(picture_of(&s, &p, NULL));
	assert_number(plane_step(&s, DEPTH_FLOAT32, false), 1 / 0xffffffp0);
	/* 1/3 is between two floats */
	double up = (double)(float)(1.0 / 3), down = (double)nextafterf((float)up, 0);

	assert_true(up > 1.0 / 3);
	assert_number(depth_step_at(&p.depth, DEPTH_FLOAT32, 3),
	    (up - down) / (up * down));
	/* at near the step leads inward, as in plane_step */
	assert_number(depth_step_at(&p.depth, DEPTH_FLOAT32, 1), 1 / 0xffffffp0);
}

static void a_range_below_a_step_has_none(void **state)
{
	struct scene s = near_and_far(1, 2);

	(void)state;
	for (int i = 0; i < 6; i++) {
		enum depth_buffer b = (enum depth_buffer)(i / 2);

		s.viewport.min_z = 1;
		assert_true(isnan(plane_step(&s, b, i % 2)) != 0);
		s.viewport.min_z = 1 - 0x1p-24;
		assert_true(isnan(plane_step(&s, b, i % 2)) == (b != DEPTH_FLOAT32));
		s.viewport.min_z = 1 - 0x1p-23;
		assert_true(isnan(plane_step(&s, b, i % 2)) == (b == DEPTH_UNORM16));
	}
	/* the next float above -1e39 is the least; above 1e38 none is below this */
	s.viewport.min_z = -1e39;
	s.viewport.max_z = -1;
	assert_true(plane_step(&s, DEPTH_FLOAT32, false) > 0);
	s.viewport.min_z = 1e38;
	s.viewport.max_z = nextafter(1e38, 2e38);
	assert_true(isnan(plane_step(&s, DEPTH_FLOAT32, false)) != 0);
	assert_true(isnan(plane_step(&s, DEPTH_FLOAT32, true)) != 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(steps_are_nearest),
		cmocka_unit_test(infinite_far_has_steps),
		cmocka_unit_test(a_range_below_a_step_has_none),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
