#include "../../core/test/sample.h"
#include "document.h"
#include "../scene/print_scene.h"

static const struct document_wants fit = { WANTS, .needed = SCENE_PROJECTION,
	.fit = true };
static const struct document_wants project = { WANTS };

#define BOX "\"bounds\":{\"min\":[0,0,0],\"max\":[1,2,3]}"
#define BOUNDS_HINT "give \"min\" and \"max\", or \"center\" and \"radius\""
#define CAMERA_HINT                                                      \
	"give \"gaze\" or \"orientation\", with an \"eye\" or without, " \
	"or \"eye\" and \"at\", or \"matrix\" alone"
#define SIDES "\"left\", \"right\", \"bottom\" and \"top\""
#define PARALLEL_HINT                                  \
	"give \"aspect\" with \"height\" or without, " \
	"\"width\" and \"height\", or " SIDES ", or nothing"

static const struct refusal refusals[] = {
	{ &fit, "{" BOX "}",
	    "/projection: missing; add \"projection\": {\"type\": \"persp\", "
	    "\"fovy\": 60, \"aspect\": 1.5, \"near\": 1, \"far\": 10}" },
	{ &project, "{\"bounds\":{}}", "/bounds/min: missing; " BOUNDS_HINT },
	{ &project, "{\"bounds\":{\"radius\":1}}",
	    "/bounds/center: missing; " BOUNDS_HINT },
	{ &project, "{\"bounds\":{\"center\":[0,0,0],\"radius\":0}}",
	    "/bounds/radius: 0 is not positive; a number from 1e-150 to 1e150 "
	    "is wanted" },
	{ &project,
	    "{\"bounds\":{\"center\":[0,0,0],\"radius\":1,\"max\":[1,1,1]}}",
	    "/bounds/max: not together with \"center\"; " BOUNDS_HINT },
	{ &fit, "{\"projection\":{\"type\":\"ortho\"},\"camera\":{}}",
	    "/camera/eye: missing; " CAMERA_HINT },
	{ &fit,
	    "{\"projection\":{\"type\":\"ortho\"},"
	    "\"camera\":{\"at\":[0,0,0]}}",
	    "/camera/eye: missing; " CAMERA_HINT },
	{ &fit,
	    "{\"projection\":{\"type\":\"ortho\"},"
	    "\"camera\":{\"eye\":[0,0,0]}}",
	    "/camera/at: missing; " CAMERA_HINT },
	{ &fit, "{\"projection\":{\"type\":\"ortho\",\"left\":1}}",
	    "/projection/right: missing; " PARALLEL_HINT },
	{ &fit,
	    "{\"projection\":{\"type\":\"ortho\",\"aspect\":1,\"width\":1}}",
	    "/projection/aspect: not together with \"width\"; " PARALLEL_HINT },
	{ &fit, "{\"projection\":{\"type\":\"oblique\"}}",
	    "/projection/kind: missing; give \"kind\" (\"cavalier\" or "
	    "\"cabinet\") or \"angle\"" },
	{ &fit, "{\"projection\":{\"type\":\"persp\",\"fovy\":60}}",
	    "/projection/aspect: missing; give it, or a \"viewport\"" },
	{ &fit,
	    "{\"projection\":{\"type\":\"persp\",\"width\":1,\"height\":1}}",
	    "/projection/near: missing; give it: width and height, or the "
	    "edges, are on the near plane" },
};

REFUSES(refusals)

static struct document read_fit(const char *members)
{
	char text[1024];

	snprintf(text, sizeof text,
	    "{%s,\"bounds\":{\"center\":[1,2,3],"
	    "\"radius\":4}}",
	    members);
	return read_as(&fit, text);
}

static void test_missing(void **state)
{
	struct document d = read_fit("\"projection\":{\"type\":\"ortho\"}");

	(void)state;
	assert_true(d.has_bounds && d.bounds.sphere && !d.has_eye);
	assert_numbers(d.bounds.center, 4, 1.0, 2.0, 3.0, 4.0);
	assert_true(d.scene.projection.aspect[1] == 0);
	d = read_fit("\"projection\":{\"type\":\"ortho\"},"
		     "\"viewport\":{\"width\":4,\"height\":3},"
		     "\"camera\":{\"gaze\":[1,2,3]}");
	assert_numbers(d.scene.projection.aspect, 2, 4.0, 3.0);
	assert_true(!d.has_eye && d.scene.camera.by == CAMERA_GAZE);
	d = read_fit("\"projection\":{\"type\":\"ortho\",\"height\":1,"
		     "\"aspect\":2},\"camera\":{\"eye\":[1,2,3],"
		     "\"orientation\":[0,0,0,1]}");
	assert_numbers(d.scene.projection.aspect, 2, 2.0, 1.0);
	assert_true(d.has_eye);
	d = read_fit("\"projection\":{\"type\":\"persp\",\"view_angle\":1,"
		     "\"aspect\":2},\"camera\":{\"matrix\":[1,0,0,0,0,1,0,0,"
		     "0,0,1,0,0,0,0,1]}");
	assert_true(d.has_eye);
	d = read_as(&fit, "{\"projection\":{\"type\":\"volume\"}," BOX "}");
	assert_false(d.bounds.sphere);
	assert_numbers(d.bounds.max, 3, 1.0, 2.0, 3.0);
}

/* As fit leaves it. */
static void sample_fitted(struct document *d)
{
	struct scene *s = &d->scene;
	struct projection *p = &s->projection;

	memset(d, 0, sizeof *d);
	sample_scene(s, sample_below(2) ? 20 : 0);
	s->has_world = sample_below(2);
	s->has_viewport = sample_below(2);
	s->has_window = sample_below(2);
	s->has_device = sample_below(2);
	s->convention.column = sample_below(2);
	s->camera.by = CAMERA_GAZE;
	p->type = PROJECTION_PERSP + sample_below(3);
	p->extent = sample_below(2) ? EXTENT_SIZE : EXTENT_EDGES;
	if (p->type == PROJECTION_PERSP && sample_below(2))
		p->extent = sample_below(4);
	if (p->extent == EXTENT_FIELD || !(p->angle < 180))
		p->angle = 60;
	p->near = sample_size(3);
	p->far = p->near * 3;
	p->aspect[0] = 1.25;
	p->aspect[1] = 1;
	p->near_ratio = sample_below(2) ? 0.0005 : 0.25;
	d->pick.has_at = sample_below(2);
	d->pick.at[0] = 7;
	d->pick.radius = sample_below(2);
}

static void print_it(const void *d)
{
	print_scene(d);
}

static void assert_same_maps(const struct scene *a, const struct scene *b)
{
	struct map m = { 0 }, n = { 0 };
	enum space to = a->has_viewport ? SPACE_DEVICE : SPACE_NDC;
	const char *why = scene_map(a, SPACE_MODEL, to, &m);

	assert_ptr_equal(scene_map(b, SPACE_MODEL, to, &n), why);
	if (why == NULL)
		assert_memory_equal(&m, &n, sizeof m.origin + sizeof m.m);
	if (!a->has_window || !a->has_device)
		return;
	why = scene_flat_map(a, FLAT_WINDOW, FLAT_DEVICE, &m);
	assert_ptr_equal(scene_flat_map(b, FLAT_WINDOW, FLAT_DEVICE, &n), why);
	if (why == NULL)
		assert_memory_equal(&m, &n, sizeof m.origin + sizeof m.m);
}

/* Every member counts for the maps, or is compared by itself. */
static void test_reads_back(void **state)
{
	(void)state;
	sample_seed(1);
	for (int i = 0; i < 300; i++) {
		struct document d, r;
		int status;

		sample_fitted(&d);
		r = read_as(&project, output_of(print_it, &d, &status));
		assert_int_equal(status, 0);
		assert_same_maps(&d.scene, &r.scene);
		assert_true(d.scene.has_viewport == r.scene.has_viewport);
		assert_true(d.scene.has_window == r.scene.has_window);
		assert_true(d.scene.has_device == r.scene.has_device);
		assert_true(r.scene.projection.type != PROJECTION_PERSP ||
		    d.scene.projection.near_ratio ==
			r.scene.projection.near_ratio);
		assert_true(d.pick.has_at == r.pick.has_at);
		assert_true(d.pick.radius == r.pick.radius);
		assert_true(!d.pick.has_at || r.pick.at[0] == 7);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_refusals),
		cmocka_unit_test(test_missing),
		cmocka_unit_test(test_reads_back),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
