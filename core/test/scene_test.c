/* SPDX-License-Identifier: MIT */
/* Maps between any two spaces against MPFR, and refusals. */
#include "claims.h"

static struct refusals faults;

static void compare(const struct scene *s, enum space from, enum space to,
    struct worst *w)
{
	struct map m;
	struct truth t;
	int mark = real_mark();

	if (scene_map(s, from, to, &m, NULL)) {
		truth_scene(s, from, to, &t);
		truth_compare(&t, &m, w);
	}
	real_release(mark);
}

static void check_scenes(const char *what, int e, int tries)
{
	struct worst w = { 0 };

	SAMPLES(i, tries) {
		struct scene s;

		sample_scene(&s, e);
		sample_answer(&s);
		compare(&s, sample_below(6), sample_below(6), &w);
		compare(&s, SPACE_MODEL, SPACE_DEVICE, &w);
		compare(&s, SPACE_DEVICE, SPACE_MODEL, &w);
	}
	assert_maps(what, &w);
}

static void random_scenes(void **state)
{
	(void)state;
	check_scenes("ordinary", 0, 250);
	check_scenes("hostile, to 1e2", 2, 200);
	check_scenes("hostile, to 1e20", 20, 100);
}

/* A model 1e15 from the origin, near the eye. The distance causes no error in the map
 * and in its inverse. */
static void models_far_from_the_origin(void **state)
{
	struct worst w = { 0 };

	(void)state;
	SAMPLES(i, 100) {
		struct scene s;

		sample_scene(&s, 0);
		s.has_world = true;
		s.camera.way = CAMERA_AT;
		s.camera.has_axes = false;
		for (int k = 0; k < 3; k++) {
			s.world.matrix[3][k] = 1e15 * sample_between(-1, 1);
			s.camera.eye[k] = s.world.matrix[3][k] +
			    sample_between(-20, 20);
			s.camera.at[k] = s.camera.eye[k] + sample_between(-20, 20);
		}
		compare(&s, SPACE_MODEL, SPACE_VIEW, &w);
		compare(&s, SPACE_MODEL, SPACE_CLIP, &w);
		compare(&s, SPACE_CLIP, SPACE_MODEL, &w);
	}
	assert_maps("1e15 from the origin", &w);
}

/* Converts a camera and a projection matrix from each convention through all others,
 * and back. Their whole numbers stay exact. */
static void around_all_conventions(void **state)
{
	static const struct convention known[] = { { 0 },
		{ .right_handed = true,
		    .depth_minus_one = true,
		    .origin_bottom_left = true },
		{ .right_handed = true, .ndc_y_down = true }, { .right_handed = true },
		{ .right_handed = true, .view_y_down = true, .ndc_y_down = true } };

	(void)state;
	for (int k = 0; k < 25; k++) {
		struct scene s = {
			.convention = known[k % 5],
			.has_camera = true,
			.camera = { .way = CAMERA_MATRIX,
			    .steps.matrix = { { 0, 3, 4, 0 }, { 5, 0, 1, 0 },
				{ 1, 2, 3, 0 }, { 7, -8, 9, 1 } } },
			.projection = { .type = PROJECTION_MATRIX,
			    .matrix = { { 2, 0, 0, 0 }, { 0, 3, 0, 0 }, { 4, 5, 6, 1 },
				{ 7, 8, 10, 0 } } },
		};
		struct scene given = s;
		struct map view, clip, m;

		for (int i = 1; i <= 5; i++) {
			int next = (k % 5 + i * (1 + k / 5 % 4)) % 5;

			s.answer = &known[next];
			assert_true(
			    scene_map(&s, SPACE_WORLD, SPACE_VIEW, &view, NULL));
			assert_true(scene_map(&s, SPACE_VIEW, SPACE_CLIP, &clip, NULL));
			for (int j = 0; j < 16; j++) {
				s.camera.steps.matrix[j / 4][j % 4] = element(&view,
				    j / 4, j % 4);
				s.projection.matrix[j / 4][j % 4] = element(&clip,
				    j / 4, j % 4);
			}
			s.convention = known[next];
		}
		assert_memory_equal(&s.convention, &given.convention,
		    sizeof s.convention);
		assert_memory_equal(s.camera.steps.matrix, given.camera.steps.matrix,
		    sizeof s.camera.steps.matrix);
		assert_memory_equal(s.projection.matrix, given.projection.matrix,
		    sizeof s.projection.matrix);
		assert_true(scene_map(&given, SPACE_WORLD, SPACE_CLIP, &m, NULL));
	}
}

/* The map to the device is the same in every convention of the answer that has the
 * same origin of the device. */
static void device_is_the_same_in_all_conventions(void **state)
{
	(void)state;
	SAMPLES(k, 60) {
		struct scene s;
		struct map own, other;

		sample_scene(&s, 0);
		sample_answer(&s);
		if (s.answer != NULL)
			s.convention.origin_bottom_left = s.answer->origin_bottom_left;
		if (!scene_map(&s, SPACE_MODEL, SPACE_DEVICE, &other, NULL))
			continue;
		s.answer = NULL;
		assert_true(scene_map(&s, SPACE_MODEL, SPACE_DEVICE, &own, NULL));
		for (int j = 0; j < 16; j++)
			assert_number(element(&own, j / 4, j % 4),
			    element(&other, j / 4, j % 4));
	}
}

static void assert_identity(const struct map *m)
{
	for (int k = 0; k < 16; k++)
		assert_true(element(m, k / 4, k % 4) == (k / 4 == k % 4));
}

static void map_to_the_same_space(void **state)
{
	struct scene s;
	struct map m;

	(void)state;
	sample_scene(&s, 0);
	for (enum space space = SPACE_MODEL; space <= FLAT_DEVICE; space++) {
		assert_true(scene_map(&s, space, space, &m, NULL));
		assert_identity(&m);
	}
	/* from clip space to ndc there is only the division */
	assert_true(scene_map(&s, SPACE_CLIP, SPACE_NDC, &m, NULL));
	assert_identity(&m);
}

static void assert_scene_refused(const struct scene *s, enum space from, enum space to,
    const char *where, const char *what, const char *remedy)
{
	struct map m;

	assert_refusal(scene_map(s, from, to, &m, &faults), &faults, where, what,
	    remedy);
}

static void refusals(void **state)
{
	struct scene s = {
		.has_world = true,
		.has_camera = true,
		.world.matrix = { { 1 }, { 0, 1 }, { 0, 0, 1 }, { 0, 0, 0, 1 } },
		.camera = { .at = { 0, 0, 1 }, .up = { 0, 1, 0 } },
		.projection = { .type = PROJECTION_ORTHO,
		    .section.way = SECTION_SIZE,
		    .section.width = 1,
		    .section.height = 1,
		    .far = 1 },
	};

	(void)state;
	assert_scene_refused(&s, SPACE_NDC, SPACE_DEVICE, "/viewport", NULL, NULL);
	assert_scene_refused(&s, SPACE_DEVICE, SPACE_MODEL, "/viewport", NULL, NULL);
	s.world.matrix[0][3] = 1e-9;
	assert_scene_refused(&s, SPACE_MODEL, SPACE_WORLD, "/world", NULL, NULL);
	assert_scene_refused(&s, SPACE_WORLD, SPACE_MODEL, "/world", STEPS_NOT_AFFINE,
	    STEPS_NOT_AFFINE_REMEDY);
	s.world.matrix[3][0] = 1;
	assert_scene_refused(&s, SPACE_MODEL, SPACE_WORLD, "/world", STEPS_NOT_AFFINE,
	    STEPS_NOT_AFFINE_REMEDY);
	s.world.matrix[0][3] = s.world.matrix[3][0] = 0;
	s.world.matrix[0][0] = 0;
	assert_scene_refused(&s, SPACE_CLIP, SPACE_MODEL, "/world", NULL, NULL);
	s.world.matrix[0][0] = 1e150;
	s.projection.section.width = 1e-150;
	s.has_viewport = true;
	s.viewport = (struct viewport){ .width = 1e150, .height = 1, .max_z = 1 };
	assert_scene_refused(&s, SPACE_MODEL, SPACE_DEVICE, "/projection", NULL, NULL);
	s.projection.section.width = 1;
	memcpy(s.camera.at, s.camera.eye, sizeof s.camera.at);
	assert_scene_refused(&s, SPACE_MODEL, SPACE_DEVICE, "/camera/at", NULL, NULL);
	assert_scene_refused(&s, SPACE_VIEW, SPACE_MODEL, "/camera/at", NULL, NULL);
}

static void make_unknown(double *v, size_t size)
{
	for (size_t i = 0; i < size / sizeof *v; i++)
		v[i] = (double)NAN;
}

/* All parts are refused in one call, each for all that is wrong with it. Numbers that
 * are not known are no fault, and hide none. */
static void each_part_is_judged(void **state)
{
	static struct step flat = { .kind = STEP_SCALE }, wrong = { .is_wrong = true };
	struct scene s = { .has_world = true,
		.has_camera = true,
		.has_viewport = true,
		.viewport = { .width = 1, .height = 1 } };
	static const char *const where[] = { "/world/0", "/camera/at", "/camera/up",
		"/projection/right", "/projection/near", "/viewport/max_z" };
	const size_t n = sizeof where / sizeof *where;

	(void)state;
	s.world = (struct steps){ .step = &flat, .n = 1 };
	projection_set_defaults(&s.projection, PROJECTION_PERSP);
	s.projection.section.way = SECTION_EDGES;
	s.projection.section.top = s.projection.near = 1;
	faults.n = 0;
	scene_check(&s, SPACE_MODEL, SPACE_DEVICE, &faults);
	assert_int_equal(faults.n, n - 1);
	scene_check(&s, SPACE_DEVICE, SPACE_MODEL, &faults);
	assert_int_equal(faults.n, n); /* the same is told once */
	for (size_t i = 0; i < n; i++)
		assert_string_equal(faults.list[i].where, where[i]);
	faults.n = 0;
	s.world.step = &wrong;
	make_unknown(s.camera.eye, sizeof s.camera.eye);
	make_unknown(&s.projection.section.left, sizeof(double));
	make_unknown(&s.projection.far, sizeof(double));
	make_unknown(&s.viewport.min_z, sizeof(double));
	scene_check(&s, SPACE_DEVICE, SPACE_MODEL, &faults);
	assert_int_equal(faults.n, 1);
	assert_string_equal(faults.list[0].where, "/camera/up");
	faults.n = 0;
}

/* A scene of which any numbers are not known is refused for none of them. */
static void unknown_numbers_are_no_fault(void **state)
{
	(void)state;
	SAMPLES(i, 100) {
		struct scene s;

		sample_scene(&s, 0);
		make_unknown(s.camera.eye, sizeof s.camera.eye);
		make_unknown(s.camera.up, sizeof s.camera.up);
		make_unknown(s.camera.orientation, sizeof s.camera.orientation);
		make_unknown(s.camera.rvec, sizeof s.camera.rvec);
		make_unknown(s.camera.rotation[0], sizeof s.camera.rotation);
		make_unknown(s.projection.section.edges, 4 * sizeof(double));
		make_unknown(s.projection.section.angles, 4 * sizeof(double));
		make_unknown(s.projection.section.intrinsics[0],
		    sizeof s.projection.section.intrinsics);
		make_unknown(&s.projection.near, sizeof(double));
		make_unknown(&s.projection.volume.z_far, sizeof(double));
		make_unknown(s.projection.volume.eye, sizeof s.projection.volume.eye);
		make_unknown(s.projection.matrix[0], sizeof s.projection.matrix);
		s.camera.steps.is_wrong = s.world.is_wrong = true;
		faults.n = 0;
		scene_check(&s, SPACE_MODEL, SPACE_DEVICE, &faults);
		scene_check(&s, SPACE_DEVICE, SPACE_MODEL, &faults);
		if (faults.n > 0)
			fail_msg("%s: %s", faults.list[0].where, faults.list[0].what);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(random_scenes),
		cmocka_unit_test(models_far_from_the_origin),
		cmocka_unit_test(around_all_conventions),
		cmocka_unit_test(device_is_the_same_in_all_conventions),
		cmocka_unit_test(map_to_the_same_space),
		cmocka_unit_test(refusals),
		cmocka_unit_test(each_part_is_judged),
		cmocka_unit_test(unknown_numbers_are_no_fault),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
