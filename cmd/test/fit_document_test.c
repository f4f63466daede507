/* SPDX-License-Identifier: MIT */
/* Documents of fit, in which the members that fit computes may be missing. */
#include "read_text.h"

static const struct document_wants fit = { WANTS, .needed = SCENE_PROJECTION,
	.source.task = TASK_FIT };
static const struct document_wants project = { WANTS };

static const struct document_wants either = { WANTS, .needed = SCENE_PROJECTION,
	.flat_members = SCENE_WINDOW | SCENE_DEVICE, .source.task = TASK_FIT };

#define BOX "\"bounds\":{\"min\":[0,0,0],\"max\":[1,2,3]}"
#define WINDOW_HINT                                                \
	"give \"center\", \"width\" and \"height\", or \"left\", " \
	"\"right\", \"bottom\" and \"top\""
#define BOUNDS_HINT "give \"min\" and \"max\", or \"center\" and \"radius\""

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
	{ &project, "{\"bounds\":{\"center\":[0,0,0],\"radius\":1,\"max\":[1,1,1]}}",
	    "/bounds/max: does not go with \"center\" and "
	    "\"radius\"; " BOUNDS_HINT },
	{ &fit, "{\"projection\":{\"type\":\"ortho\"},\"camera\":{}}",
	    "/camera/eye: missing; give \"eye\" and \"at\", or \"gaze\", or "
	    "\"orientation\", or \"rvec\", or \"orientation\" and "
	    "\"translation\", or \"rvec\" and \"translation\", or \"pose\", or "
	    "\"matrix\"" },
	{ &fit,
	    "{\"projection\":{\"type\":\"ortho\"},"
	    "\"camera\":{\"at\":[0,0,0]}}",
	    "/camera/eye: missing; give \"eye\" and \"at\", or \"gaze\", or "
	    "\"orientation\", or \"rvec\", or \"orientation\" and "
	    "\"translation\", or \"rvec\" and \"translation\", or \"pose\", or "
	    "\"matrix\"" },
	{ &fit,
	    "{\"projection\":{\"type\":\"ortho\"},"
	    "\"camera\":{\"eye\":[0,0,0]}}",
	    "/camera/at: missing; give \"eye\" and \"at\", or \"eye\" and "
	    "\"gaze\", or \"eye\" and \"orientation\", or \"eye\" and "
	    "\"rvec\", or \"orientation\" and \"translation\", or \"rvec\" and "
	    "\"translation\", or \"pose\", or \"matrix\"" },
	{ &fit, "{\"projection\":{\"type\":\"ortho\",\"left\":1}}",
	    "/projection/right: missing; give none of them, or none of them, "
	    "or none of them, or \"left\", \"right\", \"bottom\" and \"top\"" },
	{ &fit,
	    "{\"projection\":{\"type\":\"ortho\",\"aspect\":1,\"width\":1,"
	    "\"height\":1}}",
	    "/projection/aspect: does not go with \"width\" and \"height\"; "
	    "give \"width\" "
	    "and \"height\", or \"width\" and \"aspect\", or \"height\" and "
	    "\"aspect\", or \"left\", \"right\", \"bottom\" and \"top\"" },
	{ &fit, "{\"projection\":{\"type\":\"oblique\"}}",
	    "/projection/kind: missing; give \"kind\", or \"angle\" of the projectors; "
	    "lines along the gaze have the \"direction\" in the picture" },
	{ &fit, "{\"projection\":{\"type\":\"persp\",\"fovy\":60}}",
	    "/projection/aspect: missing; give it, or a \"viewport\"" },
	{ &fit, "{\"projection\":{\"type\":\"persp\",\"width\":1,\"height\":1}}",
	    "/projection/near: missing; the section is on the near plane, "
	    "unless \"edges_at\" says where" },
	{ &either, "{\"camera\":{}}",
	    "/projection: missing; add \"projection\": {\"type\": \"persp\", "
	    "\"fovy\": 60, \"aspect\": 1.5, \"near\": 1, \"far\": 10}, or for "
	    "two dimensions \"window\": {}" },
	{ &either, "{\"window\":{}," BOX "}",
	    "/bounds/min: has 3 elements; an array of 2 numbers is wanted" },
	{ &either, "{\"window\":{},\"bounds\":{\"center\":1,\"radius\":1}}",
	    "/bounds/center: is a number; an array of 2 numbers is wanted" },
	{ &either, "{\"window\":{\"left\":1,\"width\":1}}",
	    "/window/left: does not go with \"width\"; give \"width\", or "
	    "\"left\"" },
	{ &either, "{\"device\":{\"width\":1,\"height\":1},\"points\":[[1]]}",
	    "/points/0: has 1 element; 2 coordinates are wanted" },
	{ &project, "{\"window\":{}}", "/window/center: missing; " WINDOW_HINT },
	{ &project,
	    "{\"device\":{\"width\":1,\"height\":1},\"bounds\":"
	    "{\"min\":[0,0],\"max\":[1,1]}}",
	    "/bounds/min: has 2 elements; an array of 3 numbers is wanted" },
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
	assert_number(d.scene.projection.aspect[1], 0);
	d = read_fit("\"projection\":{\"type\":\"ortho\"},"
		     "\"viewport\":{\"width\":4,\"height\":3},"
		     "\"camera\":{\"gaze\":[1,2,3]}");
	assert_numbers(d.scene.projection.aspect, 2, 4.0, 3.0);
	assert_true(!d.has_eye && d.scene.camera.way == CAMERA_GAZE);
	d = read_fit("\"projection\":{\"type\":\"ortho\",\"height\":1,"
		     "\"aspect\":2},\"camera\":{\"eye\":[1,2,3],"
		     "\"orientation\":[0,0,0,1]}");
	assert_numbers(d.scene.projection.aspect, 2, 2.0, 1.0);
	assert_true(d.has_eye);
	d = read_fit("\"projection\":{\"type\":\"persp\",\"view_angle\":1,"
		     "\"aspect\":2},\"camera\":{\"matrix\":[1,0,0,0,0,1,0,0,"
		     "0,0,1,0,0,0,0,1]}");
	assert_true(d.has_eye);
	d = read_as(&fit,
	    "{\"projection\":{\"type\":\"volume\",\"size\":1,\"aspect\":2},"
	    "\"margin\":0.25," BOX "}");
	assert_number(d.scene.margin, 0.25);
	assert_false(d.bounds.sphere);
	assert_numbers(d.bounds.max, 3, 1.0, 2.0, 3.0);
}

static void test_flat(void **state)
{
	static const struct document_wants unused = { .used = SCENE_WINDOW,
		.flat_members = SCENE_WINDOW };
	struct document d = read_as(&either,
	    "{\"window\":{\"zoom\":2},\"points\":[1,2,3],"
	    "\"bounds\":{\"center\":[1,2],\"radius\":4}}");

	(void)state;
	assert_true(d.flat && d.has_bounds && d.bounds.sphere);
	assert_numbers(d.bounds.center, 4, 1.0, 2.0, 0.0, 4.0);
	assert_memory_equal(d.points, "[1,2,3]\n", d.points_size);
	d = read_as(&either,
	    "{\"device\":{\"width\":3,\"height\":2},\"camera\":{\"eye\":"
	    "[1e200,0,0],\"at\":[0,0,0]}}");
	assert_true(d.flat && d.scene.has_device && !d.scene.has_window);
	d = read_as(&either,
	    "{\"device\":{\"width\":3,\"height\":2},"
	    "\"projection\":{\"type\":\"ortho\"}," BOX "}");
	assert_false(d.flat);
	/* points among the operands replace those of the document */
	struct document_wants operands = either;

	operands.coordinates = 0;
	d = read_as(&operands, "{\"window\":{},\"points\":[[1],[2]]}");
	assert_true(d.flat && d.points == NULL);
	/* bounds of a command that does not use them may have two or three numbers */
	d = read_as(&unused, "{\"bounds\":{\"min\":[1,2],\"max\":[3,4]}}");
	assert_false(d.flat);
	assert_numbers(d.bounds.max, 2, 3.0, 4.0);
	d = read_as(&unused,
	    "{\"window\":{\"left\":0,\"right\":1,\"bottom\":0,\"top\":1}," BOX "}");
	assert_true(d.flat);
	assert_numbers(d.bounds.max, 3, 1.0, 2.0, 3.0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_refusals),
		cmocka_unit_test(test_flat),
		cmocka_unit_test(test_missing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
