/* SPDX-License-Identifier: MIT */
/* Documents of fit, in which the members that fit computes may be missing. */
#include "read_text.h"

static const struct document_wants fit = { WANTS, .needed = SCENE_PROJECTION,
	.source.task = TASK_FIT };

static const struct document_wants either = { WANTS, .needed = SCENE_PROJECTION,
	.flat_members = SCENE_WINDOW | SCENE_DEVICE, .source.task = TASK_FIT };

#define BOX "\"bounds\":{\"min\":[0,0,0],\"max\":[1,2,3]}"
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
		     "\"aspect\":2},\"convention\":\"d3d\",\"camera\":{"
		     "\"eye\":[1,2,3],\"orientation\":[0,0,0,1]}");
	assert_numbers(d.scene.projection.aspect, 2, 2.0, 1.0);
	assert_true(d.has_eye);
	d = read_fit("\"projection\":{\"type\":\"persp\",\"view_angle\":1,"
		     "\"aspect\":2},\"convention\":\"d3d\",\"camera\":{"
		     "\"matrix\":[1,0,0,0,0,1,0,0,"
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
		cmocka_unit_test(test_flat),
		cmocka_unit_test(test_missing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
