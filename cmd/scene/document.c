#include "document.h"

#include <stdlib.h>
#include <string.h>

#include "../json/scan.h"
#include "convention_member.h"
#include "members.h"
#include "../talk.h"

/* The rows of scene_members: row i has bit i in enum scene_member. */
enum {
	CONVENTION,
	ANGLE_UNIT,
	WORLD,
	CAMERA,
	PROJECTION,
	VIEWPORT,
	WINDOW,
	DEVICE,
	POINTS,
	BOUNDS,
	PICK,
	SCENE_MEMBERS,
};

/* A document may have its members in any order, but read_scene needs some
 * before others: each is first kept as a struct value. */
#define MEMBER(row, label, table, other, like)      \
	[row] = { .name = label,                    \
		.read = read_value,                 \
		.at = (row) * sizeof(struct value), \
		.members = table,                   \
		.aliases = other,                   \
		.example = like }

static const struct member scene_members[SCENE_MEMBERS + 1] = {
	MEMBER(CONVENTION, "convention", convention_members, NULL, "\"d3d\""),
	[ANGLE_UNIT] = { .name = "angle_unit",
	    .read = read_value,
	    .at = ANGLE_UNIT * sizeof(struct value),
	    .words = angle_units,
	    .aliases = "angleunits unit units angles",
	    .beside = true },
	MEMBER(WORLD, "world", NULL, "model",
	    "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]"),
	MEMBER(CAMERA, "camera", camera_members, "view",
	    "{\"eye\": [0,0,-5], \"at\": [0,0,0]}"),
	MEMBER(PROJECTION, "projection", projection_members, "lens perspective",
	    "{\"type\": \"persp\", \"fovy\": 60, \"aspect\": 1.5, "
	    "\"near\": 1, \"far\": 10}"),
	MEMBER(VIEWPORT, "viewport", viewport_members, "screen",
	    "{\"width\": 640, \"height\": 480}"),
	MEMBER(WINDOW, "window", window_members, NULL,
	    "{\"center\": [0,0], \"width\": 2, \"height\": 2}"),
	MEMBER(DEVICE, "device", device_members, NULL,
	    "{\"width\": 640, \"height\": 480}"),
	MEMBER(POINTS, "points", NULL, NULL, "[[0,0,0], [1,1,1]]"),
	MEMBER(BOUNDS, "bounds", bounds_members, NULL, NULL),
	MEMBER(PICK, "pick", pick_members, NULL, NULL),
};

static void check_point(const struct value *v, int coordinates)
{
	struct value e;
	int n = 0;

	if (!value_is_array(v))
		value_wrong(v, "an array of coordinates");
	for (e = value_child(v); e.item != NULL; value_next(&e), n++) {
		if (n < coordinates && !value_is_null(&e))
			value_number(&e, &range_any);
		if (value_is_array(&e) || value_is_object(&e))
			value_wrong(&e, "a number, a string or null");
	}
	if (n < coordinates)
		value_refuse(v, "has %d elements; %d coordinates are wanted", n,
		    coordinates);
}

/* Returns whether v is one point; else it is a list of them. */
static bool check_points(const struct value *v, int coordinates)
{
	struct value e;

	if (!value_is_array(v))
		value_wrong(v, "an array of points");
	e = value_child(v);
	if (e.item != NULL && !value_is_array(&e)) {
		check_point(v, coordinates);
		return true;
	}
	for (; e.item != NULL; value_next(&e))
		check_point(&e, coordinates);
	return false;
}

/* Copies a value from checked text, without the blanks in it, and ends it with
 * a newline. */
static char *copy_value(const char *s, const char *end, char *out)
{
	while (s < end) {
		const char *next = *s == '"' ? json_string(s, end) : s + 1;

		if ((unsigned char)*s > ' ') {
			memcpy(out, s, (size_t)(next - s));
			out += next - s;
		}
		s = next;
	}
	*out++ = '\n';
	return out;
}

/* Where in the document's checked text the value v begins: it is the document
 * itself, or one of its members. */
static const char *find_points(const struct value *v, const char *text,
    const char *end)
{
	const char *s = text, *at;

	while ((unsigned char)*s <= ' ')
		s++;
	at = s;
	for (size_t i = 0; v->in != NULL && i <= v->index; i++)
		at = json_next(at, end, &s);
	return s;
}

static void take_points(const struct value *v, int coordinates,
    const char *text, size_t size, char **points, size_t *points_size)
{
	bool one = check_points(v, coordinates);
	const char *end = text + size, *s = find_points(v, text, end), *at = s;
	char *out = *points = need(NULL, size + 1);

	if (one)
		out = copy_value(s, json_skip(s, end), out);
	else
		while ((at = json_next(at, end, &s)) != NULL)
			out = copy_value(s, at, out);
	*points_size = (size_t)(out - *points);
}

/* Whether an object is to be read as the member bare of a scene: if it has none
 * of a scene's members itself, but for the unit of its angles. */
static bool is_bare(const struct value *v, enum scene_member bare)
{
	struct value m = value_child(v);

	for (; m.item != NULL; value_next(&m))
		if ((member_bit(scene_members, 0, m.name) &
			~(unsigned)SCENE_ANGLE_UNIT) != 0)
			return false;
	return bare != 0;
}

/* Keeps the members in m; returns those that there are, as bits. */
static unsigned read_members(struct document *d, const struct value *root,
    const struct document_wants *w, struct value m[SCENE_MEMBERS])
{
	unsigned seen = w->bare;

	if (!value_is_object(root))
		value_wrong(root, "an object, {...},");
	if (!is_bare(root, w->bare))
		seen = object_read(root, scene_members, 0, m);
	else
		for (int i = 0; i < SCENE_MEMBERS; i++)
			if (w->bare == 1u << i) {
				d->bare = scene_members[i].name;
				m[i] = *root;
			}
	if (d->bare != NULL && value_member(root, "angle_unit", &m[ANGLE_UNIT]))
		seen |= SCENE_ANGLE_UNIT;
	for (int i = 0; i < SCENE_MEMBERS; i++)
		m[i].unused = (w->used >> i & 1) == 0;
	return seen;
}

static void check_needed(const struct value *root, unsigned missing)
{
	for (int i = 0; i <= POINTS; i++) {
		const struct member *row = &scene_members[i];
		struct value v = value_missing(root, row->name);

		if (missing >> i & 1)
			value_refuse(&v, "missing; add \"%s\": %s", row->name,
			    row->example);
	}
}

static void read_scene(struct document *d, const struct document_wants *w,
    const struct value m[SCENE_MEMBERS], unsigned seen)
{
	struct scene *s = &d->scene;

	s->has_world = seen & SCENE_WORLD;
	s->has_camera = seen & SCENE_CAMERA;
	s->has_viewport = seen & SCENE_VIEWPORT;
	s->has_window = seen & SCENE_WINDOW;
	s->has_device = seen & SCENE_DEVICE;
	d->has_bounds = seen & SCENE_BOUNDS;
	if (s->has_world)
		read_affine(&m[WORLD], &scene_members[WORLD], s->world);
	if (s->has_camera)
		d->has_eye = read_camera(&m[CAMERA], &s->camera);
	if (s->has_viewport)
		read_viewport(&m[VIEWPORT], &s->viewport);
	if (seen & SCENE_PROJECTION)
		read_projection(&m[PROJECTION], w->projection,
		    s->has_viewport ? &s->viewport : NULL, &s->projection);
	if (s->has_window)
		read_window(&m[WINDOW], &s->window);
	if (s->has_device)
		read_device(&m[DEVICE], &s->device);
	if (d->has_bounds)
		read_bounds(&m[BOUNDS], &d->bounds);
	if (seen & SCENE_PICK)
		read_pick(&m[PICK], &d->pick);
}

void document_read(struct document *d, const char *name, char *text,
    size_t size, const struct document_wants *w)
{
	struct source source = { .name = name, .scene = scene_members };
	struct value root = value_parse(&source, text, size);
	struct value m[SCENE_MEMBERS];

	source.fit = w->fit;
	*d = (struct document){ .name = name };
	unsigned seen = read_members(d, &root, w, m);

	d->scene.convention = w->convention != NULL ?
	    *w->convention :
	    conventions[CONVENTION_D3D];
	if (seen & SCENE_CONVENTION)
		read_convention(&m[CONVENTION], &d->scene.convention);
	if (w->convention != NULL &&
	    !same_convention(w->convention, &d->scene.convention))
		d->scene.answer = w->convention;
	source.column = d->scene.convention.column;
	if (seen & SCENE_ANGLE_UNIT)
		d->unit = (enum angle_unit)value_word(&m[ANGLE_UNIT],
		    angle_units);
	source.unit = d->unit;
	check_needed(&root, w->needed & ~seen);
	read_scene(d, w, m, seen);
	if (seen & SCENE_POINTS && w->coordinates > 0)
		take_points(&m[POINTS], w->coordinates, text, size, &d->points,
		    &d->points_size);
	else if (seen & SCENE_POINTS)
		check_points(&m[POINTS], 0);
	value_free(&root);
}

void document_points(const char *name, char *text, size_t size, int coordinates,
    char **points, size_t *points_size)
{
	struct source source = { .name = name, .scene = scene_members };
	struct value root = value_parse(&source, text, size);

	take_points(&root, coordinates, text, size, points, points_size);
	value_free(&root);
}

void document_refuse(const struct document *d, const char *why)
{
	size_t n = d->bare != NULL ? strlen(d->bare) : 0;

	/* "/camera/up: ..." to "/up: ...", "/camera: ..." to "..." */
	if (n > 0 && strncmp(why + 1, d->bare, n) == 0 &&
	    (why[n + 1] == '/' || why[n + 1] == ':'))
		why += n + 1 + (why[n + 1] == ':' ? 2 : 0);
	die(EXIT_INPUT, "%s: %s", d->name, why);
}

void document_check(const struct document *d, const char *why)
{
	if (why != NULL)
		document_refuse(d, why);
}
