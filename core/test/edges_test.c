/* SPDX-License-Identifier: MIT */
/* The OUT_ bits of the edges of a 2D window, which frustum_outside returns, agree with
 * the signs that MPFR computes. */
#include "../derive/frustum.h"

#include "claims.h"
#include "block.h"

static struct refusals faults;

/* Samples points on the edges, rounded to doubles of the space from, points at the
 * doubles next to these, and others. */
static void sample_edges(const struct scene *s, enum space from, struct block *b)
{
	struct transform t;
	static struct block image;

	for (size_t i = 0; i < POINTS; i++) {
		for (int j = 0; j < 2; j++)
			image.in[j][i] = sample_between(-1.5, 1.5);
		image.in[sample_below(2)][i] = sample_below(2) ? 1 : -1;
	}
	assert_true(transform_of_scene(s, FLAT_NDC, from, false, &t, NULL));
	map_block_exactly(&t, &image, POINTS);
	for (size_t i = 0; i < POINTS; i++)
		for (int j = 0; j < 2; j++) {
			double on = image.out[j][i];
			unsigned beside = sample_below(8);

			b->in[j][i] = beside == 0 ? nextafter(on, 1e300) :
			    beside == 1           ? nextafter(on, -1e300) :
			    beside == 2           ? sample_number(4) :
						    on;
		}
	if (sample_below(2))
		b->in[sample_below(2)][sample_below(POINTS)] = (double)NAN;
}

struct count {
	size_t edges, on;
};

/* Compares the OUT_ bits of a point with the signs of 1 + x, 1 - x, 1 + y and 1 - y in
 * ndc. No sign is negative inside. */
static void check_edges(const struct truth *to_ndc, const double p[2], unsigned out,
    struct count *c)
{
	const double at[4] = { p[0], p[1], 0, 1 };

	for (int k = 0; k < 4; k++) {
		struct sized one = sized_of(1);
		struct sized x = truth_column(to_ndc, k / 2, at);
		int sign = truth_sign(k & 1 ? sized_sub(one, x) : sized_add(one, x),
		    NULL);

		assert_int_equal(out >> k & 1, sign < 0);
		c->edges++;
		c->on += sign == 0;
	}
	assert_int_equal(out >> 4, 0);
}

static void check_block(const struct scene *s, enum space from, const struct frustum *f,
    const struct block *b, struct count *c)
{
	/* frustum_outside_all ignores the third coordinate */
	static double nans[POINTS_BLOCK];
	unsigned char all[POINTS];
	struct truth t;

	for (size_t i = 0; i < POINTS; i++)
		nans[i] = (double)NAN;
	truth_flat(s, from, FLAT_NDC, &t);
	frustum_outside_all(f, (const double *[4]){ b->in[0], b->in[1], nans }, all,
	    POINTS);
	for (size_t i = 0; i < POINTS; i++) {
		const double p[4] = { b->in[0][i], b->in[1][i], (double)NAN };
		int mark = real_mark();

		assert_int_equal(all[i], frustum_outside(f, p));
		if (isnan(p[0]) || isnan(p[1]))
			assert_int_equal(all[i], OUT_NAN);
		else
			check_edges(&t, p, all[i], c);
		real_release(mark);
	}
}

static void edges_agree_with_mpfr(void **state)
{
	static const int e[] = { 0, 0, 2, 70 };
	static struct frustum f;
	static struct block b;
	struct count c = { 0 };

	(void)state;
	SAMPLES(k, 600) {
		struct scene s = { .has_device = true, .has_window = true };
		enum space from = FLAT_WINDOW + sample_below(3);
		int mark = real_mark();

		/* the last choice stays if the processor lacks this one */
		kernels_choose(copies[k % COPIES]);
		sample_flat(&s.window, &s.device, e[k % 4]);
		if (frustum_of(&s, from, false, &f, NULL)) {
			sample_edges(&s, from, &b);
			check_block(&s, from, &f, &b, &c);
		}
		real_release(mark);
	}
	print_message("%zu edges, on %zu of them the point\n", c.edges, c.on);
	assert_true(c.edges > 40000 && c.on > 5000);
}

static unsigned out_at(const struct frustum *f, double x, double y)
{
	return frustum_outside(f, (double[4]){ x, y });
}

/* The doubles next to an edge are outside, however small the window is, and however
 * far it is from the origin. */
static void tiny_windows_are_exact(void **state)
{
	struct scene s = { .window = { .center = { 1e150, -1e150 },
			       .width = 1e-150,
			       .height = 1e134,
			       .zoom = 1 } };
	struct frustum f;
	double right = nextafter(1e150, HUGE_VAL);
	double left = nextafter(1e150, 0);

	(void)state;
	assert_true(frustum_of(&s, FLAT_WINDOW, false, &f, NULL));
	assert_int_equal(out_at(&f, 1e150, -1e150), 0);
	assert_int_equal(out_at(&f, right, -1e150), OUT_RIGHT);
	assert_int_equal(out_at(&f, left, -1e150), OUT_LEFT);
	/* at 1e150 doubles are 1.8e134 apart, more than half the height */
	assert_int_equal(out_at(&f, 1e150, -right), OUT_BOTTOM);
	assert_int_equal(out_at(&f, 1e150, -left), OUT_TOP);
}

/* OUT_TOP is above the window, in devices with the origin at the top and at the
 * bottom. */
static void top_is_up(void **state)
{
	struct scene s = { .window = { .width = 4, .height = 2, .zoom = 1 },
		.has_device = true,
		.device = { .width = 40, .height = 20, .top_left = true } };
	struct frustum f;

	(void)state;
	assert_true(frustum_of(&s, FLAT_DEVICE, false, &f, NULL));
	assert_int_equal(out_at(&f, 0, 0), 0);
	assert_int_equal(out_at(&f, 40, 20), 0);
	assert_int_equal(out_at(&f, 20, -0x1p-1074), OUT_TOP);
	assert_int_equal(out_at(&f, 41, 21), OUT_RIGHT | OUT_BOTTOM);
	s.device.top_left = false;
	assert_true(frustum_of(&s, FLAT_DEVICE, false, &f, NULL));
	assert_int_equal(out_at(&f, -1, 21), OUT_LEFT | OUT_TOP);
}

static void refusals(void **state)
{
	struct scene s = { .window = { .by_edges = true, .top = 1 } };
	struct frustum f;

	(void)state;
	assert_refusal(frustum_of(&s, FLAT_WINDOW, false, &f, &faults), &faults,
	    "/window/right", NULL, NULL);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(edges_agree_with_mpfr),
		cmocka_unit_test(tiny_windows_are_exact),
		cmocka_unit_test(top_is_up),
		cmocka_unit_test(refusals),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
