/* SPDX-License-Identifier: MIT */

#include "../derive/fit.h"
#include "claims.h"

static struct refusals faults;

static const struct bounds unit_ball = { .sphere = true, .radius = 1 };

static struct bounds box(double x, double y, double z)
{
	return (struct bounds){ .min = { -x, -y, -z }, .max = { x, y, z } };
}

static struct scene persp(double fovy)
{
	return (struct scene){
		.projection = { .type = PROJECTION_PERSP,
		    .section.way = SECTION_FOVY,
		    .section.angle = fovy,
		    .aspect = { 1, 1 },
		    .near_ratio = 0.0005 },
	};
}

static struct scene parallel(unsigned type)
{
	return (struct scene){
		.projection = { .type = type,
		    .section.way = SECTION_SIZE,
		    .shear.kind = OBLIQUE_CAVALIER },
	};
}

static void assert_fits(struct scene *s, bool has_eye, const struct bounds *b, double x,
    double y, double z, double near, double far)
{
	assert_true(fit_scene(s, has_eye, b, NULL));
	assert_int_equal(s->camera.way, CAMERA_GAZE);
	assert_number(s->camera.eye[0], x);
	assert_number(s->camera.eye[1], y);
	assert_number(s->camera.eye[2], z);
	assert_number(s->projection.near, near);
	assert_number(s->projection.far, far);
}

/* Planes at half the angle from the gaze touch the sphere if the eye is r / sin(30
 * degrees) from its center. */
static void test_angle(void **state)
{
	struct bounds b = box(1, 1, 1), world_b = box(2, 2, 2);
	struct scene s = persp(60);

	(void)state;
	assert_fits(&s, false, &unit_ball, 0, 0, -2, 1, 3);
	s = persp(60);
	s.convention.right_handed = s.projection.reverse_z = true;
	assert_fits(&s, false, &unit_ball, 0, 0, 2, 1, 3);
	s = persp(90);
	assert_fits(&s, false, &b, 0, 0, -2, 1, 3);
	s = persp(90);
	s.has_world = true;
	for (int k = 0; k < 4; k++)
		s.world.matrix[k][k] = k < 3 ? 0.5 : 1;
	assert_fits(&s, false, &world_b, 0, 0, -2, 1, 3);
}

/* The eye moves along the gaze through its position, forward or back. */
static void test_eye(void **state)
{
	struct bounds b = box(1, 1, 1);
	struct scene s = persp(90);

	(void)state;
	s.has_camera = true;
	s.camera = (struct camera){ .way = CAMERA_AT,
		.eye = { 3, 0, -100 },
		.at = { 3, 0, 7 },
		.up = { 0, 1, 0 } };
	assert_fits(&s, true, &b, 3, 0, -5, 4, 6);
	assert_number(s.camera.at[2], 107);
}

static void test_near_ratio(void **state)
{
	struct scene s = persp(170);

	(void)state;
	s.projection.near_ratio = 0.25;
	assert_true(fit_scene(&s, false, &unit_ball, NULL));
	/* the eye is 5/3 from the center: 5/3 - 1 = (5/3 + 1) / 4 */
	assert_true(fabs(s.camera.eye[2] + 5.0 / 3) < 0x1p-51);
	assert_true(s.projection.near >= s.projection.far / 4);
	assert_true(s.projection.near <= s.projection.far / 4 + 0x1p-51);
}

/* Sizes on the near plane are scaled with its distance, so the slopes stay. */
static void test_slopes(void **state)
{
	struct bounds b = box(2, 2, 2);
	struct scene s = persp(90);

	(void)state;
	s.projection.section.way = SECTION_SIZE;
	s.projection.near = 4;
	s.projection.section.width = 8;
	s.projection.section.height = 16;
	assert_fits(&s, false, &b, 0, 0, -4, 2, 6);
	assert_number(s.projection.section.width, 4);
	assert_number(s.projection.section.height, 8);
	s.projection.section.way = SECTION_EDGES;
	s.projection.section.left = 2;
	s.projection.section.right = -2;
	s.projection.section.bottom = -1;
	s.projection.section.top = 2;
	assert_fits(&s, false, &b, 0, 0, -6, 4, 8);
	assert_number(s.projection.section.left, 4);
	assert_number(s.projection.section.right, -4);
	assert_number(s.projection.section.bottom, -2);
	assert_number(s.projection.section.top, 4);
}

static void test_ortho(void **state)
{
	struct bounds b = { .min = { 0, 0, 0 }, .max = { 4, 2, 6 } };
	struct scene s = parallel(PROJECTION_ORTHO);

	(void)state;
	assert_fits(&s, false, &b, 2, 1, -3, 3, 9);
	assert_number(s.projection.section.width, 4);
	assert_number(s.projection.section.height, 2);
	s.camera.eye[0] = 9;
	s.camera.eye[2] = 1;
	s.projection.aspect[0] = s.projection.aspect[1] = 1;
	assert_fits(&s, true, &b, 2, 1, 1, -1, 5);
	assert_number(s.projection.section.width, 4);
	assert_number(s.projection.section.height, 4);
	s.projection.section.way = SECTION_EDGES;
	s.projection.section.left = 1;
	assert_fits(&s, false, &b, 2, 1, -3, 3, 9);
	assert_number(s.projection.section.left, 2);
	assert_number(s.projection.section.right, -2);
	assert_number(s.projection.section.bottom, -2);
	assert_number(s.projection.section.top, 2);
}

/* A viewport of 640 x 480 with one scale shows 0.75 of the height. */
static void test_viewport(void **state)
{
	struct bounds b = box(1, 3, 1);
	struct scene s = parallel(PROJECTION_ORTHO);

	(void)state;
	s.has_viewport = true;
	s.viewport = (struct viewport){ .width = 640,
		.height = 480,
		.max_z = 1,
		.scale = SCALE_UNIFORM };
	assert_fits(&s, false, &b, 0, 0, -2, 1, 3);
	assert_number(s.projection.section.width, 2);
	assert_number(s.projection.section.height, 8);
	s = persp(90);
	s.has_viewport = true;
	s.viewport = (struct viewport){ .width = 640,
		.height = 480,
		.max_z = 1,
		.scale = SCALE_UNIFORM };
	assert_fits(&s, false, &b, 0, 0, -5, 4, 6);
}

/* An oblique projection shifts the middle, at depth 2, by 2 or, as cabinet, by 1. */
static void test_oblique(void **state)
{
	struct bounds b = box(1, 1, 1);
	struct scene s = parallel(PROJECTION_OBLIQUE);

	(void)state;
	assert_fits(&s, false, &b, 2, 0, -2, 1, 3);
	assert_number(s.projection.section.width, 4);
	assert_number(s.projection.section.height, 2);
	s = parallel(PROJECTION_OBLIQUE);
	s.convention.right_handed = s.convention.ndc_y_down = true;
	s.projection.shear.kind = OBLIQUE_CABINET;
	s.projection.shear.direction = 90;
	assert_fits(&s, false, &b, 0, 1, 2, 1, 3);
	assert_number(s.projection.section.width, 2);
	assert_number(s.projection.section.height, 3);
}

static void test_flat(void **state)
{
	struct bounds b = box(1, 1, 0), line = box(0, 0, 1);
	struct scene s = parallel(PROJECTION_ORTHO);

	(void)state;
	assert_fits(&s, false, &b, 0, 0, -0x1p-19, 0x1p-20, 3 * 0x1p-20);
	assert_fits(&s, false, &line, 0, 0, -2, 1, 3);
	assert_number(s.projection.section.width, 0x1p-19);
	assert_number(s.projection.section.height, 0x1p-19);
	s = persp(90);
	assert_fits(&s, false, &b, 0, 0, -1, 1 - 0x1p-20, 1 + 0x1p-20);
}

static void assert_gaze(const struct camera *c, double x, double y, double z,
    double up_x, double up_y, double up_z)
{
	assert_true(c->way == CAMERA_GAZE);
	assert_true(c->at[0] == x && c->at[1] == y && c->at[2] == z);
	assert_number(c->up[0], up_x);
	assert_number(c->up[1], up_y);
	assert_number(c->up[2], up_z);
}

static void test_cameras(void **state)
{
	struct scene s = parallel(PROJECTION_ORTHO);

	(void)state;
	s.has_camera = true;
	s.camera = (struct camera){ .way = CAMERA_ORIENTATION,
		.orientation = { 0, 1, 0, 1 },
		.roll = 30 };
	assert_true(fit_scene(&s, false, &unit_ball, NULL));
	assert_gaze(&s.camera, 1, 0, 0, 0, 1, 0);
	assert_number(s.camera.roll, 30);
	s.camera = (struct camera){ .way = CAMERA_MATRIX,
		.steps.matrix = { { 0, 0, 4 }, { 0, 4 }, { -4 }, { 0, 0, 20, 1 } } };
	assert_true(fit_scene(&s, true, &unit_ball, NULL));
	assert_gaze(&s.camera, 1, 0, 0, 0, 1, 0);
	assert_number(s.camera.eye[0], -5);
	assert_number(s.projection.near, 4);
	assert_number(s.projection.section.width, 2);
	s.camera = (struct camera){ .way = CAMERA_AT,
		.eye = { -9e149, 0, 0 },
		.at = { 9e149, 0, 0 },
		.up = { 0, 1, 0 } };
	assert_true(fit_scene(&s, true, &unit_ball, NULL));
	assert_gaze(&s.camera, 9e149, 0, 0, 0, 1, 0);
}

static void assert_refused(struct scene s, const struct bounds *b, const char *where,
    const char *what)
{
	assert_refusal(fit_scene(&s, false, b, &faults), &faults, where, what, NULL);
}

static void test_refusals(void **state)
{
	struct bounds point = box(0, 0, 0), wrong = box(1, -1, 1);
	struct bounds huge = box(1e150, 1e150, 1e150), b = box(1, 1, 1);
	const char *const out_of_range = "the scene that fit computes has numbers "
					 "beyond 1e150 or sizes below 1e-150";
	struct scene s = persp(60);

	(void)state;
	assert_refused(s, &point, "/bounds", "no extent");
	assert_refused(s, &wrong, "/bounds/max/1", "less than min's");
	assert_refused(s, &huge, "/bounds", out_of_range);
	s.projection.section.angle = 1e-150;
	assert_refused(s, &huge, "/bounds", out_of_range);
	s.projection.section.way = SECTION_EDGES;
	s.projection.near = s.projection.section.right = s.projection.section.top = 1;
	s.projection.section.bottom = -1;
	assert_refused(s, &b, "/projection",
	    "the gaze does not run between the side planes, less the margin");
	s.projection.type = PROJECTION_MATRIX;
	assert_refused(s, &b, "/projection/type", "has nothing that can be fitted");
	s = parallel(PROJECTION_ORTHO);
	s.has_camera = true;
	s.camera.up[1] = 1;
	assert_refused(s, &b, "/camera/at", "equal to the eye");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_angle),
		cmocka_unit_test(test_eye),
		cmocka_unit_test(test_near_ratio),
		cmocka_unit_test(test_slopes),
		cmocka_unit_test(test_ortho),
		cmocka_unit_test(test_viewport),
		cmocka_unit_test(test_oblique),
		cmocka_unit_test(test_flat),
		cmocka_unit_test(test_cameras),
		cmocka_unit_test(test_refusals),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
