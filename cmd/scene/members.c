/* SPDX-License-Identifier: MIT */
#include "members.h"

#include "convention_member.h"
#include "document.h"
#include "projection_member.h"
#include "types.h"

static const char *const device_origins[] = { "bottom-left", "top-left", NULL };
static const char *const scale_names[] = { "fill", "uniform", NULL };
static const char *const depth_names[] = { "buffer", "distance", NULL };
static const char *const adapt_names[] = { "stretch", "grow", "shrink", NULL };

static const struct member camera_members[] = {
	ROW(camera, "eye", type_numbers, eye, .n = 3,
	    .aliases = "position pos from origin location c cop eyepoint viewpoint",
	    .unit = "world units", .about = "position of the camera in world space"),
	ROW(camera, "at", type_numbers, at, .n = 3,
	    .aliases = "target center centre lookat to", .unit = "world units",
	    .about = "point in world space at which the camera looks"),
	ROW(camera, "gaze", type_numbers, at, .n = 3,
	    .aliases = "direction dir forward",
	    .about = "direction in which the camera looks, of any length"),
	ROW(camera, "orientation", type_numbers, orientation, .n = 4,
	    .aliases = "rotation rotationquaternion quaternion quat q",
	    .hint =
		" (x, y, z, w, view to world, beside \"eye\"; with a translation it is "
		"\"pose\", world to view \"matrix\", as [{\"quaternion_wxyz\": q}, "
		"{\"translate\": t}]; a 3x3 R is in \"matrix\", Euler angles are steps "
		"in \"pose\")",
	    .about = "quaternion x, y, z, w from view axes to world axes"),
	ROW(camera, "rvec", type_numbers, rvec, .n = 3,
	    .aliases = "rotationvector rodrigues",
	    .hint = " (world to view, its length the angle)", .unit = "radians",
	    .about = "rotation vector that turns world axes into view axes"),
	ROW(camera, "translation", type_numbers, eye, .n = 3,
	    .aliases = "tvec t translationvector",
	    .hint = " (t of world to view; beside R write \"matrix\": [R|t])",
	    .unit = "view units",
	    .about = "origin of the world in view space, in place of the eye"),
	ROW(camera, "pose", type_steps, steps,
	    .aliases = "transformmatrix transform matrixworld cameratoworld camtoworld "
		       "c2w twc cam2world localtoworldmatrix",
	    .hint = " (view to world; of NeRF, Blender and ARKit with \"convention\": "
		    "\"webgpu\")",
	    .about = "map from view to world: a matrix, or steps ('help world')"),
	ROW(camera, "matrix", type_steps, steps,
	    .aliases = "view viewmatrix extrinsic extrinsics r rt rotationmatrix "
		       "worldtocamera worldtocameramatrix worldtocam w2c tcw world2cam "
		       "modelviewmatrix matrixworldinverse",
	    .hint = " (world to view, [R|t])",
	    .about = "map from world to view: [R|t], or steps ('help world')"),
	ROW(camera, "up", type_numbers, up, .n = 3, .fallback = "[0, 1, 0]",
	    .aliases = "vup viewup upvector", .shown = true,
	    .about = "direction that points up in the image"),
	ROW(camera, "roll", type_numbers, roll, .range = &range_any, .unit = "degrees",
	    .fallback = "0",
	    .about = "angle by which the image is turned counterclockwise"),
	ROW(camera, "orthonormalize", type_flag, orthonormalize, .fallback = "false",
	    .about = "replace the matrix's 3x3 part by the nearest rotation"),
	{ .name = NULL },
};

/* in the order of the enum that is the type of camera.way */
static const struct rule camera_rules[] = {
	{ .ways = WAYS("eye at up? roll?", "eye~ gaze up? roll?",
	      "eye~ orientation roll?", "eye~ rvec roll?",
	      "translation orientation roll?", "translation rvec roll?",
	      "pose orthonormalize?", "matrix orthonormalize?"),
	    .field = FIELD(camera, way) },
	{ .ways = NULL },
};

#define SIZE(object, label, field, ...) \
	ROW(object, label, type_numbers, field, .range = &range_positive, __VA_ARGS__)

static const struct value_range height_range = { SCENE_SIZE_MIN, SCENE_MAGNITUDE_MAX,
	.wanted = "a number from 1e-150 to 1e150 is wanted; for a flipped viewport of "
		  "Vulkan write \"webgpu\", y + height for y, and -height for height" };

#define RECTANGLE(object)                                                       \
	ROW(object, "x", type_numbers, x, .aliases = "left xmin",               \
	    .unit = "device units", .fallback = "0", .shown = true,             \
	    .about = "least device x of the rectangle"),                        \
	    ROW(object, "y", type_numbers, y, .aliases = "top bottom ymin",     \
		.unit = "device units", .fallback = "0", .shown = true,         \
		.about = "least device y of the rectangle"),                    \
	    SIZE(object, "width", width, .unit = "device units",                \
		.aliases = "w imagewidth pixelwidth",                           \
		.about = "width of the rectangle, required"),                   \
	    ROW(object, "height", type_numbers, height, .range = &height_range, \
		.aliases = "h imageheight pixelheight", .unit = "device units", \
		.about = "height of the rectangle, required")

/* "scale" in JSON sets the fields `scale` and `scales` of struct viewport. */
enum {
	TO_SCALES = offsetof(struct viewport, scales) - offsetof(struct viewport, scale)
};

static void read_scale(const struct value *v, const struct member *row, void *out)
{
	unsigned *by = out;

	*by = SCALE_GIVEN;
	if (value_is(v, JSON_ARRAY))
		value_numbers(v, &range_positive, 2, "",
		    (double *)(void *)((char *)out + TO_SCALES));
	else if (value_string(v) == NULL)
		value_refuse_type(v, "\"fill\", \"uniform\" or 2 numbers");
	else
		*by = (unsigned)value_word(v, row->words);
}

static void print_scale(struct printer *p, const struct member *row, const void *at)
{
	const unsigned by = *(const unsigned *)at;

	if (by == SCALE_GIVEN)
		put_numbers(p, (const void *)((const char *)at + TO_SCALES), 2);
	else
		put_string(p, row->words[by]);
}

static const struct member_type type_scale = { "fill, uniform or 2 sizes", read_scale,
	print_scale, sizeof(unsigned) };

static const struct member viewport_members[] = {
	RECTANGLE(viewport),
	ROW(viewport, "min_z", type_numbers, min_z, .aliases = "mindepth zmin",
	    .unit = "device units", .fallback = "0",
	    .about = "device z of the least depth in ndc"),
	ROW(viewport, "max_z", type_numbers, max_z, .aliases = "maxdepth zmax",
	    .unit = "device units", .fallback = "1",
	    .about = "device z of the greatest depth in ndc"),
	ROW(viewport, "scale", type_scale, scale, .words = scale_names,
	    .fallback = "\"fill\"",
	    .about = "device units (pixels) for one unit of ndc x and y"),
	ROW(viewport, "depth", type_flag, distance, .words = depth_names,
	    .fallback = "\"buffer\"",
	    .about = "device z: the depth, or the distance along the gaze"),
	{ .name = NULL },
};

static const struct member device_members[] = {
	RECTANGLE(device),
	ROW(device, "origin", type_flag, top_left, .words = device_origins,
	    .fallback = "\"bottom-left\"", .shown = true,
	    .default_from = "-c's or the convention's",
	    .about = "corner of the device where x and y are least"),
	{ .name = NULL },
};

static const struct rule rectangle_rules[] = {
	{ .ways = WAYS("width height") },
	{ .ways = NULL },
};

static const struct member window_members[] = {
	ROW(window, "center", type_numbers, center, .n = 2,
	    .aliases = "centre position", .unit = "window units",
	    .about = "centre of the window, with width and height"),
	SIZE(window, "width", width, .unit = "window units",
	    .about = "width of the window"),
	SIZE(window, "height", height, .unit = "window units",
	    .about = "height of the window"),
	ROW(window, "left", type_numbers, left,
	    .aliases = "x xmin min viewbox bbox extent",
	    .hint = ", with \"right\", \"bottom\" and \"top\"", .unit = "window units",
	    .about = "left edge of the window, with right, bottom and top"),
	ROW(window, "right", type_numbers, right, .aliases = "xmax max",
	    .unit = "window units",
	    .about = "right edge of the window, greater than left"),
	ROW(window, "bottom", type_numbers, bottom, .aliases = "y ymin",
	    .unit = "window units", .about = "bottom edge of the window"),
	ROW(window, "top", type_numbers, top, .aliases = "ymax", .unit = "window units",
	    .about = "top edge of the window, greater than bottom"),
	ROW(window, "pan", type_numbers, pan, .n = 2, .unit = "window units",
	    .fallback = "[0, 0]",
	    .about = "distance that the window moves along x and y"),
	SIZE(window, "zoom", zoom, .aliases = "scale", .fallback = "1",
	    .about = "factor of magnification; 2 shows half the extent"),
	ROW(window, "about", type_numbers, about, .n = 2,
	    .flag = FIELD(window, has_about), .aliases = "at anchor",
	    .unit = "window units",
	    .about = "point that zoom does not move; if absent, the centre"),
	ROW(window, "adapt", type_word, adapt, .words = adapt_names,
	    .aliases = "fit objectfit preserveaspectratio", .fallback = "\"stretch\"",
	    .about = "if the device's shape differs: distort, show more, less"),
	{ .name = NULL },
};

static const struct rule window_rules[] = {
	{ .ways = WAYS("center~ width~ height~", "left~ right~ bottom~ top~"),
	    .field = FIELD(window, by_edges) },
	{ .ways = NULL },
};

/* Reads a point: three numbers, two in a flat document, either if it is not used. */
static void read_bounds_point(const struct value *v, const struct member *row,
    void *out)
{
	const bool two = v->unused ? value_count(v) == 2 : v->source->flat;

	(void)row;
	value_numbers(v, &range_any, two ? 2 : 3, "", out);
}

static const struct member_type type_bounds_point = { "3 numbers, or 2 of a window",
	read_bounds_point, NULL, 0 };

#define POINT(label, field, alias, text)                               \
	ROW(bounds, label, type_bounds_point, field, .aliases = alias, \
	    .unit = "model units", .about = text)

static const struct member bounds_members[] = {
	POINT("center", center, "centre position", "centre of the sphere"),
	SIZE(bounds, "radius", radius, .aliases = "r", .unit = "model units",
	    .about = "radius of the sphere"),
	POINT("min", min, "lower from", "least x, y and z of the box"),
	POINT("max", max, "upper to", "greatest x, y and z of the box"),
	{ .name = NULL },
};

static const struct rule bounds_rules[] = {
	{ .ways = WAYS("min max", "center radius"), .field = FIELD(bounds, sphere) },
	{ .ways = NULL },
};

static const struct member pick_members[] = {
	ROW(pick, "at", type_numbers, at, .n = 2, .flag = FIELD(pick, has_at),
	    .aliases = "position center", .unit = "device units",
	    .about = "centre of the circle to search"),
	SIZE(pick, "radius", radius, .unit = "device units",
	    .about = "radius of the circle to search"),
	{ .name = NULL },
};

#define WORLD_EXAMPLE "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]"
#define BOUNDS_EXAMPLE "{\"min\": [-1,-1,-1], \"max\": [1,1,1]}"

static const struct value_range margin_range = { .min = 0,
	.max = 0.5,
	.wanted = "a number from 0 to below 0.5 is wanted",
	.max_excluded = true };

/* The row of a member that is an object. It is read to the field `field` of struct
 * scene, and sets the bool there whose name is has_ and `field`. */
#define SCENE_OBJECT(label, field, table, sample, ...)                    \
	ROW(document, label, type_object, scene.field, .example = sample, \
	    .flag = FIELD(document, scene.has_##field), .members = table, __VA_ARGS__)

const struct member scene_members[] = {
	ROW(document, "convention", type_convention, scene.convention,
	    .members = convention_members, .example = "\"d3d\"",
	    .aliases = "d3d gl vulkan webgpu opencv", .words = convention_names,
	    .fallback = "\"d3d\"", .shown = true, .default_from = "-c's",
	    .about = "convention of the scene's axes, depths and matrices",
	    .command = "lookat '{\"convention\": \"gl\", \"camera\": " CAMERA_EXAMPLE
		       "}'"),
	ROW(document, "angle_unit", type_word, source.unit,
	    .aliases = "angleunits unit units angles radians degrees",
	    .words = angle_unit_names, .in_any_document = true,
	    .fallback = "\"degrees\"", .about = "unit of all angles of the scene",
	    .command = "persp '{\"angle_unit\": \"radians\", \"fovy\": 1, \"aspect\": "
		       "1.5, \"near\": 1, \"far\": 10}'"),
	ROW(document, "world", type_steps, scene.world, .aliases = "model modelmatrix",
	    .flag = FIELD(document, scene.has_world), .members = step_members,
	    .rules = step_rules, .example = "[{\"translate\": [1,2,3]}]",
	    .fallback = WORLD_EXAMPLE,
	    .about = "map from model to world space: a matrix or steps",
	    .command = "project --to world '{\"world\": [1,0,0,0, 0,1,0,0, 0,0,1,0, "
		       "10,20,30,1]}' '[1,2,3]'"),
	SCENE_OBJECT("camera", camera, camera_members, CAMERA_EXAMPLE,
	    .rules = camera_rules, .aliases = "view",
	    .hint = ", for a matrix {\"matrix\": [...]} (world to view) or "
		    "{\"pose\": [...]} (view to world)",
	    .about = "where the camera stands (map from world to view space)",
	    .command = "lookat '{\"camera\": " CAMERA_EXAMPLE "}'"),
	ROW(document, "projection", type_projection, scene.projection,
	    .members = projection_members, .aliases = "lens perspective proj",
	    .hint = ", such as " PERSP_EXAMPLE
		    " or {\"type\": \"matrix\", \"matrix\": [...]}",
	    .rules = projection_rules, .example = PERSP_EXAMPLE,
	    .about = "how the camera projects (map from view to clip space)",
	    .command = "persp '{\"projection\": " PERSP_EXAMPLE "}'"),
	SCENE_OBJECT("viewport", viewport, viewport_members, RECTANGLE_EXAMPLE,
	    .rules = rectangle_rules, .aliases = "screen image",
	    .about = "rectangle on the screen that shows the camera's image",
	    .command = "project --from ndc '{\"viewport\": " RECTANGLE_EXAMPLE
		       "}' '[0,0.5,1]'"),
	SCENE_OBJECT("window", window, window_members, WINDOW_EXAMPLE,
	    .rules = window_rules, .aliases = "viewbox",
	    .about = "rectangle of a 2D world that a device shows",
	    .command = "w2n '{\"window\": " WINDOW_EXAMPLE "}'"),
	SCENE_OBJECT("device", device, device_members, RECTANGLE_EXAMPLE,
	    .rules = rectangle_rules,
	    .about = "rectangle on the screen that shows a 2D window",
	    .command = "n2d '{\"device\": " RECTANGLE_EXAMPLE "}'"),
	ROW(document, "points", type_points, points, .aliases = "point",
	    .example = "[[0,0,0], [1,1,1]]",
	    .about = "points to read if the command line has no POINTS",
	    .command = "lookat '{\"camera\": " CAMERA_EXAMPLE
		       ", \"points\": [[0,0,0], [1,1,1]]}'"),
	ROW(document, "bounds", type_object, bounds,
	    .flag = FIELD(document, has_bounds),
	    .aliases = "extent bbox boundingbox aabb", .members = bounds_members,
	    .rules = bounds_rules, .example = BOUNDS_EXAMPLE, .unit = "model units",
	    .about = "volume that fit puts into the picture, and inspect finds there",
	    .command = "fit '{\"projection\": {\"type\": \"ortho\"}, "
		       "\"bounds\": " BOUNDS_EXAMPLE "}'"),
	ROW(document, "pick", type_object, pick, .flag = FIELD(document, has_pick),
	    .members = pick_members, .example = PICK_EXAMPLE,
	    .about = "circle in which pick finds points; or --at, --radius",
	    .command = "pick '{\"camera\": " CAMERA_EXAMPLE
		       ", \"projection\": " PERSP_EXAMPLE
		       ", \"viewport\": " RECTANGLE_EXAMPLE ", \"pick\": " PICK_EXAMPLE
		       "}' '[[0,0,0], [1,1,1]]'"),
	ROW(document, "margin", type_numbers, scene.margin, .aliases = "padding border",
	    .example = "0.1", .range = &margin_range, .fallback = "0",
	    .about = "share of the picture that fit leaves free at each side",
	    .command = "fit '{\"projection\": {\"type\": \"ortho\"}, "
		       "\"bounds\": " BOUNDS_EXAMPLE ", \"margin\": 0.1}'"),
	{ .name = NULL },
};
