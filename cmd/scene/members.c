#include "members.h"

static const char *const origins[] = { "bottom-left", "top-left", NULL };
static const char *const scales[] = { "fill", "uniform", NULL };
const char *const adapt_names[] = { "stretch", "grow", "shrink", NULL };

#define MEMBER(type, member) offsetof(struct type, member)

#define NUMBERS(label, type, m, count, other)                               \
	{                                                                   \
		.name = label, .read = read_numbers, .at = MEMBER(type, m), \
		.n = count, .aliases = other                                \
	}
#define FLAG(m, type)                                                \
	{                                                            \
		.name = #m, .read = read_flag, .at = MEMBER(type, m) \
	}

const struct member camera_members[] = {
	NUMBERS("eye", camera, eye, 3, "position pos from origin"),
	NUMBERS("at", camera, at, 3, "target center centre lookat"),
	NUMBERS("gaze", camera, at, 3, "direction dir forward"),
	{ .name = "orientation",
	    .read = read_numbers,
	    .at = MEMBER(camera, orientation),
	    .n = 4,
	    .aliases = "rotation quaternion quat qvec",
	    .note = "x, y, z, w from view to world axes; of w, x, y, z from "
		    "world to view that is -x, -y, -z, w" },
	{ .name = "translation",
	    .read = read_numbers,
	    .at = MEMBER(camera, eye),
	    .n = 3,
	    .aliases = "tvec t",
	    .note = "where the world's origin is in view space" },
	{ .name = "pose",
	    .read = read_affine,
	    .at = MEMBER(camera, matrix),
	    .aliases = "transformmatrix transform matrixworld cameratoworld "
		       "camtoworld c2w",
	    .note = "view to world" },
	{ .name = "matrix",
	    .read = read_affine,
	    .at = MEMBER(camera, matrix),
	    .aliases = "view viewmatrix extrinsic extrinsics r rt rvec "
		       "rotationmatrix worldtocamera worldtocam w2c",
	    .note = "world to view, [R|t]" },
	NUMBERS("up", camera, up, 3, NULL),
	NUMBERS("roll", camera, roll, 0, NULL),
	FLAG(orthonormalize, camera),
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

#define SIZE(label, type, m)                                                \
	{                                                                   \
		.name = label, .read = read_numbers, .at = MEMBER(type, m), \
		.range = &range_positive                                    \
	}

#define RECTANGLE(type)                                                    \
	NUMBERS("x", type, x, 0, "left"), NUMBERS("y", type, y, 0, "top"), \
	    SIZE("width", type, width), SIZE("height", type, height)

static void read_scale(const struct value *v, const struct member *row,
    void *to)
{
	struct viewport *viewport = to;

	(void)row;
	viewport->scale = SCALE_GIVEN;
	if (value_is_array(v))
		value_numbers(v, &range_positive, 2, viewport->scales);
	else if (value_string(v) == NULL)
		value_wrong(v, "\"fill\", \"uniform\" or 2 numbers");
	else if (value_word(v, scales) == 0)
		viewport->scale = SCALE_FILL;
	else
		viewport->scale = SCALE_UNIFORM;
}

const struct member viewport_members[] = {
	RECTANGLE(viewport),
	NUMBERS("min_z", viewport, min_z, 0, "near mindepth zmin minz"),
	NUMBERS("max_z", viewport, max_z, 0, "far maxdepth zmax maxz"),
	{ .name = "scale", .read = read_scale },
	{ .name = NULL },
};

const struct member device_members[] = {
	RECTANGLE(device),
	{ .name = "origin",
	    .read = read_second,
	    .words = origins,
	    .at = MEMBER(device, top_left) },
	{ .name = NULL },
};

static const struct ways rectangle_ways = {
	"give \"width\" and \"height\"",
	{ "width height" },
};

const struct member window_members[] = {
	NUMBERS("center", window, center, 2, "centre x y position"),
	SIZE("width", window, width),
	SIZE("height", window, height),
	NUMBERS("left", window, left, 0, NULL),
	NUMBERS("right", window, right, 0, NULL),
	NUMBERS("bottom", window, bottom, 0, NULL),
	NUMBERS("top", window, top, 0, NULL),
	NUMBERS("pan", window, pan, 2, NULL),
	SIZE("zoom", window, zoom),
	NUMBERS("about", window, about, 2, NULL),
	{ .name = "adapt",
	    .read = read_word,
	    .at = MEMBER(window, adapt),
	    .words = adapt_names },
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

#define CORNER(label, m, other)                                              \
	{                                                                    \
		.name = label, .read = read_corner, .at = MEMBER(bounds, m), \
		.aliases = other                                             \
	}

const struct member bounds_members[] = {
	CORNER("center", center, "centre position"),
	SIZE("radius", bounds, radius),
	CORNER("min", min, "lower from"),
	CORNER("max", max, "upper to"),
	{ .name = NULL },
};

static const struct ways bounds_ways = {
	"give \"min\" and \"max\", or \"center\" and \"radius\"",
	{ "min max", "center radius" },
};

const struct member pick_members[] = {
	NUMBERS("at", pick, at, 2, "position center"),
	SIZE("radius", pick, radius),
	{ .name = NULL },
};

bool read_camera(const struct value *v, struct camera *c)
{
	*c = (struct camera){ .up = { 0, 1, 0 },
		.unit = (enum angle_unit)v->source->unit };
	unsigned seen = object_read(v, camera_members, 0, c);

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
