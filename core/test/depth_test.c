/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "../derive/depth.h"
#include "sample.h"
#include "../derive/taxonomy.h"
#include "truth.h"

static const double most[BUFFERS] = { 65535, 16777215, 0 };

/* The projector through the middle of the device, from one plane towards the
 * other, and what the device makes of it. */
struct projector {
	real from[3], along[3]; /* unit distance along the gaze */
	real m[4][4];           /* view to device */
	double z;               /* of the device, where it begins */
};

static double stored(real z, enum buffer b)
{
	if (b == BUFFER_FLOAT32)
		return (double)mpfr_get_flt(z, MPFR_RNDN);
	real whole = mul(z, number(most[b]));

	mpfr_roundeven(whole, whole);
	return fmin(fmax(mpfr_get_d(whole, MPFR_RNDN), 0), most[b]);
}

static double stored_at(const struct projector *p, double distance,
    enum buffer b)
{
	int mark = real_mark();
	real z = p->m[3][2], w = p->m[3][3];

	for (int i = 0; i < 3; i++) {
		real x = add(p->from[i], mul(p->along[i], number(distance)));

		z = add(z, mul(x, p->m[i][2]));
		w = add(w, mul(x, p->m[i][3]));
	}
	double value = stored(over(z, w), b);

	real_release(mark);
	return value;
}

/* Under the inverse, ndc z = a of x = y = 0; false where it is not seen. */
static bool place(real inverse[4][4], double a, real h[4])
{
	real size = magnitude(inverse[3][3]);

	for (int j = 0; j < 4; j++)
		h[j] = add(mul(number(a), inverse[2][j]), inverse[3][j]);
	return mpfr_sgn(h[3]) > 0 && !is_zero(h[3], size);
}

/* Plane 0 is near, 1 far. False where it lies at infinity or behind. */
static bool projector_of(const struct scene *s, const struct taxonomy *t,
    int plane, struct projector *p)
{
	bool minus_one = truth_answer(s)->minus_one;
	double low = minus_one ? -1 : 0;
	bool deep = plane == 1 ? !t->reversed : t->reversed;
	real inverse[4][4], a[4], b[4], normal[3];
	bool parallel = t->taxon <= TAXON_OBLIQUE;

	truth_matrix(s, SPACE_CLIP, SPACE_VIEW, inverse);
	truth_matrix(s, SPACE_VIEW, SPACE_CLIP, p->m);
	for (int i = 0; i < 3; i++)
		normal[i] = p->m[i][parallel ? 2 : 3];
	truth_matrix(s, SPACE_VIEW, SPACE_DEVICE, p->m);
	place(inverse, deep ? low : 1, b);
	if (!place(inverse, deep ? 1 : low, a))
		return false;
	for (int i = 0; i < 3; i++) {
		p->from[i] = over(a[i], a[3]);
		p->along[i] = sub(mul(b[i], a[3]), mul(a[i], b[3]));
	}
	normalise(normal, 3);
	real height = magnitude(dot(p->along, normal, 3));

	if (mpfr_zero_p(height))
		return false;
	for (int i = 0; i < 3; i++)
		p->along[i] = over(p->along[i], height);
	p->z = deep ? s->viewport.max_z : s->viewport.min_z;
	return true;
}

/* The least double distance at which something else is stored, found by
 * halving its bits. */
static double search(const struct projector *p, enum buffer b, double end)
{
	double first = stored(number(p->z), b);
	uint64_t low = 0, high;

	memcpy(&high, &end, sizeof high);
	while (high - low > 1) {
		uint64_t middle = low + (high - low) / 2;
		double d;

		memcpy(&d, &middle, sizeof d);
		if (stored_at(p, d, b) == first)
			low = middle;
		else
			high = middle;
	}
	memcpy(&end, &high, sizeof end);
	return end;
}

/* What was rounded to nearest lies at the first such distance or just before
 * it. */
static void steps_are_the_first(void **state)
{
	int found = 0, none = 0;
	struct scene s;
	struct taxonomy t;

	(void)state;
	sample_seed(32);
	for (int k = 0; k < 250; k++) {
		double step[BUFFERS][2];

		sample_scene(&s, k % 5 == 0 ? 2 : 0);
		sample_answer(&s);
		if (taxonomy_of(&s, &t) != NULL)
			continue;
		depth_steps(&s, t.reversed, step);
		for (int i = 0; i < 6; i++) {
			double d = step[i / 2][i % 2], least;
			enum buffer b = (enum buffer)(i / 2);
			int mark = real_mark();
			struct projector p;

			if (!projector_of(&s, &t, i % 2, &p) || isnan(d)) {
				assert_true(isnan(d) != 0);
				none++;
				real_release(mark);
				continue;
			}
			double next = nextafter(d, HUGE_VAL);

			least = search(&p, b, nextafter(next, HUGE_VAL));
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
		.extent = EXTENT_SIZE,
		.width = 1,
		.height = 1,
		.near = near,
		.far = far };
	s.viewport = (struct viewport){ .width = 1, .height = 1, .max_z = 1 };
	return s;
}

static void depth_without_end(void **state)
{
	struct scene s = near_and_far(1, HUGE_VAL);
	double step[BUFFERS][2];

	(void)state;
	/* depth = 1 - 1 / z is 1/131070 at 131070/131069 */
	depth_steps(&s, false, step);
	assert_true(step[BUFFER_UNORM16][0] == 1.0 / 131069);
	assert_true(step[BUFFER_FLOAT32][0] == 0x1p-150);
	for (int b = 0; b < BUFFERS; b++)
		assert_true(isnan(step[b][1]) != 0);
	/* reversed, 1 / z is 1 - 2^-25 at 1 / (1 - 2^-25) */
	s.projection.reverse_z = true;
	depth_steps(&s, true, step);
	assert_true(step[BUFFER_FLOAT32][0] == 1.0 / 0x1.ffffffp24);
}

static void what_is_stored_alike_has_no_step(void **state)
{
	struct scene s = near_and_far(1, 2);
	double step[BUFFERS][2];

	(void)state;
	s.viewport.min_z = 1;
	depth_steps(&s, false, step);
	for (int i = 0; i < 6; i++)
		assert_true(isnan(step[i / 2][i % 2]) != 0);
	/* 32767.5 is stored as 32768 */
	s.viewport.min_z = 0.5;
	s.viewport.max_z = 0.5 - 0x1p-22;
	depth_steps(&s, false, step);
	assert_true(step[BUFFER_UNORM16][0] == 0);
	assert_true(step[BUFFER_FLOAT32][1] > 0);
	s.viewport.min_z = 0.25;
	s.viewport.max_z = 0.25 + 0x1p-22;
	depth_steps(&s, false, step);
	assert_true(isnan(step[BUFFER_UNORM16][0]) != 0);
	assert_true(isnan(step[BUFFER_UNORM16][1]) != 0);
	/* a float that is infinite, and integers that are clamped */
	s.viewport.min_z = -1e39;
	s.viewport.max_z = -1;
	depth_steps(&s, false, step);
	assert_true(isnan(step[BUFFER_UNORM24][0]) != 0);
	assert_true(step[BUFFER_FLOAT32][0] > 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(steps_are_the_first),
		cmocka_unit_test(depth_without_end),
		cmocka_unit_test(what_is_stored_alike_has_no_step),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
