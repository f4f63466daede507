/* SPDX-License-Identifier: MIT */
#include "read_text.h"

#define M34 "[[1,2,3,4],[5,6,7,8],[9,10,11,12]]"
#define M43 "[[1,5,9],[2,6,10],[3,7,11],[4,8,12]]"

static void test_camera(void **state)
{
#define CAMERA(members) \
	scene_of("{\"convention\":\"d3d\",\"camera\":{" members "}}").camera
	struct camera c = CAMERA("\"at\":[4,5,6],\"eye\":[1,2,-1e150]");

	(void)state;
	assert_int_equal(c.way, CAMERA_AT);
	assert_numbers(c.eye, 3, 1.0, 2.0, -1e150);
	assert_numbers(c.at, 3, 4.0, 5.0, 6.0);
	assert_numbers(c.up, 3, 0.0, 1.0, 0.0);
	assert_number(c.roll, 0);
	c = CAMERA("\"eye\":[0,0,0],\"gaze\":[0,1,0],\"up\":[0,0,1],"
		   "\"roll\":-30");
	assert_int_equal(c.way, CAMERA_GAZE);
	assert_numbers(c.at, 3, 0.0, 1.0, 0.0);
	assert_numbers(c.up, 3, 0.0, 0.0, 1.0);
	assert_number(c.roll, -30);
	c = CAMERA("\"eye\":[0,0,0],\"orientation\":[1,2,3,4],\"roll\":1");
	assert_int_equal(c.way, CAMERA_ORIENTATION);
	assert_numbers(c.orientation, 4, 1.0, 2.0, 3.0, 4.0);
	assert_number(c.roll, 1);
	c = CAMERA("\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1],"
		   "\"orthonormalize\":true");
	assert_int_equal(c.way, CAMERA_MATRIX);
	assert_numbers(c.steps.matrix[3], 4, 5.0, 6.0, 7.0, 1.0);
	assert_true(c.orthonormalize);
	c = CAMERA("\"orientation\":[1,2,3,4],\"translation\":[5,6,7]");
	assert_int_equal(c.way, CAMERA_TRANSLATION);
	assert_numbers(c.eye, 3, 5.0, 6.0, 7.0);
	c = CAMERA("\"pose\":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]");
	assert_int_equal(c.way, CAMERA_POSE);
	assert_numbers(c.steps.matrix[3], 4, 5.0, 6.0, 7.0, 1.0);
	c = CAMERA("\"rotation\":[[1,2,3],[4,5,6],[7,8,0]],\"translation\":[5,6,7],"
		   "\"axes\":\"F-Lu\"");
	assert_int_equal(c.way, CAMERA_ROTATION_TRANSLATION);
	assert_numbers(c.rotation[1], 3, 4.0, 5.0, 6.0);
	assert_true(c.has_axes && c.axes[0] == AXIS_FORWARD && c.axes[1] == AXIS_LEFT &&
	    c.axes[2] == AXIS_UP);
	/* 3 rows of 4 are for column vectors and 4 rows of 3 for row vectors, in every
	 * convention */
	static const char *const shapes[] = { "\"camera\":{\"matrix\":" M34 "}",
		"\"camera\":{\"matrix\":" M43 "}",
		"\"camera\":{\"matrix\":{\"matrix\":" M34 ",\"vectors\":\"column\"}}" };

	for (int i = 0; i < 6; i++) {
		char text[200] = "{\"convention\":\"gl\",";

		if (i % 2)
			strcpy(text, "{\"convention\":\"d3d\",");
		c = scene_of(strcat(strcat(text, shapes[i / 2]), "}")).camera;
		assert_numbers(c.steps.matrix[0], 16, 1.0, 5.0, 9.0, 0.0, 2.0, 6.0,
		    10.0, 0.0, 3.0, 7.0, 11.0, 0.0, 4.0, 8.0, 12.0, 1.0);
	}
}

static void test_flat(void **state)
{
	struct scene s = scene_of(
	    "{\"viewport\":{\"width\":4,\"height\":3},\"device\":{\"x\":1,"
	    "\"y\":2,\"width\":3,\"height\":4},\"window\":{\"left\":1,"
	    "\"right\":2,\"bottom\":3,\"top\":4},\"bounds\":{\"min\":[0,0,0],"
	    "\"max\":[1,1,1]},"
	    "\"pick\":{}}");

	(void)state;
	assert_numbers(&s.viewport.x, 6, 0.0, 0.0, 4.0, 3.0, 0.0, 1.0);
	assert_int_equal(s.viewport.scale, SCALE_FILL);
	assert_true(s.has_viewport && s.has_device && s.has_window);
	assert_numbers(&s.device.x, 4, 1.0, 2.0, 3.0, 4.0);
	assert_false(s.device.top_left);
	assert_true(s.window.by_edges && !s.window.has_about);
	assert_numbers(&s.window.left, 4, 1.0, 2.0, 3.0, 4.0);
	assert_number(s.window.zoom, 1);
	assert_int_equal(s.window.adapt, ADAPT_STRETCH);
	s = scene_of("{\"viewport\":{\"x\":1,\"y\":2,\"width\":3,\"height\":4,"
		     "\"min_z\":5,\"max_z\":6,\"scale\":[7,8]},"
		     "\"window\":{\"center\":[1,2],\"width\":3,\"height\":4,"
		     "\"pan\":[5,6],\"zoom\":7,\"about\":[8,9],"
		     "\"adapt\":\"shrink\"},\"device\":{\"width\":1,"
		     "\"height\":1,\"origin\":\"top-left\"}}");
	assert_numbers(&s.viewport.x, 6, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
	assert_int_equal(s.viewport.scale, SCALE_GIVEN);
	assert_numbers(s.viewport.scales, 2, 7.0, 8.0);
	assert_false(s.window.by_edges);
	assert_numbers(s.window.center, 2, 1.0, 2.0);
	assert_numbers(s.window.pan, 2, 5.0, 6.0);
	assert_true(s.window.zoom == 7 && s.window.has_about);
	assert_numbers(s.window.about, 2, 8.0, 9.0);
	assert_int_equal(s.window.adapt, ADAPT_SHRINK);
	assert_true(s.device.top_left);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_camera),
		cmocka_unit_test(test_flat),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
