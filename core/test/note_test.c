/* SPDX-License-Identifier: MIT */
/* The rules of notes that look at digits: every number that is meant fires, and no
 * number of a plain scene does. The numbers are written by printf. */
#include "../derive/note.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "claims.h"

static const struct written nothing;

static bool fires(const struct scene *s, enum note note)
{
	return (note_of_members(s, &nothing) >> note & 1) != 0;
}

/* Returns whether NOTE_RADIANS fires for a roll. */
static bool roll_fires(double roll)
{
	struct scene s = { .has_camera = true };

	s.camera.up[1] = 1;
	s.camera.roll = roll;
	return fires(&s, NOTE_RADIANS);
}

/* Returns whether NOTE_RADIANS fires for an angle of view. */
static bool view_fires(double fovy)
{
	struct scene s = {
		.projection = { .type = PROJECTION_PERSP, .near = 1, .far = 2 }
	};

	s.projection.section.angle = fovy;
	return fires(&s, NOTE_RADIANS);
}

/* k pi / 360, at 5 to 17 digits and as programs compute it, fires with both signs. With
 * fewer digits none does. */
static void parts_of_pi(void **state)
{
	char text[40];

	(void)state;
	for (int k = 1; k <= 720; k++) {
		const double x = k * PI / 360;

		assert_true(roll_fires(x));
		assert_true(roll_fires(k / 2.0 * (PI / 180)));
		for (int digits = 2; digits <= 17; digits++) {
			snprintf(text, sizeof text, "%.*e", digits - 1, x);
			const double v = strtod(text, NULL);

			snprintf(text, sizeof text, "%.3e", v);
			if (strtod(text, NULL) == v)
				assert_false(roll_fires(v));
			else
				assert_true(roll_fires(-v));
		}
	}
}

/* Twentieths of a degree, and decimals of up to four digits, are degrees; in an angle
 * of view, decimals of up to two places. */
static void plain_angles(void **state)
{
	(void)state;
	for (int i = -7200; i <= 7200; i++)
		assert_false(roll_fires(i / 20.0));
	for (int i = 1; i <= 9999; i++) {
		assert_false(roll_fires(i / 1000.0));
		assert_false(roll_fires(i / 100.0));
		if (i <= 1800)
			assert_false(view_fires(i / 10.0));
		assert_false(view_fires(i / 100.0));
		assert_int_equal(view_fires(i / 1000.0),
		    i % 10 != 0 && i >= 200 && i <= 3200);
	}
}

static bool matrix_fires(double xs, double ys, double width, double height)
{
	struct scene s = { .has_viewport = true,
		.projection = { .type = PROJECTION_MATRIX } };

	s.viewport.width = width;
	s.viewport.height = height;
	s.projection.matrix[0][0] = xs;
	s.projection.matrix[1][1] = ys;
	s.projection.matrix[2][3] = 1;
	return fires(&s, NOTE_MATRIX_RADIANS);
}

/* cot(k / 2), k whole, fires as double, as float, and over the aspect; cot of half of
 * whole and half degrees does not, over the aspects of common sizes. */
static void cotangents(void **state)
{
	static const double size[][2] = { { 640, 480 }, { 1920, 1080 }, { 1280, 800 },
		{ 1024, 1024 }, { 3840, 1600 }, { 1080, 1920 }, { 1500, 1000 } };

	(void)state;
	for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
		const double w = size[i][0], h = size[i][1];

		for (int k = 4; k <= 179; k++) {
			const double cot = 1 / tan(k / 2.0);

			assert_true(matrix_fires(3, cot, w, h));
			assert_true(matrix_fires(3, (double)(float)-cot, w, h));
			assert_true(matrix_fires(cot * h / w, 3, w, h));
		}
		for (int k = 1; k < 360; k++) {
			const double cot = 1 / tan(k * PI / 720);

			if (matrix_fires(cot * h / w, cot, w, h))
				fail_msg("cot of %g degrees, %g x %g", k / 2.0, w, h);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(parts_of_pi),
		cmocka_unit_test(plain_angles),
		cmocka_unit_test(cotangents),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
