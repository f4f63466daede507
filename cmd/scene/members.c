/* SPDX-License-Identifier: MIT */
#include "members.h"

static const char *const origins[] = { "bottom-left", "top-left", NULL };
static const char *const scales[] = { "fill", "uniform", NULL };
const char *const adapt_names[] = { "stretch", "grow", "shrink", NULL };

#define MEMBER(in, member) offsetof(struct in, member)

#define NUMBERS(label, in, m, count, ...)                                  \
	{                                                                  \
		.name = label, .type = &type_numbers, .at = MEMBER(in, m), \
		.n = count, __VA_ARGS__                                    \
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
	    .type = &type_affine,
	    .at = MEMBER(camera, matrix),
	    .aliases = "transformmatrix transform matrixworld cameratoworld "
		       "camtoworld c2w",
	    .note = "view to world",
	    .about = "view to world" },
	{ .name = "matrix",
	    .type = &type_affine,
	    .at = MEMBER(camera, matrix),
	    .aliases = "view viewmatrix extrinsic extrinsics r rt rvec "
		       "rotationmatrix worldtocamera worldtocam w2c",
	    .note = "world to view, [R|t]",
	    .about = "world to view, [R|t]" },
	NUMBERS("up", camera, up, 3, .usual = "[0, 1, 0]", .shown = true,
	    .about = "it points up in the image"),
	NUMBERS("roll", camera, roll, 0, .range = &range_turn, .usual = "0",
	    .about = "counterclockwise"),
	{ .name = "orthonormalize",
	    .type = &type_flag,
	    .at = MEMBER(camera, orthonormalize),
	    .usual = "false",
	    .about = "to the nearest rotation" },
	{ .name = NULL },
};

/* In the order of the values of struct camera's by. */
const struct ways camera_ways[] = {
	{
	    .hint = "give \"eye\" and one of \"at\", \"gaze\" and "
	            "\"orientation\", or "
		    "\"translation\" and \"orientation\", or \"pose\" or "
	            "\"matrix\" alone",
	    .way = { "eye at up? roll?", "eye gaze up? roll?",
		"eye orientation roll?", "translation orientation roll?",
		"pose orthonormalize?", "matrix orthonormalize?" },
	    .fit_hint = "give \"gaze\" or \"orientation\", with an \"eye\" or "
	                "without, or "
			"\"eye\" and \"at\", or \"translation\" and "
	                "\"orientation\", or "
			"\"pose\" or "
			"\"matrix\" alone",
	    .fit_way = { "eye at up? roll?", "eye? gaze up? roll?",
		"eye? orientation roll?", "translation orientation roll?",
		"pose orthonormalize?", "matrix orthonormalize?" },
	},
	{ .hint = NULL },
};

#define SIZE(label, in, m, ...)                                            \
	{                                                                  \
		.name = label, .type = &type_numbers, .at = MEMBER(in, m), \
		.range = &range_positive, __VA_ARGS__                      \
	}

#define RECTANGLE(in)                                                        \
	NUMBERS("x", in, x, 0, .aliases = "left", .unit = "device units",    \
	    .usual = "0", .shown = true,                                     \
	    .about = "the corner that origin names"),                        \
	    NUMBERS("y", in, y, 0, .aliases = "top", .unit = "device units", \
		.usual = "0", .shown = true, .about = "the same"),           \
	    SIZE("width", in, width, .unit = "device units",                 \
		.about = "required"),                                        \
	    SIZE("height", in, height, .unit = "device units",               \
		.about = "required")

/* The end of struct viewport. */
struct scale {
	unsigned is;
	double by[2];
};

_Static_assert(offsetof(struct viewport, scales) ==
	MEMBER(viewport, scale) + offsetof(struct scale, by),
    "scales stand behind scale");

static void read_scale(const struct value *v, const struct member *row,
    void *out)
{
	struct scale *s = out;

	s->is = SCALE_GIVEN;
	if (value_is_array(v))
		value_numbers(v, &range_positive, 2, s->by);
	else if (*v->s != '"')
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
	NUMBERS("min_z", viewport, min_z, 0,
	    .aliases = "near mindepth zmin minz", .unit = "device units",
	    .usual = "0", .about = "z of the near plane"),
	NUMBERS("max_z", viewport, max_z, 0,
	    .aliases = "far maxdepth zmax maxz", .unit = "device units",
	    .usual = "1", .about = "z of the far plane"),
	{ .name = "scale",
	    .type = &type_scale,
	    .at = MEMBER(viewport, scale),
	    .words = scales,
	    .usual = "\"fill\"",
	    .about = "device units for one of ndc" },
	{ .name = NULL },
};

const struct member device_members[] = {
	RECTANGLE(device),
	{ .name = "origin",
	    .type = &type_second,
	    .words = origins,
	    .at = MEMBER(device, top_left),
	    .usual = "\"bottom-left\"",
	    .about = "the corner where x and y are least" },
	{ .name = NULL },
};

const struct ways rectangle_ways[] = {
	{
	    .hint = "give \"width\" and \"height\"",
	    .way = { "width height" },
	},
	{ .hint = NULL },
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
	    .usual = "[0, 0]", .about = "by how much the window moves"),
	SIZE("zoom", window, zoom, .usual = "1",
	    .about = "of which 2 shows half the extent"),
	NUMBERS("about", window, about, 2, .unit = "window units",
	    .about = "what zoom leaves where it is, else the centre"),
	{ .name = "adapt",
	    .type = &type_word,
	    .at = MEMBER(window, adapt),
	    .words = adapt_names,
	    .usual = "\"stretch\"",
	    .about = "to a device of another shape" },
	{ .name = NULL },
};

const struct ways window_ways[] = {
	{
	    .hint = "give \"center\", \"width\" and \"height\", or \"left\", "
	            "\"right\", "
		    "\"bottom\" and \"top\"",
	    .way = { "center width height", "left right bottom top" },
	    .fit_hint = "give \"center\", \"width\" and \"height\", or "
	                "\"left\", \"right\", "
			"\"bottom\" and \"top\", or nothing",
	    .fit_way = { "center? width? height?",
		"left? right? bottom? top?" },
	},
	{ .hint = NULL },
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

#define CORNER(label, m, other, what)                                         \
	{                                                                     \
		.name = label, .type = &type_corner, .at = MEMBER(bounds, m), \
		.aliases = other, .unit = "model units", .about = what        \
	}

const struct member bounds_members[] = {
	CORNER("center", center, "centre position", "of a sphere"),
	SIZE("radius", bounds, radius, .unit = "model units",
	    .about = "of a sphere"),
	CORNER("min", min, "lower from", "of a box, its least coordinates"),
	CORNER("max", max, "upper to", "the opposite corner"),
	{ .name = NULL },
};

const struct ways bounds_ways[] = {
	{
	    .hint = "give \"min\" and \"max\", or \"center\" and \"radius\"",
	    .way = { "min max", "center radius" },
	},
	{ .hint = NULL },
};

const struct member pick_members[] = {
	NUMBERS("at", pick, at, 2, .aliases = "position center",
	    .unit = "device units", .about = "where to look"),
	SIZE("radius", pick, radius, .unit = "device units",
	    .about = "how far around it"),
	{ .name = NULL },
};

/* What others call so is often where the camera stands. */
static void check_translation(const struct value *v, uint64_t seen)
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
	*c = (struct camera){ .unit = (enum angle_unit)v->source->unit };
	uint64_t seen = object_read(v, camera_members, 0, c);

	check_translation(v, seen);
	c->by = (unsigned)object_way(v, camera_members, 0, seen, camera_ways);
	return c->by >= CAMERA_TRANSLATION ||
	    (seen & member_bit(camera_members, 0, "eye")) != 0;
}

void read_viewport(const struct value *v, struct viewport *w)
{
	*w = (struct viewport){ 0 };
	uint64_t seen = object_read(v, viewport_members, 0, w);

	object_way(v, viewport_members, 0, seen, rectangle_ways);
}

void read_device(const struct value *v, struct device *d)
{
	*d = (struct device){ 0 };
	uint64_t seen = object_read(v, device_members, 0, d);

	object_way(v, device_members, 0, seen, rectangle_ways);
}

/* fit finds only the window of a document that is flat. */
void read_window(const struct value *v, struct window *w)
{
	struct ways ways = window_ways[0];

	if (!v->source->flat)
		ways.fit_hint = NULL;
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
