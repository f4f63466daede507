/* Composed maps between any two spaces against MPFR, and refusals. */
#include "claims.h"

static void compare(const struct scene *s, enum space from, enum space to,
    struct worst *w)
{
	struct map m;
	struct truth t;
	int mark = real_mark();

	if (scene_map(s, from, to, &m) == NULL) {
		truth_scene(s, from, to, &t);
		truth_compare(&t, &m, w);
	}
	real_release(mark);
}

static void scenes(const char *what, int e, int tries)
{
	struct worst w = { 0 };

	sample_seed(1);
	for (int i = 0; i < tries; i++) {
		struct scene s;

		sample_scene(&s, e);
		compare(&s, sample_below(6), sample_below(6), &w);
		compare(&s, SPACE_MODEL, SPACE_DEVICE, &w);
		compare(&s, SPACE_DEVICE, SPACE_MODEL, &w);
	}
	claim_maps(what, &w);
}

static void random_ones(void **state)
{
	(void)state;
	scenes("ordinary", 0, 250);
	scenes("hostile, to 1e2", 2, 200);
	scenes("hostile, to 1e20", 20, 100);
}

/* A model that stands 1e15 from the origin before an eye that is as far: the
 * distance costs nothing, forwards and backwards. */
static void far_away(void **state)
{
	struct worst w = { 0 };

	(void)state;
	sample_seed(2);
	for (int i = 0; i < 100; i++) {
		struct scene s;

		sample_scene(&s, 0);
		s.has_world = true;
		s.camera.by = CAMERA_AT;
		for (int k = 0; k < 3; k++) {
			s.world[3][k] = 1e15 * sample_between(-1, 1);
			s.camera.eye[k] = s.world[3][k] +
			    sample_between(-20, 20);
			s.camera.at[k] = s.camera.eye[k] +
			    sample_between(-20, 20);
		}
		compare(&s, SPACE_MODEL, SPACE_VIEW, &w);
		compare(&s, SPACE_MODEL, SPACE_CLIP, &w);
		compare(&s, SPACE_CLIP, SPACE_MODEL, &w);
	}
	claim_maps("1e15 from the origin", &w);
}

static void assert_identity(const struct map *m)
{
	for (int k = 0; k < 16; k++)
		assert_true(element(m, k / 4, k % 4) == (k / 4 == k % 4));
}

static void nowhere(void **state)
{
	struct scene s;
	struct map m;

	(void)state;
	sample_scene(&s, 0);
	for (int space = SPACE_MODEL; space <= SPACE_DEVICE; space++) {
		assert_null(
		    scene_map(&s, (enum space)space, (enum space)space, &m));
		assert_identity(&m);
	}
	for (int space = FLAT_WINDOW; space <= FLAT_DEVICE; space++) {
		assert_null(
		    scene_flat_map(&s, (enum flat)space, (enum flat)space, &m));
		assert_identity(&m);
	}
	/* clip to ndc only divides */
	assert_null(scene_map(&s, SPACE_CLIP, SPACE_NDC, &m));
	assert_identity(&m);
}

static void refused(const struct scene *s, enum space from, enum space to,
    const char *member)
{
	struct map m;

	claim_refused(scene_map(s, from, to, &m), member);
}

static void refusals(void **state)
{
	struct scene s = {
		.has_world = true,
		.has_camera = true,
		.world = { { 1 }, { 0, 1 }, { 0, 0, 1 }, { 0, 0, 0, 1 } },
		.camera = { .at = { 0, 0, 1 }, .up = { 0, 1, 0 } },
		.projection = { .type = PROJECTION_ORTHO,
		    .extent = EXTENT_SIZE,
		    .width = 1,
		    .height = 1,
		    .far = 1 },
	};

	(void)state;
	refused(&s, SPACE_NDC, SPACE_DEVICE, "/viewport");
	refused(&s, SPACE_DEVICE, SPACE_MODEL, "/viewport");
	s.world[0][3] = 1e-9;
	refused(&s, SPACE_MODEL, SPACE_WORLD, "/world");
	refused(&s, SPACE_WORLD, SPACE_MODEL, "/world: is transposed");
	s.world[3][0] = 1;
	refused(&s, SPACE_MODEL, SPACE_WORLD,
	    "/world: its last column is not 0 0 0 1");
	s.world[0][3] = s.world[3][0] = 0;
	s.world[0][0] = 0;
	refused(&s, SPACE_CLIP, SPACE_MODEL, "/world");
	s.world[0][0] = 1e150;
	s.projection.width = 1e-150;
	s.has_viewport = true;
	s.viewport = (struct viewport){ .width = 1e150,
		.height = 1,
		.max_z = 1 };
	refused(&s, SPACE_MODEL, SPACE_DEVICE, "/projection");
	s.projection.width = 1;
	memcpy(s.camera.at, s.camera.eye, sizeof s.camera.at);
	refused(&s, SPACE_MODEL, SPACE_DEVICE, "/camera/at");
	refused(&s, SPACE_VIEW, SPACE_MODEL, "/camera/at");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(random_ones),
		cmocka_unit_test(far_away),
		cmocka_unit_test(nowhere),
		cmocka_unit_test(refusals),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
