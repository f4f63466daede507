/* SPDX-License-Identifier: MIT */
#include "members.h"

static const char *const origins[] = { "bottom-left", "top-left", NULL };
static const char *const scales[] = { "fill", "uniform", NULL };
const char *const adapt_names[] = { "stretch", "grow", "shrink", NULL };

#define MEMBER(type, member) offsetof(struct type, member)

#define NUMBERS(label, type, m, count, ...)                                 \
	{                                                                   \
		.name = label, .read = read_numbers, .at = MEMBER(type, m), \
		.n = count, __VA_ARGS__                                     \
	}

const struct member camera_members[] = {
	NUMBERS("eye", camera, eye, 3, .aliases = "position pos from origin",
	    .unit = "world units", .about = "where the camera stands"),
	NUMBERS("at", camera, at, 3, .aliases = "target center centre lookat",
	    .unit = "world units", .about = "the point that it looks at"),
	NUMBERS("gaze", camera, at, 3, .aliases = "direction dir forward",
	    .about = "the direction in which it looks"),
	NUMBERS("orientation", camera, orientation, 4,
	    .aliases = "rotation quaternion quat qvec",
	    .note = "x, y, z, w from view to world axes; of w, x, y, z from "
		    "world to view that is -x, -y, -z, w",
	    .about = "quaternion x, y, z, w: view to world axes"),
	NUMBERS("translation", camera, eye, 3, .aliases = "tvec t",
	    .note = "where the world's origin is in view space",
	    .unit = "view units", .about = "where the world's origin is"),
	{ .name = "pose",
	    .read = read_affine,
	    .at = MEMBER(camera, matrix),
	    .aliases = "transformmatrix transform matrixworld cameratoworld "
		       "camtoworld c2w",
	    .note = "view to world",
	    .type = "matrix",
	    .about = "view to world" },
	{ .name = "matrix",
	    .read = read_affine,
	    .at = MEMBER(camera, matrix),
	    .aliases = "view viewmatrix extrinsic extrinsics r rt rvec "
		       "rotationmatrix worldtocamera worldtocam w2c",
	    .note = "world to view, [R|t]",
	    .type = "matrix",
	    .about = "world to view, [R|t]" },
	NUMBERS("up", camera, up, 3, .otherwise = "[0, 1, 0]",
	    .about = "it points up in the image"),
	NUMBERS("roll", camera, roll, 0, .type = "angle", .unit = "degrees",
	    .otherwise = "0", .about = "counterclockwise"),
	{ .name = "orthonormalize",
	    .read = read_flag,
	    .at = MEMBER(camera, orthonormalize),
	    .type = "true or false",
	    .otherwise = "false",
	    .about = "to the nearest rotation" },
	{ .name = NULL },
};

/* In the order of the values of struct camera's by. */
static const struct ways camera_ways = {
	"give \"eye\" and one of \"at\", \"gaze\" and \"orientation\", or "
	"\"translation\" and \"orientation\", or \"pose\" or \"matrix\" alone",
	{ "eye at up? roll?", "eye gaze up? roll?", "eye orientation roll?",
	    "translation orientation roll?", "pose orthonormalize?",
	    "matrix orthonormalize?" },
};

static const struct ways fit_camera_ways = {
	"give \"gaze\" or \"orientation\", with an \"eye\" or without, or "
	"\"eye\" and \"at\", or \"translation\" and \"orientation\", or "
	"\"pose\" or "
	"\"matrix\" alone",
	{ "eye at up? roll?", "eye? gaze up? roll?", "eye? orientation roll?",
	    "translation orientation roll?", "pose orthonormalize?",
	    "matrix orthonormalize?" },
};

#define SIZE(label, type, m, ...)                                           \
	{                                                                   \
		.name = label, .read = read_numbers, .at = MEMBER(type, m), \
		.range = &range_positive, __VA_ARGS__                       \
	}

#define RECTANGLE(type)                                                        \
	NUMBERS("x", type, x, 0, .aliases = "left", .unit = "device units",    \
	    .otherwise = "0", .about = "the corner that origin names"),        \
	    NUMBERS("y", type, y, 0, .aliases = "top", .unit = "device units", \
		.otherwise = "0", .about = "the same"),                        \
	    SIZE("width", type, width, .unit = "device units",                 \
		.about = "required"),                                          \
	    SIZE("height", type, height, .unit = "device units",               \
		.about = "required")

static void read_scale(const struct value *v, const struct member *row,
    void *to)
{
	struct viewport *viewport = to;

	(void)row;
	viewport->scale = SCALE_GIVEN;
	if (value_is_array(v))
		value_numbers(v, &range_positive, 2, viewport->scales);
	else if (*v->s != '"')
		value_wrong(v, "\"fill\", \"uniform\" or 2 numbers");
	else if (value_word(v, scales) == 0)
		viewport->scale = SCALE_FILL;
	else
		viewport->scale = SCALE_UNIFORM;
}

const struct member viewport_members[] = {
	RECTANGLE(viewport),
	NUMBERS("min_z", viewport, min_z, 0,
	    .aliases = "near mindepth zmin minz", .unit = "device units",
	    .otherwise = "0", .about = "z of the near plane"),
	NUMBERS("max_z", viewport, max_z, 0,
	    .aliases = "far maxdepth zmax maxz", .unit = "device units",
	    .otherwise = "1", .about = "z of the far plane"),
	{ .name = "scale",
	    .read = read_scale,
	    .type = "fill, uniform or 2 sizes",
	    .otherwise = "\"fill\"",
	    .about = "device units for one of ndc" },
	{ .name = NULL },
};

const struct member device_members[] = {
	RECTANGLE(device),
	{ .name = "origin",
	    .read = read_second,
	    .words = origins,
	    .at = MEMBER(device, top_left),
	    .otherwise = "\"bottom-left\"",
	    .about = "the corner where x and y are least" },
	{ .name = NULL },
};

static const struct ways rectangle_ways = {
	"give \"width\" and \"height\"",
	{ "width height" },
};

const struct member window_members[] = {
	NUMBERS("center", window, center, 2, .aliases = "centre x y position",
	    .unit = "window units", .about = "with width and height"),
	SIZE("width", window, width, .unit = "window units",
	    .about = "of all of it"),
	SIZE("height", window, height, .unit = "window units",
	    .about = "of all of it"),
	NUMBERS("left", window, left, 0, .unit = "window units",
	    .about = "the four edges, instead"),
	NUMBERS("right", window, right, 0, .unit = "window units",
	    .about = "greater than left"),
	NUMBERS("bottom", window, bottom, 0, .unit = "window units",
	    .about = "an edge"),
	NUMBERS("top", window, top, 0, .unit = "window units",
	    .about = "greater than bottom"),
	NUMBERS("pan", window, pan, 2, .unit = "window units",
	    .otherwise = "[0, 0]", .about = "by how much the window moves"),
	SIZE("zoom", window, zoom, .otherwise = "1",
	    .about = "of which 2 shows half the extent"),
	NUMBERS("about", window, about, 2, .unit = "window units",
	    .about = "what zoom leaves where it is, else the centre"),
	{ .name = "adapt",
	    .read = read_word,
	    .at = MEMBER(window, adapt),
	    .words = adapt_names,
	    .otherwise = "\"stretch\"",
	    .about = "to a device of another shape" },
	{ .name = NULL },
};

static const struct ways window_ways = {
	"give \"center\", \"width\" and \"height\", or \"left\", \"right\", "
	"\"bottom\" and \"top\"",
	{ "center width height", "left right bottom top" },
};

/* What fit is to replace. */
static const struct ways fit_window_ways = {
	"give \"center\", \"width\" and \"height\", or \"left\", \"right\", "
	"\"bottom\" and \"top\", or nothing",
	{ "center? width? height?", "left? right? bottom? top?" },
};

/* A point of space; or of the plane, where the document is flat. Where bounds are
 * not used they may be of either. */
static void read_corner(const struct value *v, const struct member *row,
    void *out)
{
	bool pair = value_is_array(v) && value_count(v) == 2;
	bool flat = v->source->flat;

	(void)row;
	if (flat && !pair && !v->unused)
		value_refuse(v,
		    "is not an array of 2 numbers, as a window's are; for "
		    "three dimensions add a \"projection\"");
	value_numbers(v, &range_any, pair && (flat || v->unused) ? 2 : 3, out);
}

#define CORNER(label, m, other, what)                                        \
	{                                                                    \
		.name = label, .read = read_corner, .at = MEMBER(bounds, m), \
		.type = "3 numbers, or 2 of a window", .aliases = other,     \
		.unit = "model units", .about = what                         \
	}

const struct member bounds_members[] = {
	CORNER("center", center, "centre position", "of a sphere"),
	SIZE("radius", bounds, radius, .unit = "model units",
	    .about = "of a sphere"),
	CORNER("min", min, "lower from", "of a box, its least coordinates"),
	CORNER("max", max, "upper to", "the opposite corner"),
	{ .name = NULL },
};

static const struct ways bounds_ways = {
	"give \"min\" and \"max\", or \"center\" and \"radius\"",
	{ "min max", "center radius" },
};

const struct member pick_members[] = {
	NUMBERS("at", pick, at, 2, .aliases = "position center",
	    .unit = "device units", .about = "where to look"),
	SIZE("radius", pick, radius, .unit = "device units",
	    .about = "how far around it"),
	{ .name = NULL },
};

/* What others call so is often where the camera stands. */
static void check_translation(const struct value *v, unsigned seen)
{
	struct value m = value_missing(v, "translation");

	if ((seen & member_bit(camera_members, 0, "translation")) != 0 &&
	    (seen & member_bit(camera_members, 0, "orientation")) == 0)
		value_refuse(&m,
		    "is where the world's origin is in view space, and needs "
		    "an \"orientation\"; where the camera stands is \"eye\"");
}

bool read_camera(const struct value *v, struct camera *c)
{
	*c = (struct camera){ .up = { 0, 1, 0 },
		.unit = (enum angle_unit)v->source->unit };
	unsigned seen = object_read(v, camera_members, 0, c);

	check_translation(v, seen);
	c->by = (unsigned)object_way(v, camera_members, 0, seen,
	    v->source->fit ? &fit_camera_ways : &camera_ways);
	return c->by >= CAMERA_TRANSLATION ||
	    (seen & member_bit(camera_members, 0, "eye")) != 0;
}

void read_viewport(const struct value *v, struct viewport *w)
{
	*w = (struct viewport){ .max_z = 1 };
	unsigned seen = object_read(v, viewport_members, 0, w);

	object_way(v, viewport_members, 0, seen, &rectangle_ways);
}

void read_device(const struct value *v, struct device *d)
{
	*d = (struct device){ 0 };
	unsigned seen = object_read(v, device_members, 0, d);

	object_way(v, device_members, 0, seen, &rectangle_ways);
}

void read_window(const struct value *v, struct window *w)
{
	*w = (struct window){ .zoom = 1 };
	unsigned seen = object_read(v, window_members, 0, w);

	w->by_edges = object_way(v, window_members, 0, seen,
			  v->source->fit && v->source->flat ?
			      &fit_window_ways :
			      &window_ways) == 1;
	w->has_about = (seen & member_bit(window_members, 0, "about")) != 0;
}

void read_bounds(const struct value *v, struct bounds *b)
{
	unsigned seen = object_read(v, bounds_members, 0, b);

	b->sphere = object_way(v, bounds_members, 0, seen, &bounds_ways) == 1;
}

void read_pick(const struct value *v, struct pick *p)
{
	unsigned seen = object_read(v, pick_members, 0, p);

	p->has_at = (seen & member_bit(pick_members, 0, "at")) != 0;
}
