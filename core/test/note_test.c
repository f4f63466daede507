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

/* A float of k pi / 360 fires, as its double and as it is printed by %.9g; floats
 * beside it do not. */
static void floats_of_pi(void **state)
{
	char text[40];

	(void)state;
	for (int k = 1; k <= 720; k++) {
		const float x = (float)(k * PI / 360);
		const float beside[2] = { nextafterf(x, 0), nextafterf(x, 9) };

		snprintf(text, sizeof text, "%.9g", (double)x);
		assert_true(roll_fires((double)x) && roll_fires(strtod(text, NULL)));
		assert_false(
		    roll_fires((double)beside[0]) || roll_fires((double)beside[1]));
	}
}

/* Four angles from the gaze fire if all are below 1.6 and one has three decimals. */
static void angles_of_sides(void **state)
{
	static const struct {
		double angle[4];
		bool fires;
	} cases[] = { { { -0.77, 0.88, -0.89, 0.91 }, false },
		{ { -0.77, 0.88, -0.891, 0.91 }, true },
		{ { -0.77, 1.5999, -0.89, 0.91 }, true },
		{ { -0.77, 1.6, -0.891, 0.91 }, false },
		{ { -45, 45, -30.125, 30.125 }, false },
		{ { -0.5, 1.5708, -40, 40 }, true } };

	(void)state;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		struct scene s = {
			.projection = { .type = PROJECTION_PERSP, .near = 1, .far = 2 }
		};
		struct written unit = { .angle_unit = true };

		s.projection.section.way = SECTION_ANGLES;
		memcpy(s.projection.section.angles, cases[i].angle,
		    sizeof cases[i].angle);
		assert_int_equal(fires(&s, NOTE_RADIANS), cases[i].fires);
		assert_int_equal(note_of_members(&s, &unit), 0);
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

static double rounded(double x, int decimals)
{
	char text[40];

	snprintf(text, sizeof text, "%.*e", decimals, x);
	return strtod(text, NULL);
}

/* cot(k / 2), k whole, fires as double, as float, over the aspect, and with five digits
 * unless a digit is 0 or it is a cotangent of half of whole degrees, too; cot of half
 * of whole and half degrees does not, over the aspects of common sizes, and of whole
 * degrees with five digits. */
static void cotangents(void **state)
{
	static const double size[][2] = { { 640, 480 }, { 1920, 1080 }, { 1280, 800 },
		{ 1024, 1024 }, { 3840, 1600 }, { 1080, 1920 }, { 1500, 1000 } };

	int missed = 0;

	(void)state;
	assert_true(matrix_fires(1.34443, 1.79257, 800, 600));
	assert_true(matrix_fires(1.34443, 1.79257, 1, 1));
	for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
		const double w = size[i][0], h = size[i][1];

		for (int k = 4; k <= 179; k++) {
			const double cot = 1 / tan(k / 2.0);

			assert_true(matrix_fires(3, cot, w, h));
			assert_true(matrix_fires(3, (double)(float)-cot, w, h));
			assert_true(matrix_fires(cot * h / w, 3, w, h));
			missed += !matrix_fires(3, rounded(cot, 4), w, h) +
			    !matrix_fires(rounded(cot * h / w, 4), 3, w, h);
			assert_false(matrix_fires(3, rounded(cot, 3), w, h));
		}
		for (int k = 1; k < 360; k++) {
			const double cot = 1 / tan(k * PI / 720);

			if (matrix_fires(cot * h / w, cot, w, h))
				fail_msg("cot of %g degrees, %g x %g", k / 2.0, w, h);
			if (k % 2 == 0 &&
			    matrix_fires(rounded(cot * h / w, 4), rounded(cot, 4), w,
				h))
				fail_msg("5 digits of %d degrees", k / 2);
		}
	}
	print_message("%d of 2464 cotangents of five digits have four, or are right\n",
	    missed);
	assert_true(missed < 500);
}

/* A matrix fires if R R' is off by more than 1e-2 or mirrors; as a list of one step,
 * too. */
static void rotations(void **state)
{
	static const double off[] = { 0, 0.0049, 0.0051, -0.0049, -0.0051, 0.5 };

	(void)state;
	for (size_t i = 0; i < sizeof off / sizeof *off; i++)
		for (int mirrored = 0; mirrored < 2; mirrored++)
			for (int listed = 0; listed < 2; listed++) {
				struct scene s = { .has_camera = true };
				struct step step = { .kind = STEP_MATRIX };
				double(*m)[4] = listed ? step.matrix :
							 s.camera.steps.matrix;
				const bool wrong = mirrored || fabs(off[i]) > 0.005;

				s.camera.way = i % 2 ? CAMERA_POSE : CAMERA_MATRIX;
				m[0][0] = m[1][1] = 0.6;
				m[0][1] = 0.8;
				m[1][0] = -0.8 * (1 + off[i]);
				m[0][0] *= 1 + off[i];
				m[2][2] = mirrored ? -1 : 1;
				m[3][0] = 1000;
				m[3][3] = 1;
				s.camera.steps.n = listed;
				s.camera.steps.step = listed ? &step : NULL;
				assert_int_equal(fires(&s, NOTE_ROTATION), wrong);
				s.camera.orthonormalize = true;
				assert_false(fires(&s, NOTE_ROTATION));
			}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(parts_of_pi),
		cmocka_unit_test(floats_of_pi),
		cmocka_unit_test(angles_of_sides),
		cmocka_unit_test(plain_angles),
		cmocka_unit_test(cotangents),
		cmocka_unit_test(rotations),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
