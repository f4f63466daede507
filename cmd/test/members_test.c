/* SPDX-License-Identifier: MIT */
#include "read_text.h"

static const struct document_wants lookat = { .lone_member = SCENE_CAMERA,
	.needed = SCENE_CAMERA,
	WANTS };
static const struct document_wants w2n = { .lone_member = SCENE_WINDOW,
	.needed = SCENE_WINDOW,
	.used = ~0u,
	.coordinates = 2 };
static const struct document_wants project = { WANTS };

#define SIDES "\"left\", \"right\", \"bottom\" and \"top\""
#define WINDOW_HINT "give \"center\", \"width\" and \"height\", or " SIDES
#define POSITIVE "a number from 1e-150 to 1e150 is wanted"
#define AT "\"at\":[0,0,0]"
#define EYE "\"eye\":[0,0,1]"
#define SIZE "\"width\":1,\"height\":1"
#define AFFINE "16 numbers, or 4 rows of 4 or 3, or 3 rows of 4"
#define M34 "[[1,2,3,4],[5,6,7,8],[9,10,11,12]]"
#define M43 "[[1,5,9],[2,6,10],[3,7,11],[4,8,12]]"
#define M16 "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]"

static const struct refusal cameras[] = {
	{ &lookat, "[]", "is an array; an object, {...}, is wanted" },
	{ &lookat, "{}",
	    "/eye: missing; give \"eye\" and \"at\", or \"eye\" and \"gaze\", "
	    "or \"eye\" and \"orientation\", or \"eye\" and \"rvec\", or "
	    "\"orientation\" and \"translation\", or \"rvec\" and "
	    "\"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{\"_note\":1}",
	    "/eye: missing; give \"eye\" and \"at\", or \"eye\" and \"gaze\", "
	    "or \"eye\" and \"orientation\", or \"eye\" and \"rvec\", or "
	    "\"orientation\" and \"translation\", or \"rvec\" and "
	    "\"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{\"camera\":{}}",
	    "/camera/eye: missing; give \"eye\" and \"at\", or \"eye\" and "
	    "\"gaze\", or \"eye\" and \"orientation\", or \"eye\" and "
	    "\"rvec\", or \"orientation\" and \"translation\", or \"rvec\" and "
	    "\"translation\", or \"pose\", or \"matrix\"" },
	{ &project, "{\"camera\":{}}",
	    "/camera/eye: missing; give \"eye\" and \"at\", or \"eye\" and "
	    "\"gaze\", or \"eye\" and \"orientation\", or \"eye\" and "
	    "\"rvec\", or \"orientation\" and \"translation\", or \"rvec\" and "
	    "\"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{" EYE "}",
	    "/at: missing; give \"eye\" and \"at\", or \"eye\" and \"gaze\", "
	    "or \"eye\" and \"orientation\", or \"eye\" and \"rvec\", or "
	    "\"orientation\" and \"translation\", or \"rvec\" and "
	    "\"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{" AT "}",
	    "/eye: missing; give \"eye\" and \"at\", or \"eye\" and \"gaze\", "
	    "or \"eye\" and \"orientation\", or \"eye\" and \"rvec\", or "
	    "\"orientation\" and \"translation\", or \"rvec\" and "
	    "\"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{\"up\":[0,1,0],\"orientation\":[0,0,0,1]}",
	    "/eye: missing; give \"eye\", \"at\" and \"up\", or \"eye\", "
	    "\"gaze\" and \"up\", or \"eye\" and \"orientation\", or \"eye\" "
	    "and \"rvec\", or \"orientation\" and \"translation\", or \"rvec\" "
	    "and \"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{" EYE "," AT ",\"gaze\":[0,0,1]}",
	    "/gaze: does not go with \"at\"; give \"eye\" and \"at\", or "
	    "\"eye\" and \"gaze\", or \"eye\" and \"orientation\", or \"eye\" "
	    "and \"rvec\", or \"orientation\" and \"translation\", or \"rvec\" "
	    "and \"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{" EYE ",\"orientation\":[0,0,0,1],\"up\":[0,1,0]}",
	    "/up: does not go with \"orientation\"; give \"eye\", \"at\" and "
	    "\"up\", or \"eye\", \"gaze\" and \"up\", or \"eye\" and "
	    "\"orientation\", or \"eye\" and \"rvec\", or \"orientation\" and "
	    "\"translation\", or \"rvec\" and \"translation\", or \"pose\", or "
	    "\"matrix\"" },
	{ &lookat, "{\"matrix\":" M16 ",\"roll\":0}",
	    "/roll: does not go with \"matrix\"; give \"eye\", \"at\" and "
	    "\"roll\", or \"eye\", \"gaze\" and \"roll\", or \"eye\", "
	    "\"orientation\" and \"roll\", or \"eye\", \"rvec\" and \"roll\", "
	    "or \"orientation\", \"translation\" and \"roll\", or \"rvec\", "
	    "\"translation\" and \"roll\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{\"matrix\":" M16 ",\"pose\":" M16 "}",
	    "/matrix: does not go with \"pose\"; give \"eye\" and \"at\", or "
	    "\"eye\" and \"gaze\", or \"eye\" and \"orientation\", or \"eye\" "
	    "and \"rvec\", or \"orientation\" and \"translation\", or \"rvec\" "
	    "and \"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{\"pose\":" M16 ",\"roll\":0}",
	    "/roll: does not go with \"pose\"; give \"eye\", \"at\" and "
	    "\"roll\", or \"eye\", \"gaze\" and \"roll\", or \"eye\", "
	    "\"orientation\" and \"roll\", or \"eye\", \"rvec\" and \"roll\", "
	    "or \"orientation\", \"translation\" and \"roll\", or \"rvec\", "
	    "\"translation\" and \"roll\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{\"translation\":[0,0,0]}",
	    "/orientation: missing; give \"eye\" and \"at\", or \"eye\" and "
	    "\"gaze\", or \"eye\" and \"orientation\", or \"eye\" and "
	    "\"rvec\", or \"orientation\" and \"translation\", or \"rvec\" "
	    "and \"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{" EYE ",\"orientation\":[0,0,0,1],\"translation\":[0,0,0]}",
	    "/translation: does not go with \"eye\"; give \"eye\" and "
	    "\"at\", or \"eye\" and \"gaze\", or \"eye\" and \"orientation\", "
	    "or \"eye\" and \"rvec\", or \"orientation\" and \"translation\", "
	    "or \"rvec\" and \"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{\"quaternion\":[1,0,0,0]," EYE "}",
	    "/quaternion: unknown member; did you mean \"orientation\" (x, y, "
	    "z, w, view to world, beside \"eye\"; with a translation it is "
	    "\"pose\", world to view \"matrix\", as [{\"quaternion_wxyz\": q}, "
	    "{\"translate\": t}]; a 3x3 R is in \"matrix\", Euler angles are steps "
	    "in \"pose\")?" },
	{ &project, "{\"camera\":{\"transform_matrix\":" M16 "}}",
	    "/camera/transform_matrix: unknown member; did you mean \"pose\" "
	    "(view to world; of "
	    "NeRF, Blender and ARKit with \"convention\": \"webgpu\")?" },
	{ &lookat, "{\"extrinsics\":" M16 "}",
	    "/extrinsics: unknown member; did you mean \"matrix\" (world to "
	    "view, [R|t])?" },
	{ &lookat, "{\"position\":[0,0,0]," AT "}",
	    "/position: unknown member; did you mean \"eye\"?" },
	{ &lookat, "{\"matrix\":" M16 "," EYE "}",
	    "/eye: does not go with \"matrix\"; give \"eye\" and \"at\", or "
	    "\"eye\" and \"gaze\", or \"eye\" and \"orientation\", or \"eye\" "
	    "and \"rvec\", or \"orientation\" and \"translation\", or \"rvec\" "
	    "and \"translation\", or \"pose\", or \"matrix\"" },
	{ &lookat, "{" EYE "," AT ",\"orthonormalize\":true}",
	    "/orthonormalize: does not go with \"eye\" and \"at\"; give "
	    "\"eye\" and "
	    "\"at\", or \"eye\" and \"gaze\", or \"eye\" and \"orientation\", "
	    "or \"eye\" and \"rvec\", or \"orientation\" and \"translation\", "
	    "or \"rvec\" and \"translation\", or \"pose\" and "
	    "\"orthonormalize\", or \"matrix\" and \"orthonormalize\"" },
	{ &lookat, "{\"matrix\":[1,2]}",
	    "/matrix: has 2 elements; " AFFINE " are wanted" },
	{ &lookat, "{\"matrix\":[1,2,3,4]}",
	    "/matrix/0: is a number; an array of 4 numbers is wanted" },
	{ &lookat, "{\"matrix\":{\"matrix\":[[1,0,0,0],[0,1,0,0],[0,0,1]]}}",
	    "/matrix/matrix/2: has 3 elements; an array of 4 numbers is "
	    "wanted" },
	{ &lookat, "{\"matrix\":[[1,0,0,0],[0,1,0],[0,0,1],[0,0,0]]}",
	    "/matrix/1: has 3 elements; an array of 4 numbers is wanted" },
	{ &lookat, "{\"matrix\":[[1,0,0],[0,1,0],[0,0,1],[0,0,0,1]]}",
	    "/matrix/3: has 4 elements; an array of 3 numbers is wanted" },
	{ &lookat, "{\"matrix\":{\"matrix\":" M34 ",\"vectors\":\"row\"}}",
	    "/matrix/vectors: is \"row\"; 3 rows of 4 are for column vectors" },
	{ &lookat, "{\"matrix\":{\"matrix\":" M43 ",\"vectors\":\"column\"}}",
	    "/matrix/vectors: is \"column\"; 4 rows of 3 are for row vectors" },
	{ &project, "{\"projection\":{\"type\":\"matrix\",\"matrix\":" M34 "}}",
	    "/projection/matrix: has 3 elements; 16 numbers or 4 rows of 4 are "
	    "wanted; K and P are \"intrinsics\" of type \"persp\"" },
	{ &project, "{\"projection\":{\"type\":\"matrix\",\"matrix\":" M43 "}}",
	    "/projection/matrix/0: has 3 elements; an array of 4 numbers is "
	    "wanted" },
	{ &lookat, "{\"matrix\":{\"matrix\":" M16 ",\"vectors\":\"rows\"}}",
	    "/matrix/vectors: is \"rows\"; did you mean \"row\"?" },
	{ &project, "{\"world\":1}",
	    "/world: is a number; an array of " AFFINE " is wanted" },
	{ &project, "{\"world\":{}}", "/world/matrix: missing; give \"matrix\"" },
	{ &project, "{\"world\":[[0,0,0,0],[0,0,0,\"a\"],[],[]]}",
	    "/world/1/3: is a string; a number is wanted" },
	{ &lookat, "{\"eye\":[0,0,true]," AT "}",
	    "/eye/2: is true; a number is wanted" },
	{ &lookat, "{\"eye\":[0,0]," AT "}",
	    "/eye: has 2 elements; an array of 3 numbers is wanted" },
	{ &lookat, "{\"eye\":null," AT "}",
	    "/eye: is null; an array of 3 numbers is wanted" },
	{ &lookat, "{\"eye\":[1.5e150,0,0]," AT "}",
	    "/eye/0: 1.5e+150 is out of range; numbers go up to 1e150" },
	{ &lookat, "{\"eye\":[-1e999,0,0]," AT "}",
	    "/eye/0: is beyond the range of doubles; numbers go up to 1e150" },
	{ &lookat, "{\"orthonormalize\":1}",
	    "/orthonormalize: is a number; true or false is wanted" },
	{ &lookat, "{\"camera\":[]}",
	    "/camera: is an array; an object such as {\"eye\": [0,0,-5], \"at\": "
	    "[0,0,0]}, for a matrix {\"matrix\": [...]} (world to view) or "
	    "{\"pose\": [...]} (view to world) is wanted" },
	{ &lookat, "{\"convention\":\"gl\"}",
	    "/camera: missing; add \"camera\": {\"eye\": [0,0,-5], \"at\": [0,"
	    "0,0]}" },
};

static const struct refusal others[] = {
	{ &project, "{\"viewport\":{\"width\":1}}",
	    "/viewport/height: missing; give \"width\" and \"height\"" },
	{ &project, "{\"viewport\":{" SIZE ",\"scale\":\"fit\"}}",
	    "/viewport/scale: is \"fit\"; \"fill\" or \"uniform\" is wanted" },
	{ &project, "{\"viewport\":{" SIZE ",\"scale\":1}}",
	    "/viewport/scale: is a number; \"fill\", \"uniform\" or 2 numbers "
	    "is wanted" },
	{ &project, "{\"viewport\":{" SIZE ",\"scale\":[1,-1]}}",
	    "/viewport/scale/1: -1 is not positive; " POSITIVE },
	{ &project, "{\"device\":{" SIZE ",\"origin\":\"top\"}}",
	    "/device/origin: is \"top\"; did you mean \"top-left\"?" },
	{ &w2n, "{}", "/center: missing; " WINDOW_HINT },
	{ &w2n, "{\"left\":1,\"width\":1}", "/center: missing; " WINDOW_HINT },
	{ &w2n, "{\"center\":[0,0]," SIZE ",\"top\":1}",
	    "/top: does not go with \"center\", \"width\" and "
	    "\"height\"; " WINDOW_HINT },
	{ &w2n, "{\"zoom\":0}", "/zoom: 0 is not positive; " POSITIVE },
	{ &project, "{\"camera\":{" EYE "," AT ",\"roll\":\"\"}}",
	    "/camera/roll: is a string; a number is wanted" },
};

REFUSES(cameras)
REFUSES(others)

static void test_camera(void **state)
{
#define CAMERA(members) scene_of("{\"camera\":{" members "}}").camera
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
	/* 3 rows of 4 are for column vectors and 4 rows of 3 for row vectors, in every
	 * convention */
	static const char *const shapes[] = { "\"camera\":{\"matrix\":" M34 "}",
		"\"camera\":{\"matrix\":" M43 "}",
		"\"camera\":{\"matrix\":{\"matrix\":" M34 ",\"vectors\":\"column\"}}" };

	for (int i = 0; i < 6; i++) {
		char text[200] = "{\"convention\":\"gl\",";

		if (i % 2)
			strcpy(text, "{");
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
		cmocka_unit_test(test_cameras),
		cmocka_unit_test(test_others),
		cmocka_unit_test(test_camera),
		cmocka_unit_test(test_flat),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
