/* SPDX-License-Identifier: MIT */
/* Maps by lists of steps against MPFR, their exactness and their refusals. */
#include "../scene/steps.h"

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

/* A scene whose world and camera are lists of steps. */
struct scene_of_steps {
	struct scene s;
	struct step world[6], camera[6];
};

static void sample_scene_of_steps(struct scene_of_steps *r, int e)
{
	int n[2] = { (int)sample_below(7), (int)sample_below(7) };

	sample_scene(&r->s, 0);
	sample_steps(r->world, n[0], e);
	sample_steps(r->camera, n[1], e);
	r->s.has_world = r->s.has_camera = true;
	r->s.camera.way = sample_below(2) ? CAMERA_MATRIX : CAMERA_POSE;
	r->s.camera.orthonormalize = false;
	enum angle_unit unit = sample_below(2) ? ANGLE_DEGREES : ANGLE_RADIANS;

	r->s.world = (struct steps){ .step = r->world, .n = n[0], .unit = unit };
	r->s.camera.steps = (struct steps){ .step = r->camera,
		.n = n[1],
		.unit = unit };
}

static void check_lists(const char *what, int e, int tries)
{
	struct worst w = { 0 };

	SAMPLES(i, tries) {
		struct scene_of_steps r;
		enum space from = sample_below(3), to = sample_below(3);

		sample_scene_of_steps(&r, e);
		compare(&r.s, from, to, &w);
		compare(&r.s, SPACE_MODEL, SPACE_CLIP, &w);
		compare(&r.s, SPACE_DEVICE, SPACE_MODEL, &w);
	}
	assert_maps(what, &w);
}

static void random_lists(void **state)
{
	(void)state;
	check_lists("ordinary", 0, 240);
	check_lists("hostile, to 1e5", 5, 80);
}

/* The nearest rotation of a product is within the bound of one matrix. */
static void orthonormalized_products(void **state)
{
	struct worst w = { 0 };

	(void)state;
	SAMPLES(i, 80) {
		struct scene_of_steps r;

		sample_scene_of_steps(&r, 0);
		r.s.camera.orthonormalize = true;
		compare(&r.s, SPACE_WORLD, SPACE_VIEW, &w);
		compare(&r.s, SPACE_VIEW, SPACE_WORLD, &w);
	}
	assert_errors("nearest rotations", &w, 0x1p-245 / TRUTH_TOLERANCE);
}

static bool map_of_list(const struct step *s, int n, bool inverse, struct map *m,
    struct refusals *why)
{
	const struct steps list = { .step = s, .n = n, .unit = ANGLE_DEGREES };

	return steps_map(&list, "/world", inverse, false, m, why);
}

/* A list and its inverse multiply to exactly the identity, if all of it is rational. */
static void rational_lists_are_exact(void **state)
{
	(void)state;
	SAMPLES(i, 200) {
		struct step s[7] = { { .kind = STEP_INVERSE, .inner = 3 } };
		struct map m;

		sample_steps(s + 1, 3, 0);
		for (int k = 1; k < 4; k++) {
			s[k].angle = 90 * (double)sample_below(9) - 360;
			if (s[k].inner != 0 || s[k].kind == STEP_INVERSE ||
			    s[k].kind == STEP_RVEC || s[k].kind == STEP_ROTATE)
				s[k].kind = STEP_NODE;
			s[k].inner = 0;
			s[k].rotation[3] = 1;
			s[k + 3] = s[k];
		}
		if (!map_of_list(s, 7, sample_below(2), &m, NULL))
			continue;
		for (int k = 0; k < 16; k++) {
			assert_true(sum_is_exact(&m.m[k / 4][k % 4]));
			assert_number(element(&m, k / 4, k % 4), k % 5 == 0);
		}
	}
}

/* Angles whose sine or cosine is 1/2, and small ones, keep their digits. */
static void single_angles(void **state)
{
	struct step s = { .kind = STEP_ROTATE_Z, .angle = 30 };
	struct map m;

	(void)state;
	assert_true(map_of_list(&s, 1, false, &m, NULL));
	assert_true(sum_is_exact(&m.m[0][1]) && element(&m, 0, 1) == 0.5);
	assert_true(element(&m, 1, 0) == -0.5);
	s.angle = 60;
	assert_true(map_of_list(&s, 1, true, &m, NULL));
	assert_true(sum_is_exact(&m.m[0][0]) && element(&m, 0, 0) == 0.5);
	s = (struct step){ .kind = STEP_ROTATE, .rotation = { 1, 1 }, .angle = 1e-150 };
	assert_true(map_of_list(&s, 1, false, &m, NULL));
	/* (1 - cos a) / 2 is a^2 / 4, with a in radians */
	assert_number(element(&m, 0, 1), 7.615435494667715079552378e-305);
}

static void assert_step_refused(const struct step *s, int n, bool inverse,
    const char *where, const char *what)
{
	struct map m;

	assert_refusal(map_of_list(s, n, inverse, &m, &faults), &faults, where, what,
	    NULL);
}

/* Messages name the step by its place in the list and in lists of inverses. */
static void refused_steps(void **state)
{
	struct step s[14] = { 0 };

	(void)state;
	s[12] = (struct step){ .kind = STEP_SCALE, .scale = { 1, 0, 1 } };
	assert_step_refused(s, 14, false, "/world/12",
	    "its scale has a factor 0, which flattens all points");
	s[12] = (struct step){ .kind = STEP_QUATERNION };
	assert_step_refused(s, 14, false, "/world/12",
	    "its quaternion is 0, which is no rotation");
	s[12] = (struct step){ .kind = STEP_ROTATE };
	assert_step_refused(s, 14, true, "/world/12",
	    "its axis is 0, which has no direction");
	s[12] = (struct step){ .kind = STEP_RVEC, .rotation = { 7 } };
	s[3] = (struct step){ .kind = STEP_INVERSE, .inner = 10 };
	s[5] = (struct step){ .kind = STEP_INVERSE, .inner = 7 };
	assert_step_refused(s, 14, false, "/world/3/inverse/1/inverse/6",
	    "its rvec is longer than 2 pi");
	s[12] = (struct step){ .kind = STEP_MATRIX, .matrix = { { 1 } } };
	assert_refusal(map_of_list(s, 14, false, &(struct map){ 0 }, &faults), &faults,
	    "/world/3/inverse/1/inverse/6", STEPS_NOT_AFFINE, STEPS_NOT_AFFINE_REMEDY);
	s[12].matrix[3][3] = 1;
	assert_step_refused(s, 14, true, "/world/3/inverse/1/inverse/6", "singular");
	assert_step_refused(s, 14, false, "/world/3/inverse/1/inverse/6", "singular");
	s[3].inner = 1;
	s[5] = (struct step){ 0 };
	assert_true(map_of_list(s, 14, false, &(struct map){ 0 }, NULL));
}

/* The pointer to a step in more inverses than a refusal has room for ends at one. */
static void deep_steps_are_refused(void **state)
{
	struct step s[STEPS_MAX];
	char where[sizeof faults.list->where] = "/world";

	(void)state;
	for (int k = 0; k < STEPS_MAX; k++)
		s[k] = (struct step){ .kind = STEP_INVERSE,
			.inner = STEPS_MAX - 1 - k };
	s[STEPS_MAX - 1].kind = STEP_SCALE;
	for (int k = 1; k < STEPS_MAX; k++)
		strcat(where, "/0/inverse");
	strcat(where, "/0");
	assert_step_refused(s, STEPS_MAX, false, where, NULL);
	memcpy(where + 6 + 20 * 10, "/0", 3);
	assert_step_refused(s + STEPS_MAX - 21, 21, false, where, NULL);
}

/* Eight nodes of 17 digits in world and eight in a pose have room in every direction.
 * Sixty-four do not, and the list is named. */
static void room_for_digits(void **state)
{
	static struct step s[2][STEPS_MAX];
	struct scene scene = { .has_world = true, .has_camera = true };
	struct map m;

	(void)state;
	SAMPLES(i, 16) {
		for (int k = 0; k < 2 * STEPS_MAX; k++)
			do
				sample_steps(&s[k % 2][k / 2], 1, 2);
			while (s[k % 2][k / 2].kind != STEP_NODE);
		scene.camera.way = i % 2 ? CAMERA_POSE : CAMERA_MATRIX;
		scene.world = (struct steps){ .step = s[0],
			.n = 8,
			.unit = ANGLE_DEGREES };
		scene.camera.steps = (struct steps){ .step = s[1],
			.n = 8,
			.unit = ANGLE_DEGREES };
		assert_true(scene_map(&scene, SPACE_MODEL, SPACE_VIEW, &m, NULL));
		assert_true(scene_map(&scene, SPACE_VIEW, SPACE_MODEL, &m, NULL));
		scene.world.n = STEPS_MAX;
		assert_refusal(scene_map(&scene, SPACE_VIEW, SPACE_MODEL, &m, &faults),
		    &faults, "/world", STEPS_TOO_WIDE, STEPS_TOO_WIDE_REMEDY);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(random_lists),
		cmocka_unit_test(orthonormalized_products),
		cmocka_unit_test(rational_lists_are_exact),
		cmocka_unit_test(single_angles),
		cmocka_unit_test(refused_steps),
		cmocka_unit_test(deep_steps_are_refused),
		cmocka_unit_test(room_for_digits),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
