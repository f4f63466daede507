/* SPDX-License-Identifier: MIT */
/* The window that fit finds holds its bounds, and no smaller double for a side does,
 * by MPFR and by the OUT_ bits. */
#include "../derive/fit.h"

#include "../derive/frustum.h"
#include "claims.h"

static struct refusals faults;

static double nearest_double(real a)
{
	return mpfr_get_d(a, MPFR_RNDN);
}

static void range_of(const struct bounds *b, int axis, real *low, real *high)
{
	real c = real_of(b->center[axis]), r = real_of(b->radius);

	*low = b->sphere ? sub(c, r) : real_of(b->min[axis]);
	*high = b->sphere ? add(c, r) : real_of(b->max[axis]);
}

/* Returns the least side for a center and the bounds low and high: twice the larger
 * distance from the center, over 1 less both margins. */
static double least_side(real low, real high, double center, double margin)
{
	real below = sub(real_of(center), low), above = sub(high, real_of(center));
	real most = mpfr_greater_p(below, above) ? below : above;
	real room = sub(real_of(1), real_of(2 * margin));

	return mpfr_get_d(divide(mul(real_of(2), most), room), MPFR_RNDU);
}

static void expected_window(const struct scene *s, const struct bounds *b,
    struct window *w)
{
	double *const side[2] = { &w->width, &w->height };
	real low[2], high[2], extent[2];

	for (int i = 0; i < 2; i++) {
		range_of(b, i, &low[i], &high[i]);
		extent[i] = sub(high[i], low[i]);
	}
	for (int i = 0; i < 2; i++) {
		real half = mul(extent[1 - i], real_of(0x1p-21));

		if (mpfr_zero_p(extent[i])) {
			low[i] = sub(low[i], half);
			high[i] = add(high[i], half);
		}
		w->center[i] = nearest_double(divide(add(low[i], high[i]), real_of(2)));
		*side[i] = least_side(low[i], high[i], w->center[i], s->margin);
	}
	if (!s->has_device)
		return;
	real shape = divide(real_of(s->device.width), real_of(s->device.height));
	double wide = nearest_double(mul(real_of(w->height), shape));
	double high_enough = nearest_double(divide(real_of(w->width), shape));

	if (wide > w->width)
		w->width = wide;
	else
		w->height = fmax(w->height, high_enough);
}

static void sample_bounds(struct bounds *b, int e)
{
	*b = (struct bounds){ .sphere = sample_below(3) == 0,
		.radius = sample_size(e) };
	for (int i = 0; i < 2; i++) {
		double a = sample_number(e), c = sample_number(e);

		if (sample_below(4) == 0)
			c = a;
		if (sample_below(4) == 0) /* bounds of a few units in the last place */
			c = a * (1 + sample_below(9) * 0x1p-50);
		b->center[i] = a;
		b->min[i] = fmin(a, c);
		b->max[i] = fmax(a, c);
	}
}

static bool window_holds(const struct scene *s, const struct bounds *b)
{
	struct frustum f;
	unsigned out = 0;

	assert_true(frustum_of(s, FLAT_WINDOW, false, &f, NULL));
	for (int k = 0; k < 4 && !b->sphere; k++)
		out |= frustum_outside(&f,
		    (double[4]){ k & 1 ? b->max[0] : b->min[0],
			k & 2 ? b->max[1] : b->min[1] });
	return out == 0;
}

/* Returns whether the window holds the bounds with the side along axis one double
 * smaller. */
static bool smaller_window_holds(const struct scene *s, const struct bounds *b,
    int axis)
{
	struct scene less = *s;
	double *side = axis == 0 ? &less.window.width : &less.window.height;

	*side = nextafter(*side, 0);
	return window_holds(&less, b);
}

static bool is_flat(const struct bounds *b)
{
	return b->min[0] == b->max[0] || b->min[1] == b->max[1];
}

static void fit_many(int e, int n)
{
	int fitted = 0, tight = 0;

	SAMPLES(i, n) {
		struct scene s = { .has_device = sample_below(2),
			.margin = sample_below(2) ? 0 : sample_between(0, 0.49) };
		struct window want;
		struct bounds b;
		int mark = real_mark();

		sample_flat(&s.window, &s.device, e);
		sample_bounds(&b, e);
		if (fit_window(&s, &b, NULL)) {
			const struct window *w = &s.window;

			expected_window(&s, &b, &want);
			assert_number(w->center[0], want.center[0]);
			assert_number(w->center[1], want.center[1]);
			assert_number(w->width, want.width);
			assert_number(w->height, want.height);
			assert_true(!w->by_edges && w->zoom == 1);
			assert_true(s.has_window && window_holds(&s, &b));
			if (!b.sphere && s.margin == 0 && !is_flat(&b)) {
				bool less[2] = { smaller_window_holds(&s, &b, 0),
					smaller_window_holds(&s, &b, 1) };

				assert_false(less[0] && less[1]);
				assert_true(s.has_device || !less[0]);
				assert_true(s.has_device || !less[1]);
				tight++;
			}
			fitted++;
		}
		real_release(mark);
	}
	print_message("to 1e%d: %d fitted, %d tight by the flags\n", e, fitted, tight);
	assert_true(fitted > n / 2 && tight > n / 10);
}

static void windows_are_the_least(void **state)
{
	(void)state;
	fit_many(1, 1000);
	fit_many(20, 1000);
	fit_many(149, 500);
}

/* One end is so small beside the other that their middle is rounded. The exact side is
 * slightly more than a double, and is rounded up. */
static void sides_are_rounded_up(void **state)
{
	struct scene s = { 0 };
	struct bounds b = { .min = { -0x1p-1074, 0 }, .max = { 1e149, 1 } };

	(void)state;
	assert_true(fit_window(&s, &b, NULL));
	assert_number(s.window.center[0], 5e148);
	assert_number(s.window.width, nextafter(1e149, HUGE_VAL));
	b.min[0] = 0;
	assert_true(fit_window(&s, &b, NULL));
	assert_number(s.window.width, 1e149);
}

static void assert_refused_as(const struct bounds *b, const char *where)
{
	struct scene s = { 0 };

	assert_refusal(fit_window(&s, b, &faults), &faults, where, NULL, NULL);
}

static void refusals(void **state)
{
	struct bounds b = { .min = { 1, 2 }, .max = { 1, 2 } };

	(void)state;
	assert_refused_as(&b, "/bounds");
	b.max[1] = 1;
	assert_refused_as(&b, "/bounds/max/1");
	b.max[1] = 2 + 0x1p-51;
	b.max[0] = -1;
	assert_refused_as(&b, "/bounds/max/0");
	b = (struct bounds){ .min = { -1e150, 0 }, .max = { 1e150, 1 } };
	assert_refused_as(&b, "/bounds");
	b = (struct bounds){ .min = { 0, -1e150 }, .max = { 1, 1e150 } };
	assert_refused_as(&b, "/bounds");
	b = (struct bounds){ .max = { 1e-151, 1e-151 } };
	assert_refused_as(&b, "/bounds");
	/* fit_window ignores the third coordinate */
	struct scene s = { 0 };

	b = (struct bounds){ .min = { 0, 0, 1 }, .max = { 1, 1, 0 } };
	assert_true(fit_window(&s, &b, NULL));
}

static void check_shown(const struct scene *s, const struct window_extent *w)
{
	struct truth back = { 0 }, out = { 0 };
	enum space to = s->has_device ? FLAT_DEVICE : FLAT_NDC;

	truth_flat(s, FLAT_NDC, FLAT_WINDOW, &back);
	truth_flat(s, FLAT_WINDOW, to, &out);
	for (int k = 0; k < 4; k++) {
		double end = k & 1 ? 1 : -1;
		const double at[4] = { end, end, 0, 1 };

		assert_int_equal(truth_verdict(w->edge[k],
				     truth_column(&back, k / 2, at), sized_of(1),
				     false),
		    NEAREST);
		assert_int_equal(truth_verdict(w->scale[k / 2],
				     truth_element(&out, k / 2, k / 2), sized_of(1),
				     false),
		    NEAREST);
	}
}

static void windows_are_shown(void **state)
{
	static const int e[] = { 0, 2, 70 };
	int shown = 0;

	(void)state;
	SAMPLES(i, 900) {
		struct scene s = { .has_device = sample_below(4) > 0 };
		struct window_extent w;
		int mark = real_mark();

		sample_flat(&s.window, &s.device, e[i % 3]);
		if (scene_window_extent(&s, &w, NULL)) {
			check_shown(&s, &w);
			shown++;
		}
		real_release(mark);
	}
	assert_true(shown > 600);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(windows_are_the_least),
		cmocka_unit_test(sides_are_rounded_up),
		cmocka_unit_test(refusals),
		cmocka_unit_test(windows_are_shown),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
