/* SPDX-License-Identifier: MIT */
/* Refusals of members that have an unknown name, stand in the wrong object, or are
 * repeated. */
#include "read_text.h"

static const struct document_wants lookat = { .lone_member = SCENE_CAMERA,
	.needed = SCENE_CAMERA,
	WANTS };
static const struct document_wants persp = { .lone_member = SCENE_PROJECTION,
	.needed = SCENE_PROJECTION,
	WANTS,
	.source.implied_type = PROJECTION_PERSP };
static const struct document_wants ortho = { .lone_member = SCENE_PROJECTION,
	.needed = SCENE_PROJECTION,
	WANTS,
	.source.implied_type = PROJECTION_ORTHO };
static const struct document_wants volume = { .lone_member = SCENE_PROJECTION,
	.needed = SCENE_PROJECTION,
	WANTS,
	.source.implied_type = PROJECTION_VOLUME };
static const struct document_wants w2n = { .lone_member = SCENE_WINDOW,
	.needed = SCENE_WINDOW,
	.used = ~0u,
	.coordinates = 2 };
static const struct document_wants w2d = { .needed = SCENE_WINDOW | SCENE_DEVICE,
	.used = ~0u,
	.coordinates = 2 };
static const struct document_wants project = { WANTS };

#define AT "\"at\":[0,0,0]"
#define EYE "\"eye\":[0,0,1]"

static const struct refusal names[] = {
#define MEANT(name, right)                                                   \
	{                                                                    \
		&lookat, "{\"" name "\":1}",                                 \
		    "/" name ": unknown member; did you mean \"" right "\"?" \
	}
	MEANT("target", "at"),
	MEANT("center", "at"),
	MEANT("centre", "at"),
	MEANT("lookat", "at"),
	MEANT("look_at", "at"),
	MEANT("lookAt", "at"),
	MEANT("position", "eye"),
	MEANT("pos", "eye"),
	MEANT("from", "eye"),
	MEANT("origin", "eye"),
	MEANT("Eye", "eye"),
	MEANT("eyes", "eye"),
	MEANT("direction", "gaze"),
	MEANT("dir", "gaze"),
	MEANT("forward", "gaze"),
	{ &lookat, "{\"rotation\":0}",
	    "/rotation: unknown member; did you mean \"orientation\" (x, y, "
	    "z, w, view to world, beside \"eye\"; with a translation it is "
	    "\"pose\", world to view \"matrix\", as [{\"quaternion_wxyz\": q}, "
	    "{\"translate\": t}]; a 3x3 R is in \"matrix\", Euler angles are steps "
	    "in \"pose\")?" },
	{ &lookat, "{\"view\":1}",
	    "/view: unknown member; did you mean \"matrix\" (world to view, "
	    "[R|t])?" },
#undef MEANT
#define MEANT(name, right)                                                   \
	{                                                                    \
		&persp, "{\"" name "\":1}",                                  \
		    "/" name ": unknown member; did you mean \"" right "\"?" \
	}
	MEANT("aspectRatio", "aspect"),
	MEANT("aspect_ratio", "aspect"),
	MEANT("ratio", "aspect"),
	MEANT("znear", "near"),
	MEANT("zNear", "near"),
	MEANT("near_plane", "near"),
	MEANT("zfar", "far"),
	MEANT("far_plane", "far"),
	MEANT("reverseZ", "reverse_z"),
#undef MEANT
#define MEANT(name, right)                                                 \
	{                                                                  \
		&project, "{\"" name "\":{}}",                             \
		    "/" name ": unknown member; did you mean \"" right "?" \
	}
#define PROJECTION                             \
	"projection\", such as " PERSP_EXAMPLE \
	" or {\"type\": \"matrix\", \"matrix\": [...]}"
	{ &project, "{\"view\":{}}",
	    "/view: unknown member; did you mean \"camera\", for a matrix "
	    "{\"matrix\": [...]} (world to view) or {\"pose\": [...]} (view to "
	    "world)?" },
	MEANT("lens", PROJECTION),
	MEANT("perspective", PROJECTION),
	MEANT("model", "world\", as [{\"translate\": [1,2,3]}]"),
	MEANT("screen", "viewport\", as " RECTANGLE_EXAMPLE),
	MEANT("point", "points\", as [[0,0,0], [1,1,1]]"),
	{ &lookat, "{\"camra\":{}}",
	    "/camra: unknown member; there are \"eye\", \"at\", \"gaze\", "
	    "\"orientation\", \"rvec\", \"translation\", \"pose\", \"matrix\", "
	    "\"up\", \"roll\" and \"orthonormalize\"" },
	{ &volume, "{\"near\":1}",
	    "/near: unknown member; did you mean \"z_near\" (a z, which is below 0 "
	    "where the camera looks along -z)?" },
	{ &w2n, "{\"x\":1}",
	    "/x: unknown member; did you mean \"left\", with \"right\", "
	    "\"bottom\" and \"top\"?" },
	{ &lookat, "{\"convention\":\"gl\"," EYE "}",
	    "/eye: unknown member; it belongs in \"camera\" or "
	    "\"projection\"" },
	{ &project, "{\"target\":1}",
	    "/target: unknown member; it is \"at\" in \"camera\"" },
	{ &project, "{\"half_width\":1}",
	    "/half_width: unknown member; it belongs in \"projection\": "
	    "{\"type\": \"volume\", ...}" },
	{ &w2d, "{\"width\":1}",
	    "/width: unknown member; it belongs in \"projection\", "
	    "\"viewport\", \"window\" or \"device\"" },
	{ &project, "{\"camera\":{\"near\":1}}",
	    "/camera/near: unknown member; it belongs in \"projection\": "
	    "{\"type\": \"persp\", ...}" },
	{ &w2d, "{\"center\":1}",
	    "/center: unknown member; it belongs in \"window\" or "
	    "\"bounds\"" },
	{ &w2d, "{\"origin\":1}",
	    "/origin: unknown member; it belongs in \"device\" or, of a viewport, in "
	    "\"convention\"; \"webgpu\" is \"gl\" with y from the top, and depth "
	    "from 0" },
	{ &lookat, "{\"j\":1}",
	    "/j: unknown member; there are \"eye\", \"at\", \"gaze\", "
	    "\"orientation\", \"rvec\", \"translation\", \"pose\", \"matrix\", "
	    "\"up\", "
	    "\"roll\" and "
	    "\"orthonormalize\"" },
	{ &project, "{\"qqq\":1}",
	    "/qqq: unknown member; there are \"convention\", \"angle_unit\", "
	    "\"world\", "
	    "\"camera\", \"projection\", \"viewport\", \"window\", \"device\", "
	    "\"points\", \"bounds\", \"pick\" and \"margin\"" },
	{ &project, "{\"projection\":{\"type\":\"ortho\",\"margin\":0.1}}",
	    "/projection/margin: unknown member; it stands beside "
	    "\"projection\"" },
	{ &lookat, "{\"qq~/\\u001b\\u009b\\n\":1}",
	    "/qq~0~1\\u001b\\u009b\\u000a: unknown member; there are \"eye\", "
	    "\"at\", \"gaze\", \"orientation\", \"rvec\", \"translation\", "
	    "\"pose\", "
	    "\"matrix\", \"up\", \"roll\" "
	    "and \"orthonormalize\"" },
	{ &lookat, "{" EYE "," AT "," EYE "}", "/eye: repeated; give it once" },
	{ &project, "{\"camera\":{},\"camera\":{}}",
	    "/camera: repeated; give it once" },
	{ &ortho, "{\"fovy\":1}", "/fovy: unknown member; only \"persp\" has it" },
	{ &persp, "{\"plane\":1}", "/plane: unknown member; only \"oblique\" has it" },
	{ &persp, "{\"size\":1}",
	    "/size: unknown member; give \"width\" and \"height\", of a picture in "
	    "\"viewport\"" },
	{ &persp, "{\"j\":1}",
	    "/j: unknown member; there are \"type\", \"fovy\", \"fovx\", "
	    "\"view_angle\", \"field\", \"width\", \"height\", \"aspect\", "
	    "\"left\", \"right\", \"bottom\", \"top\", \"angles\", "
	    "\"intrinsics\", \"edges_at\", \"near\", \"far\", \"reverse_z\", "
	    "\"near_ratio\" and \"min_near\"" },
};

REFUSES(names)

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_names),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
