/* SPDX-License-Identifier: MIT */
#include "members.h"

#include "convention_member.h"
#include "document.h"
#include "projection_member.h"
#include "types.h"

static const char *const device_origins[] = { "bottom-left", "top-left", NULL };
static const char *const scale_names[] = {
	[SCALE_FILL] = "fill",
	[SCALE_UNIFORM] = "uniform",
	[SCALE_UNIFORM + 1] = NULL,
};
static const char *const depth_names[] = { "buffer", "distance", NULL };
static const char *const adapt_names[] = {
	[ADAPT_STRETCH] = "stretch",
	[ADAPT_GROW] = "grow",
	[ADAPT_SHRINK] = "shrink",
	[ADAPT_SHRINK + 1] = NULL,
};

/* Rows of tables, and their bits. */
enum {
	CAMERA_ROW_EYE,
	CAMERA_ROW_AT,
	CAMERA_ROW_GAZE,
	CAMERA_ROW_ORIENTATION,
	CAMERA_ROW_RVEC,
	CAMERA_ROW_ROTATION,
	CAMERA_ROW_TRANSLATION,
	CAMERA_ROW_POSE,
	CAMERA_ROW_MATRIX,
	CAMERA_ROW_AXES,
	CAMERA_ROW_UP,
	CAMERA_ROW_ROLL,
	CAMERA_ROW_ORTHONORMALIZE,
};

#define CAMERA(row) MEMBER_BIT(CAMERA_ROW_##row)

static const struct member camera_members[] = {
	[CAMERA_ROW_EYE] = ROW(camera, "eye", type_numbers, eye, .n = 3,
	    .aliases = "position location origin look_from eye_position",
	    .unit = "world units", .about = "position of the camera in world space"),
	[CAMERA_ROW_AT] = ROW(camera, "at", type_numbers, at, .n = 3,
	    .aliases = "target look_at focal_point", .unit = "world units",
	    .about = "point in world space at which the camera looks"),
	[CAMERA_ROW_GAZE] = ROW(camera, "gaze", type_numbers, at, .n = 3,
	    .aliases = "forward direction dir",
	    .about = "direction in which the camera looks, of any length"),
	[CAMERA_ROW_ORIENTATION] = ROW(camera, "orientation", type_numbers, orientation,
	    .n = 4, .about = "quaternion x, y, z, w from view axes to world axes"),
	[CAMERA_ROW_RVEC] = ROW(camera, "rvec", type_numbers, rvec, .n = 3,
	    .unit = "radians",
	    .about = "rotation vector that turns world axes into view axes"),
	[CAMERA_ROW_ROTATION] = ROW(camera, "rotation", type_rotation, rotation,
	    .about = "R of [R|t], from world to view axes, rows as in a book"),
	[CAMERA_ROW_TRANSLATION] = ROW(camera, "translation", type_numbers, eye, .n = 3,
	    .unit = "view units",
	    .about = "origin of the world in view space, in place of the eye"),
	[CAMERA_ROW_POSE] = ROW(camera, "pose", type_steps, steps,
	    .about = "map from view to world: a matrix, or steps ('help world')"),
	[CAMERA_ROW_MATRIX] = ROW(camera, "matrix", type_steps, steps,
	    .about = "map from world to view: [R|t], or steps ('help world')"),
	[CAMERA_ROW_AXES] = ROW(camera, "axes", type_axes, axes,
	    .flag = FIELD(camera, has_axes),
	    .about = "where x, y, z of the camera's own frame point: flu, rub, ..."),
	[CAMERA_ROW_UP] = ROW(camera, "up", type_numbers, up, .n = 3,
	    .fallback = "[0, 1, 0]", .aliases = "view_up up_vector vup", .shown = true,
	    .about = "direction that points up in the image"),
	[CAMERA_ROW_ROLL] = ROW(camera, "roll", type_numbers, roll, .range = &range_any,
	    .unit = "degrees", .fallback = "0",
	    .about = "angle by which the image is turned counterclockwise"),
	[CAMERA_ROW_ORTHONORMALIZE] = ROW(camera, "orthonormalize", type_flag,
	    orthonormalize, .fallback = "false",
	    .about = "replace the matrix's 3x3 part by the nearest rotation"),
	{ .name = NULL },
};

/* A turned camera may have axes, and a roll unless all of its matrix is given. */
#define TURNED(members, way, ...) \
	WAY(members, .optional = CAMERA(AXES) | CAMERA(ROLL), .value = way, __VA_ARGS__)
#define GIVEN(members, more, way, ...)                                           \
	WAY(members, .optional = CAMERA(AXES) | CAMERA(ORTHONORMALIZE) | (more), \
	    .value = way, __VA_ARGS__)

static const struct rule camera_rules[] = {
	{ WAYS(WAY(CAMERA(EYE) | CAMERA(AT), .optional = CAMERA(UP) | CAMERA(ROLL),
		   .value = CAMERA_AT),
	      WAY(CAMERA(EYE) | CAMERA(GAZE), .optional = CAMERA(UP) | CAMERA(ROLL),
		  .fitted = CAMERA(EYE), .value = CAMERA_GAZE),
	      TURNED(CAMERA(EYE) | CAMERA(ORIENTATION), CAMERA_ORIENTATION,
		  .fitted = CAMERA(EYE)),
	      TURNED(CAMERA(EYE) | CAMERA(RVEC), CAMERA_RVEC, .fitted = CAMERA(EYE)),
	      GIVEN(CAMERA(EYE) | CAMERA(ROTATION), CAMERA(ROLL), CAMERA_ROTATION,
		  .fitted = CAMERA(EYE)),
	      TURNED(CAMERA(TRANSLATION) | CAMERA(ORIENTATION), CAMERA_TRANSLATION, ),
	      TURNED(CAMERA(TRANSLATION) | CAMERA(RVEC), CAMERA_RVEC_TRANSLATION, ),
	      GIVEN(CAMERA(TRANSLATION) | CAMERA(ROTATION), CAMERA(ROLL),
		  CAMERA_ROTATION_TRANSLATION, ),
	      GIVEN(CAMERA(POSE), 0, CAMERA_POSE, ),
	      GIVEN(CAMERA(MATRIX), 0, CAMERA_MATRIX, )),
	    .field = FIELD(camera, way) },
	{ .n = 0 },
};

#define SIZE(object, label, field, ...) \
	ROW(object, label, type_numbers, field, .range = &range_positive, __VA_ARGS__)

static const struct value_range height_range = { SCENE_SIZE_MIN, SCENE_MAGNITUDE_MAX,
	.wanted = "a number from 1e-150 to 1e150 is wanted; for a flipped viewport of "
		  "Vulkan write \"webgpu\", y + height for y, and -height for height" };

/* The first rows of the tables of viewport and device. */
enum {
	RECTANGLE_ROW_X,
	RECTANGLE_ROW_Y,
	RECTANGLE_ROW_WIDTH,
	RECTANGLE_ROW_HEIGHT,
	RECTANGLE_ROWS,
};

#define RECTANGLE(object)                                                             \
	[RECTANGLE_ROW_X] = ROW(object, "x", type_numbers, x, .unit = "device units", \
	    .fallback = "0", .shown = true,                                           \
	    .about = "least device x of the rectangle"),                              \
	[RECTANGLE_ROW_Y] = ROW(object, "y", type_numbers, y, .unit = "device units", \
	    .fallback = "0", .shown = true,                                           \
	    .about = "least device y of the rectangle"),                              \
	[RECTANGLE_ROW_WIDTH] = SIZE(object, "width", width, .unit = "device units",  \
	    .about = "width of the rectangle, required"),                             \
	[RECTANGLE_ROW_HEIGHT] = ROW(object, "height", type_numbers, height,          \
	    .range = &height_range, .unit = "device units",                           \
	    .about = "height of the rectangle, required")

/* "scale" in JSON sets the fields `scale` and `scales` of struct viewport. */
enum {
	TO_SCALES = offsetof(struct viewport, scales) - offsetof(struct viewport, scale)
};

static bool read_scale(const struct value *v, const struct member *row, void *out)
{
	unsigned *by = out;
	double *const scales = (void *)((char *)out + TO_SCALES);

	/* one that is refused is the default, so that intrinsics do not exclude it */
	*by = SCALE_FILL;
	if (value_string(v) != NULL)
		return value_word(v, row->words, NULL, by);
	if (!value_is(v, JSON_ARRAY))
		return value_refuse_type(v, "\"fill\", \"uniform\" or 2 numbers");
	if (!value_numbers(v, &range_positive, 2, scales))
		return false;
	*by = SCALE_GIVEN;
	return true;
}

static void print_scale(struct printer *p, const struct member *row, const void *at)
{
	const unsigned by = *(const unsigned *)at;

	if (by == SCALE_GIVEN)
		put_numbers(p, (const void *)((const char *)at + TO_SCALES), 2);
	else
		put_string(p, row->words[by]);
}

static const struct member_type type_scale = { .name = "fill, uniform or 2 sizes",
	.read = read_scale,
	.print = print_scale,
	.number_size = sizeof(unsigned) };

enum {
	VIEWPORT_ROW_MIN_Z = RECTANGLE_ROWS,
	VIEWPORT_ROW_MAX_Z,
	VIEWPORT_ROW_FULL,
	VIEWPORT_ROW_OFFSET,
	VIEWPORT_ROW_SCALE,
	VIEWPORT_ROW_DEPTH,
};

static const struct member viewport_members[] = {
	RECTANGLE(viewport),
	[VIEWPORT_ROW_MIN_Z] = ROW(viewport, "min_z", type_numbers, min_z,
	    .unit = "device units", .fallback = "0",
	    .about = "device z of the least depth in ndc"),
	[VIEWPORT_ROW_MAX_Z] = ROW(viewport, "max_z", type_numbers, max_z,
	    .unit = "device units", .fallback = "1",
	    .about = "device z of the greatest depth in ndc"),
	[VIEWPORT_ROW_FULL] = ROW(viewport, "full", type_numbers, full, .n = 2,
	    .flag = FIELD(viewport, has_full), .range = &range_positive,
	    .unit = "device units",
	    .about = "size of the whole picture, of which this is a part"),
	[VIEWPORT_ROW_OFFSET] = ROW(viewport, "offset", type_numbers, offset, .n = 2,
	    .flag = FIELD(viewport, has_offset), .unit = "device units",
	    .about = "where the part begins in the whole picture"),
	[VIEWPORT_ROW_SCALE] = ROW(viewport, "scale", type_scale, scale,
	    .words = scale_names, .fallback = "\"fill\"",
	    .about = "device units (pixels) for one unit of ndc x and y"),
	[VIEWPORT_ROW_DEPTH] = ROW(viewport, "depth", type_flag, distance,
	    .words = depth_names, .fallback = "\"buffer\"",
	    .about = "device z: the depth, or the distance along the gaze"),
	{ .name = NULL },
};

static const struct member device_members[] = {
	RECTANGLE(device),
	[RECTANGLE_ROWS] = ROW(device, "origin", type_flag, top_left,
	    .words = device_origins, .fallback = "\"bottom-left\"", .shown = true,
	    .default_from = "-c's or the convention's",
	    .about = "corner of the device where x and y are least"),
	{ .name = NULL },
};

#define RECTANGLE_WAY \
	WAY(MEMBER_BIT(RECTANGLE_ROW_WIDTH) | MEMBER_BIT(RECTANGLE_ROW_HEIGHT))

static const struct rule device_rules[] = { { WAYS(RECTANGLE_WAY) }, { .n = 0 } };

static const struct rule viewport_rules[] = {
	{ WAYS(RECTANGLE_WAY) },
	{ WAYS(WAY(0, .optional = MEMBER_BIT(VIEWPORT_ROW_SCALE)),
	      WAY(0,
		  .optional = MEMBER_BIT(VIEWPORT_ROW_FULL) |
		      MEMBER_BIT(VIEWPORT_ROW_OFFSET))),
	    .rivals = "a part fills its viewport" },
	{ .n = 0 },
};

enum {
	WINDOW_ROW_CENTER,
	WINDOW_ROW_WIDTH,
	WINDOW_ROW_HEIGHT,
	WINDOW_ROW_LEFT,
	WINDOW_ROW_RIGHT,
	WINDOW_ROW_BOTTOM,
	WINDOW_ROW_TOP,
	WINDOW_ROW_Y,
	WINDOW_ROW_PAN,
	WINDOW_ROW_ZOOM,
	WINDOW_ROW_ABOUT,
	WINDOW_ROW_ADAPT,
};

#define WINDOW(row) MEMBER_BIT(WINDOW_ROW_##row)

static const struct member window_members[] = {
	[WINDOW_ROW_CENTER] = ROW(window, "center", type_numbers, center, .n = 2,
	    .unit = "window units",
	    .about = "centre of the window, with width and height"),
	[WINDOW_ROW_WIDTH] = SIZE(window, "width", width, .unit = "window units",
	    .about = "width of the window"),
	[WINDOW_ROW_HEIGHT] = SIZE(window, "height", height, .unit = "window units",
	    .about = "height of the window"),
	[WINDOW_ROW_LEFT] = ROW(window, "left", type_numbers, left,
	    .unit = "window units", .flag = FIELD(window, has_edge[0]),
	    .about = "left edge of the window, with right, bottom and top"),
	[WINDOW_ROW_RIGHT] = ROW(window, "right", type_numbers, right,
	    .unit = "window units", .flag = FIELD(window, has_edge[1]),
	    .about = "right edge of the window, other than left"),
	[WINDOW_ROW_BOTTOM] = ROW(window, "bottom", type_numbers, bottom,
	    .unit = "window units", .flag = FIELD(window, has_edge[2]),
	    .about = "bottom edge of the window"),
	[WINDOW_ROW_TOP] = ROW(window, "top", type_numbers, top, .unit = "window units",
	    .flag = FIELD(window, has_edge[3]),
	    .about = "top edge of the window, other than bottom"),
	[WINDOW_ROW_Y] = ROW(window, "y", type_flag, y_down, .words = y_names,
	    .fallback = "\"up\"", .about = "direction of the world's y in the picture"),
	[WINDOW_ROW_PAN] = ROW(window, "pan", type_numbers, pan, .n = 2,
	    .unit = "window units", .fallback = "[0, 0]",
	    .about = "distance that the window moves along x and y"),
	[WINDOW_ROW_ZOOM] = SIZE(window, "zoom", zoom, .fallback = "1",
	    .about = "factor of magnification; 2 shows half the extent"),
	[WINDOW_ROW_ABOUT] = ROW(window, "about", type_numbers, about, .n = 2,
	    .flag = FIELD(window, has_about), .unit = "window units",
	    .about = "point that zoom does not move; if absent, the centre"),
	[WINDOW_ROW_ADAPT] = ROW(window, "adapt", type_word, adapt,
	    .words = adapt_names, .fallback = "\"stretch\"",
	    .about = "if the device's shape differs: distort, show more, less"),
	{ .name = NULL },
};

/* The values are those of window.by_edges. */
static const struct rule window_rules[] = {
	{ WAYS(WAY(WINDOW(CENTER) | WINDOW(WIDTH) | WINDOW(HEIGHT),
		   .optional = WINDOW(Y),
		   .fitted = WINDOW(CENTER) | WINDOW(WIDTH) | WINDOW(HEIGHT),
		   .value = 0),
	      WAY(WINDOW(LEFT) | WINDOW(RIGHT) | WINDOW(BOTTOM) | WINDOW(TOP),
		  .fitted = WINDOW(LEFT) | WINDOW(RIGHT) | WINDOW(BOTTOM) | WINDOW(TOP),
		  .value = 1)),
	    .field = FIELD(window, by_edges) },
	{ .n = 0 },
};

/* Reads a point: three numbers, two in a flat document, either if it is not used. */
static bool read_bounds_point(const struct value *v, const struct member *row,
    void *out)
{
	const bool two = v->unused ? value_count(v) == 2 : v->source->flat;

	(void)row;
	return value_numbers(v, &range_any, two ? 2 : 3, out);
}

static const struct member_type type_bounds_point = { "3 numbers, or 2 of a window",
	read_bounds_point, NULL, .doubles = 3 };

enum { BOUNDS_ROW_CENTER, BOUNDS_ROW_RADIUS, BOUNDS_ROW_MIN, BOUNDS_ROW_MAX };

#define POINT(label, field, text)                                           \
	ROW(bounds, label, type_bounds_point, field, .unit = "model units", \
	    .about = text)

static const struct member bounds_members[] = {
	[BOUNDS_ROW_CENTER] = POINT("center", center, "centre of the sphere"),
	[BOUNDS_ROW_RADIUS] = SIZE(bounds, "radius", radius, .unit = "model units",
	    .about = "radius of the sphere"),
	[BOUNDS_ROW_MIN] = POINT("min", min, "least x, y and z of the box"),
	[BOUNDS_ROW_MAX] = POINT("max", max, "greatest x, y and z of the box"),
	{ .name = NULL },
};

/* The values are those of bounds.sphere. */
static const struct rule bounds_rules[] = {
	{ WAYS(WAY(MEMBER_BIT(BOUNDS_ROW_MIN) | MEMBER_BIT(BOUNDS_ROW_MAX), .value = 0),
	      WAY(MEMBER_BIT(BOUNDS_ROW_CENTER) | MEMBER_BIT(BOUNDS_ROW_RADIUS),
		  .value = 1)),
	    .field = FIELD(bounds, sphere) },
	{ .n = 0 },
};

static const struct member pick_members[] = {
	ROW(pick, "at", type_numbers, at, .n = 2, .flag = FIELD(pick, has_at),
	    .unit = "device units", .about = "centre of the circle to search"),
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
	[SCENE_ROW_CONVENTION] = ROW(document, "convention", type_convention,
	    scene.convention, .members = convention_members, .example = "\"d3d\"",
	    .words = convention_names, .word_aliases = convention_aliases,
	    .fallback = "\"d3d\"", .shown = true, .default_from = "-c's",
	    .about = "convention of the scene's axes, depths and matrices",
	    .command = "lookat '{\"convention\": \"gl\", \"camera\": " CAMERA_EXAMPLE
		       "}'"),
	[SCENE_ROW_ANGLE_UNIT] = ROW(document, "angle_unit", type_word, source.unit,
	    .words = angle_unit_names, .in_any_document = true,
	    .fallback = "\"degrees\"", .about = "unit of all angles of the scene",
	    .command =
		"persp -c d3d '{\"angle_unit\": \"radians\", \"fovy\": 1, \"aspect\": "
		"1.5, \"near\": 1, \"far\": 10}'"),
	[SCENE_ROW_WORLD] = ROW(document, "world", type_steps, scene.world,
	    .flag = FIELD(document, scene.has_world), .members = step_members,
	    .rules = step_rules, .example = "[{\"translate\": [1,2,3]}]",
	    .fallback = WORLD_EXAMPLE,
	    .about = "map from model to world space: a matrix or steps",
	    .command = "project --to world '{\"world\": [1,0,0,0, 0,1,0,0, 0,0,1,0, "
		       "10,20,30,1]}' '[1,2,3]'"),
	[SCENE_ROW_CAMERA] = SCENE_OBJECT("camera", camera, camera_members,
	    CAMERA_EXAMPLE, .rules = camera_rules,
	    .about = "where the camera stands (map from world to view space)",
	    .command = "lookat -c d3d '{\"camera\": " CAMERA_EXAMPLE "}'"),
	[SCENE_ROW_PROJECTION] = ROW(document, "projection", type_projection,
	    scene.projection, .members = projection_members, .rules = projection_rules,
	    .example = PERSP_EXAMPLE,
	    .about = "how the camera projects (map from view to clip space)",
	    .command = "persp -c d3d '{\"projection\": " PERSP_EXAMPLE "}'"),
	[SCENE_ROW_VIEWPORT] = SCENE_OBJECT("viewport", viewport, viewport_members,
	    RECTANGLE_EXAMPLE, .rules = viewport_rules,
	    .about = "rectangle on the screen that shows the camera's image",
	    .command = "project --from ndc -c d3d '{\"viewport\": " RECTANGLE_EXAMPLE
		       "}' '[0,0.5,1]'"),
	[SCENE_ROW_WINDOW] = SCENE_OBJECT("window", window, window_members,
	    WINDOW_EXAMPLE, .rules = window_rules,
	    .about = "rectangle of a 2D world that a device shows",
	    .command = "w2n '{\"window\": " WINDOW_EXAMPLE "}'"),
	[SCENE_ROW_DEVICE] = SCENE_OBJECT("device", device, device_members,
	    RECTANGLE_EXAMPLE, .rules = device_rules,
	    .about = "rectangle on the screen that shows a 2D window",
	    .command = "n2d '{\"device\": " RECTANGLE_EXAMPLE "}'"),
	[SCENE_ROW_POINTS] = ROW(document, "points", type_points, points,
	    .example = "[[0,0,0], [1,1,1]]",
	    .about = "points to read if the command line has no POINTS",
	    .command = "lookat -c d3d '{\"camera\": " CAMERA_EXAMPLE
		       ", \"points\": [[0,0,0], [1,1,1]]}'"),
	[SCENE_ROW_BOUNDS] = ROW(document, "bounds", type_object, bounds,
	    .flag = FIELD(document, has_bounds), .members = bounds_members,
	    .rules = bounds_rules, .example = BOUNDS_EXAMPLE, .unit = "model units",
	    .about = "volume that fit puts into the picture, and inspect finds there",
	    .command = "fit -c d3d '{\"projection\": {\"type\": \"ortho\"}, "
		       "\"bounds\": " BOUNDS_EXAMPLE "}'"),
	[SCENE_ROW_PICK] = ROW(document, "pick", type_object, pick,
	    .flag = FIELD(document, has_pick), .members = pick_members,
	    .example = PICK_EXAMPLE,
	    .about = "circle in which pick finds points; or --at, --radius",
	    .command = "pick -c d3d '{\"camera\": " CAMERA_EXAMPLE
		       ", \"projection\": " PERSP_EXAMPLE
		       ", \"viewport\": " RECTANGLE_EXAMPLE ", \"pick\": " PICK_EXAMPLE
		       "}' '[[0,0,0], [1,1,1]]'"),
	[SCENE_ROW_MARGIN] = ROW(document, "margin", type_numbers, scene.margin,
	    .example = "0.1", .range = &margin_range, .fallback = "0",
	    .about = "share of the picture that fit leaves free at each side",
	    .command = "fit -c d3d '{\"projection\": {\"type\": \"ortho\"}, "
		       "\"bounds\": " BOUNDS_EXAMPLE ", \"margin\": 0.1}'"),
	{ .name = NULL },
};
