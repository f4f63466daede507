/* SPDX-License-Identifier: MIT */
/* Windows, devices and viewports against MPFR. */
#include "claims.h"

static struct refusals faults;

static void check_windows(const char *what, int e, int tries)
{
	struct worst one = { 0 }, two = { 0 };

	SAMPLES(i, tries) {
		struct scene s = { .has_device = true };
		enum space from = FLAT_WINDOW + sample_below(3),
			   to = FLAT_WINDOW + sample_below(3);
		bool both = from != to && from != FLAT_NDC && to != FLAT_NDC;
		struct map m;
		struct truth t;
		int mark = real_mark();

		sample_flat(&s.window, &s.device, e);
		if (scene_map(&s, from, to, &m, NULL)) {
			truth_flat(&s, from, to, &t);
			truth_compare(&t, &m, both ? &two : &one);
		}
		real_release(mark);
	}
	assert_maps(what, &one);
	assert_maps("window to device and back", &two);
}

static void random_windows(void **state)
{
	(void)state;
	check_windows("windows and devices", 0, 1000);
	check_windows("hostile, to 1e2", 2, 1000);
	check_windows("hostile, to 1e70", 70, 500);
}

static void check_viewports(const char *what, int e, int tries)
{
	struct worst w = { 0 };

	SAMPLES(i, tries) {
		struct scene s = { .has_viewport = true };
		bool back = sample_below(2);
		struct map m;
		struct truth t;
		int mark = real_mark();

		sample_convention(&s.convention);
		sample_viewport(&s.viewport, e);
		if (viewport_map(&s.viewport, &s.convention, back, &m, NULL)) {
			truth_scene(&s, back ? SPACE_DEVICE : SPACE_NDC,
			    back ? SPACE_NDC : SPACE_DEVICE, &t);
			truth_compare(&t, &m, &w);
		}
		real_release(mark);
	}
	assert_maps(what, &w);
}

static void random_viewports(void **state)
{
	(void)state;
	check_viewports("viewports", 0, 1000);
	check_viewports("hostile, to 1e2", 2, 1000);
	check_viewports("hostile, to 1e150", 150, 1000);
}

/* Asserts which part of the x axis the window shows: its centre and half its width. */
static void check_shown(const struct window *w, const struct device *d, double center,
    double half)
{
	struct map m;

	assert_true(window_map(w, d, false, &m, NULL));
	assert_number(element(&m, 0, 0), 1 / half);
	assert_number(m.origin[0], center);
	assert_number(element(&m, 3, 0), -center / half);
}

static void window_members(void **state)
{
	struct window w = { .center = { 8, 0 }, .width = 4, .height = 4, .zoom = 1 };
	struct device d = { .width = 200, .height = 100 };

	(void)state;
	check_shown(&w, NULL, 8, 2);
	w.zoom = 2;
	check_shown(&w, NULL, 8, 1);
	w.pan[0] = 2;
	check_shown(&w, NULL, 10, 1);
	w.has_about = true;
	check_shown(&w, NULL, 5, 1);
	w.adapt = ADAPT_GROW;
	check_shown(&w, &d, 5, 2);
	w.adapt = ADAPT_SHRINK;
	check_shown(&w, &d, 5, 1);
	d.height = 400;
	check_shown(&w, &d, 5, 0.5);
	w.adapt = ADAPT_GROW;
	check_shown(&w, &d, 5, 1);
}

static void assert_limits(const struct viewport *v, double x, double y)
{
	double half[2], scale[2];

	viewport_limits(v, half, scale);
	assert_number(half[0] / scale[0], x);
	assert_number(half[1] / scale[1], y);
}

/* In ndc the limits of the viewport are less than 1 on a side that a uniform scale
 * cuts. */
static void limits_of_viewports(void **state)
{
	struct viewport v = { .width = 640, .height = 480 };

	(void)state;
	assert_limits(&v, 1, 1);
	v.scale = SCALE_UNIFORM;
	assert_limits(&v, 1, 0.75);
	v.scale = SCALE_GIVEN;
	v.scales[0] = 960;
	v.scales[1] = 120;
	assert_limits(&v, 1.0 / 3, 2);
}

static void refusals(void **state)
{
	struct window w = { .by_edges = true,
		.left = 1,
		.right = 1,
		.bottom = 0,
		.top = 1,
		.zoom = 1 };
	struct viewport v = { .width = 1, .height = 1 };
	const struct convention d3d = { 0 };
	struct map m;

	(void)state;
	assert_refusal(window_map(&w, NULL, false, &m, &faults), &faults,
	    "/window/right", NULL, NULL);
	w.right = 2;
	w.top = 0;
	assert_refusal(window_map(&w, NULL, true, &m, &faults), &faults, "/window/top",
	    NULL, NULL);
	w.top = 1;
	w.adapt = ADAPT_GROW;
	assert_refusal(window_map(&w, NULL, false, &m, &faults), &faults,
	    "/window/adapt", NULL, NULL);
	w.adapt = ADAPT_STRETCH;
	assert_true(viewport_map(&v, &d3d, false, &m, NULL));
	assert_refusal(viewport_map(&v, &d3d, true, &m, &faults), &faults,
	    "/viewport/max_z", NULL, NULL);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(random_windows),
		cmocka_unit_test(random_viewports),
		cmocka_unit_test(window_members),
		cmocka_unit_test(limits_of_viewports),
		cmocka_unit_test(refusals),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
