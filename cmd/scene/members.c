/* SPDX-License-Identifier: MIT */
#include "members.h"

#include "convention_member.h"

static const char *const origins[] = { "bottom-left", "top-left", NULL };
static const char *const scales[] = { "fill", "uniform", NULL };
const char *const adapt_names[] = { "stretch", "grow", "shrink", NULL };

const struct member camera_members[] = {
	ROW(camera, "eye", type_numbers, eye, .n = 3,
	    .aliases = "position pos from origin", .unit = "world units",
	    .about = "where the camera stands"),
	ROW(camera, "at", type_numbers, at, .n = 3,
	    .aliases = "target center centre lookat", .unit = "world units",
	    .about = "the point that it looks at"),
	ROW(camera, "gaze", type_numbers, at, .n = 3,
	    .aliases = "direction dir forward",
	    .about = "the direction in which it looks"),
	ROW(camera, "orientation", type_numbers, orientation, .n = 4,
	    .aliases = "rotation quaternion quat qvec",
	    .note = "x, y, z, w from view to world axes; of w, x, y, z from "
		    "world to view that is -x, -y, -z, w",
	    .about = "quaternion x, y, z, w: view to world axes"),
	ROW(camera, "rvec", type_numbers, rvec, .n = 3,
	    .aliases = "rotationvector rodrigues",
	    .note = "world to view about it, by its length", .unit = "radians",
	    .about = "rotation vector: world to view axes"),
	ROW(camera, "translation", type_numbers, eye, .n = 3,
	    .aliases = "tvec t",
	    .note = "where the world's origin is in view space",
	    .unit = "view units", .about = "where the world's origin is"),
	ROW(camera, "pose", type_affine, matrix,
	    .aliases = "transformmatrix transform matrixworld cameratoworld "
		       "camtoworld c2w",
	    .note = "view to world", .about = "view to world"),
	ROW(camera, "matrix", type_affine, matrix,
	    .aliases = "view viewmatrix extrinsic extrinsics r rt "
		       "rotationmatrix worldtocamera worldtocam w2c",
	    .note = "world to view, [R|t]", .about = "world to view, [R|t]"),
	ROW(camera, "up", type_numbers, up, .n = 3, .usual = "[0, 1, 0]",
	    .shown = true, .about = "it points up in the image"),
	ROW(camera, "roll", type_numbers, roll, .range = &range_turn,
	    .usual = "0", .about = "counterclockwise"),
	ROW(camera, "orthonormalize", type_flag, orthonormalize,
	    .usual = "false", .about = "to the nearest rotation"),
	{ .name = NULL },
};

/* In the order of the values of struct camera's by. */
const struct ways camera_ways[] = {
	{
	    .way = { "eye at up? roll?", "eye gaze up? roll?",
		"eye orientation roll?", "eye rvec roll?",
		"translation orientation roll?", "translation rvec roll?",
		"pose orthonormalize?", "matrix orthonormalize?" },
	    .fit = true,
	    .fit_way = { "eye at up? roll?", "eye? gaze up? roll?",
		"eye? orientation roll?", "eye? rvec roll?",
		"translation orientation roll?", "translation rvec roll?",
		"pose orthonormalize?", "matrix orthonormalize?" },
	},
	{ .way = { NULL } },
};

#define SIZE(in, label, field, ...)                                   \
	ROW(in, label, type_numbers, field, .range = &range_positive, \
	    __VA_ARGS__)

#define RECTANGLE(in)                                                \
	ROW(in, "x", type_numbers, x, .aliases = "left",             \
	    .unit = "device units", .usual = "0", .shown = true,     \
	    .about = "the corner that origin names"),                \
	    ROW(in, "y", type_numbers, y, .aliases = "top",          \
		.unit = "device units", .usual = "0", .shown = true, \
		.about = "the same"),                                \
	    SIZE(in, "width", width, .unit = "device units",         \
		.about = "required"),                                \
	    SIZE(in, "height", height, .unit = "device units",       \
		.about = "required")

/* The end of struct viewport. */
struct scale {
	unsigned is;
	double by[2];
};

_Static_assert(offsetof(struct viewport, scales) ==
	offsetof(struct viewport, scale) + offsetof(struct scale, by),
    "scales stand behind scale");

static void read_scale(const struct value *v, const struct member *row,
    void *out)
{
	struct scale *s = out;

	s->is = SCALE_GIVEN;
	if (value_is_array(v))
		value_numbers(v, &range_positive, 2, s->by);
	else if (value_string(v) == NULL)
		value_wrong(v, "\"fill\", \"uniform\" or 2 numbers");
	else
		s->is = (unsigned)value_word(v, row->words);
}

static void print_scale(struct printer *p, const struct member *row,
    const void *at)
{
	const struct scale *s = at;

	if (s->is == SCALE_GIVEN)
		put_numbers(p, s->by, 2);
	else
		put_string(p, row->words[s->is]);
}

static const struct type type_scale = { "fill, uniform or 2 sizes", read_scale,
	print_scale, sizeof(unsigned) };

const struct member viewport_members[] = {
	RECTANGLE(viewport),
	ROW(viewport, "min_z", type_numbers, min_z,
	    .aliases = "near mindepth zmin minz", .unit = "device units",
	    .usual = "0", .about = "z of the near plane"),
	ROW(viewport, "max_z", type_numbers, max_z,
	    .aliases = "far maxdepth zmax maxz", .unit = "device units",
	    .usual = "1", .about = "z of the far plane"),
	ROW(viewport, "scale", type_scale, scale, .words = scales,
	    .usual = "\"fill\"", .about = "device units for one of ndc"),
	{ .name = NULL },
};

const struct member device_members[] = {
	RECTANGLE(device),
	ROW(device, "origin", type_second, top_left, .words = origins,
	    .usual = "\"bottom-left\"", .shown = true,
	    .before = "-c's or the convention's",
	    .about = "the corner where x and y are least"),
	{ .name = NULL },
};

const struct ways rectangle_ways[] = {
	{
	    .way = { "width height" },
	},
	{ .way = { NULL } },
};

const struct member window_members[] = {
	ROW(window, "center", type_numbers, center, .n = 2,
	    .aliases = "centre x y position", .unit = "window units",
	    .about = "with width and height"),
	SIZE(window, "width", width, .unit = "window units",
	    .about = "of all of it"),
	SIZE(window, "height", height, .unit = "window units",
	    .about = "of all of it"),
	ROW(window, "left", type_numbers, left, .unit = "window units",
	    .about = "the four edges, instead"),
	ROW(window, "right", type_numbers, right, .unit = "window units",
	    .about = "greater than left"),
	ROW(window, "bottom", type_numbers, bottom, .unit = "window units",
	    .about = "an edge"),
	ROW(window, "top", type_numbers, top, .unit = "window units",
	    .about = "greater than bottom"),
	ROW(window, "pan", type_numbers, pan, .n = 2, .unit = "window units",
	    .usual = "[0, 0]", .about = "by how much the window moves"),
	SIZE(window, "zoom", zoom, .usual = "1",
	    .about = "of which 2 shows half the extent"),
	ROW(window, "about", type_numbers, about, .n = 2,
	    .unit = "window units",
	    .about = "what zoom leaves where it is, else the centre"),
	ROW(window, "adapt", type_word, adapt, .words = adapt_names,
	    .usual = "\"stretch\"", .about = "to a device of another shape"),
	{ .name = NULL },
};

const struct ways window_ways[] = {
	{
	    .way = { "center width height", "left right bottom top" },
	    .fit = true,
	    .fit_way = { "center? width? height?",
		"left? right? bottom? top?" },
	},
	{ .way = { NULL } },
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

static const struct type type_corner = { "3 numbers, or 2 of a window",
	read_corner, NULL, 0 };

#define CORNER(label, field, other, what)                        \
	ROW(bounds, label, type_corner, field, .aliases = other, \
	    .unit = "model units", .about = what)

const struct member bounds_members[] = {
	CORNER("center", center, "centre position", "of a sphere"),
	SIZE(bounds, "radius", radius, .unit = "model units",
	    .about = "of a sphere"),
	CORNER("min", min, "lower from", "of a box, its least coordinates"),
	CORNER("max", max, "upper to", "the opposite corner"),
	{ .name = NULL },
};

const struct ways bounds_ways[] = {
	{
	    .way = { "min max", "center radius" },
	},
	{ .way = { NULL } },
};

const struct member pick_members[] = {
	ROW(pick, "at", type_numbers, at, .n = 2, .aliases = "position center",
	    .unit = "device units", .about = "where to look"),
	SIZE(pick, "radius", radius, .unit = "device units",
	    .about = "how far around it"),
	{ .name = NULL },
};

/* What others call so is often where the camera stands. */
static void check_translation(const struct value *v, uint64_t seen)
{
	struct value m = value_missing(v, "translation");
	uint64_t turn = member_bit(camera_members, 0, "orientation") |
	    member_bit(camera_members, 0, "rvec");

	if ((seen & member_bit(camera_members, 0, "translation")) != 0 &&
	    (seen & turn) == 0)
		value_refuse(&m,
		    "is where the world's origin is in view space, and needs "
		    "an \"orientation\" or \"rvec\"; where the camera stands "
		    "is "
		    "\"eye\"");
}

bool read_camera(const struct value *v, struct camera *c)
{
	*c = (struct camera){ .unit = (enum angle_unit)v->source->unit };
	uint64_t seen = object_read(v, camera_members, 0, c);

	check_translation(v, seen);
	c->by = (unsigned)object_way(v, camera_members, 0, seen, camera_ways);
	if ((seen & member_bit(camera_members, 0, "rvec")) != 0)
		check_axes(v, "rvec");
	return c->by >= CAMERA_TRANSLATION ||
	    (seen & member_bit(camera_members, 0, "eye")) != 0;
}

void read_viewport(const struct value *v, struct viewport *w)
{
	*w = (struct viewport){ 0 };
	uint64_t seen = object_read(v, viewport_members, 0, w);

	object_way(v, viewport_members, 0, seen, rectangle_ways);
}

bool read_device(const struct value *v, struct device *d)
{
	*d = (struct device){ 0 };
	uint64_t seen = object_read(v, device_members, 0, d);

	object_way(v, device_members, 0, seen, rectangle_ways);
	return (seen & member_bit(device_members, 0, "origin")) != 0;
}

/* fit finds only the window of a document that is flat. */
void read_window(const struct value *v, struct window *w)
{
	struct ways ways = window_ways[0];

	ways.fit = v->source->flat;
	*w = (struct window){ 0 };
	uint64_t seen = object_read(v, window_members, 0, w);

	w->by_edges = object_way(v, window_members, 0, seen, &ways) == 1;
	w->has_about = (seen & member_bit(window_members, 0, "about")) != 0;
}

void read_bounds(const struct value *v, struct bounds *b)
{
	uint64_t seen = object_read(v, bounds_members, 0, b);

	b->sphere = object_way(v, bounds_members, 0, seen, bounds_ways) == 1;
}

void read_pick(const struct value *v, struct pick *p)
{
	uint64_t seen = object_read(v, pick_members, 0, p);

	p->has_at = (seen & member_bit(pick_members, 0, "at")) != 0;
}
