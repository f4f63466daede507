/* SPDX-License-Identifier: MIT */
#include "document.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../json/text.h"
#include "../number/number.h"
#include "convention_member.h"
#include "examples.h"
#include "members.h"
#include "../message/message.h"

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
	MARGIN,
	SCENE_MEMBERS,
};

/* A document may have its members in any order, but read_scene needs some
 * before others: each is first kept as a struct value. */
#define MEMBER(row, label, of, table, other, ...)   \
	[row] = { .name = label,                    \
		.type = &(of),                      \
		.at = (row) * sizeof(struct value), \
		.members = table,                   \
		.aliases = other,                   \
		__VA_ARGS__ }

#define WORLD_LIKE "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]"
#define BOUNDS_LIKE "{\"min\": [-1,-1,-1], \"max\": [1,1,1]}"
#define PICK_LIKE "{\"at\": [320,240], \"radius\": 3}"

static const struct value_range margins = { .min = 0,
	.max = 0.5,
	.says = "a number from 0 to below 0.5 is wanted",
	.below = true };

const struct member scene_members[SCENE_MEMBERS + 1] = {
	MEMBER(CONVENTION, "convention", type_convention, convention_members,
	    NULL, .example = "\"d3d\"", .words = convention_names,
	    .usual = "\"d3d\"", .before = "-c's",
	    .about = "how the document is read, all of it",
	    .command = "lookat '{\"convention\": \"gl\", "
		       "\"camera\": " CAMERA_LIKE "}'"),
	MEMBER(ANGLE_UNIT, "angle_unit", type_value, NULL,
	    "angleunits unit units angles", .words = angle_units,
	    .beside = true, .usual = "\"degrees\"",
	    .about = "of all angles of the scene",
	    .command = "persp '{\"angle_unit\": \"radians\", \"fovy\": 1, "
		       "\"aspect\": 1.5, \"near\": 1, \"far\": 10}'"),
	MEMBER(WORLD, "world", type_later_matrix, NULL, "model",
	    .example = WORLD_LIKE, .usual = WORLD_LIKE,
	    .about = "model to world, affine",
	    .command = "project --to world '{\"world\": "
		       "[1,0,0,0, 0,1,0,0, 0,0,1,0, 10,20,30,1]}' "
		       "'[1,2,3]'"),
	MEMBER(CAMERA, "camera", type_value, camera_members, "view",
	    .ways = camera_ways, .example = CAMERA_LIKE,
	    .about = "world to view",
	    .command = "lookat '{\"camera\": " CAMERA_LIKE "}'"),
	MEMBER(PROJECTION, "projection", type_value, projection_members,
	    "lens perspective", .ways = projection_ways, .example = LENS_LIKE,
	    .about = "view to clip",
	    .command = "persp '{\"projection\": " LENS_LIKE "}'"),
	MEMBER(VIEWPORT, "viewport", type_value, viewport_members, "screen",
	    .ways = rectangle_ways, .example = RECTANGLE_LIKE,
	    .about = "ndc to device, in 3D",
	    .command = "project --from ndc '{\"viewport\": " RECTANGLE_LIKE
		       "}' '[0,0.5,1]'"),
	MEMBER(WINDOW, "window", type_value, window_members, NULL,
	    .ways = window_ways, .example = WINDOW_LIKE,
	    .about = "a rectangle of a 2D world",
	    .command = "w2n '{\"window\": " WINDOW_LIKE "}'"),
	MEMBER(DEVICE, "device", type_value, device_members, NULL,
	    .ways = rectangle_ways, .example = RECTANGLE_LIKE,
	    .about = "where a window is shown",
	    .command = "n2d '{\"device\": " RECTANGLE_LIKE "}'"),
	MEMBER(POINTS, "points", type_points, NULL, "point",
	    .example = "[[0,0,0], [1,1,1]]",
	    .about = "unless there are operands POINTS",
	    .command = "lookat '{\"camera\": " CAMERA_LIKE
		       ", \"points\": [[0,0,0], [1,1,1]]}'"),
	MEMBER(BOUNDS, "bounds", type_value, bounds_members, NULL,
	    .ways = bounds_ways, .example = BOUNDS_LIKE, .unit = "model units",
	    .about = "what fit is to hold, else the points",
	    .command = "fit '{\"projection\": {\"type\": \"ortho\"}, "
		       "\"bounds\": " BOUNDS_LIKE "}'"),
	MEMBER(PICK, "pick", type_value, pick_members, NULL,
	    .example = PICK_LIKE,
	    .about = "where pick looks, else --at, --radius",
	    .command = "pick '{\"camera\": " CAMERA_LIKE
		       ", \"projection\": " LENS_LIKE
		       ", \"viewport\": " RECTANGLE_LIKE
		       ", \"pick\": " PICK_LIKE "}' '[[0,0,0], [1,1,1]]'"),
	MEMBER(MARGIN, "margin", type_value, NULL, "padding border",
	    .example = "0.1", .range = &margins, .usual = "0",
	    .about = "share of the picture left free at each side",
	    .command = "fit '{\"projection\": {\"type\": \"ortho\"}, "
		       "\"bounds\": " BOUNDS_LIKE ", \"margin\": 0.1}'"),
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
		value_refuse(v, "has %d element%s; %d coordinates are wanted%s",
		    n, n == 1 ? "" : "s", coordinates,
		    n == 2 && v->source->two != NULL ? v->source->two : "");
}

/* Past the coordinate or other element at s of a point; NULL where it isn't one
 * as it should be. */
static const char *pass_element(const char *s, const char *end, bool coordinate)
{
	const char *stop;
	double v;

	if (*s == '-' || (*s >= '0' && *s <= '9')) {
		stop = number_read(s, end, &v);
		return !coordinate || fabs(v) <= MAGNITUDE_MAX ? stop : NULL;
	}
	if (*s == 'n')
		return s + 4; /* null */
	if (coordinate || *s == '[' || *s == '{' || *s == ']')
		return NULL;
	return *s == '"' ? json_string(s, end) :
	    *s == 't'	 ? s + 4 : /* true */
			   s + 5; /* false */
}

/* Past the point of checked text at s; NULL where pass_element says so. */
static const char *pass_point(const char *s, const char *end, int coordinates)
{
	int n = 0;

	if (*s != '[')
		return NULL;
	do {
		s = pass_element(json_space(s + 1, end), end,
		    n++ < coordinates);
		if (s == NULL)
			return NULL;
		s = json_space(s, end);
	} while (*s == ',');
	return n >= coordinates ? s + 1 : NULL;
}

/* The same for the point v, whose text was left out of the values; but refuses
 * what is none. */
static const char *point_end(const struct value *v, const char *s,
    const char *end, int coordinates)
{
	const char *stop = pass_point(s, end, coordinates);
	struct value looked_at = *v;

	if (stop != NULL)
		return stop;
	stop = json_skip(s, end);
	value_parse_part(&looked_at, s, stop);
	check_point(&looked_at, coordinates);
	return stop;
}

/* Copies a value of checked text, without the blanks in it, to before its end,
 * and ends it with a newline. */
static char *copy_value(const char *s, const char *end, char *out)
{
	while (s < end) {
		if (*s == '"') {
			const char *next = json_string(s, end);

			memmove(out, s, (size_t)(next - s));
			out += next - s;
			s = next;
			continue;
		}
		*out = *s++;
		out += (unsigned char)*out > ' ';
	}
	*out++ = '\n';
	return out;
}

/* The text of points, which only an array has. */
static char *text_of(const struct value *v, const struct span *array)
{
	if (array->s == NULL)
		value_wrong(v, "an array of points");
	return (char *)array->s;
}

/* Makes lines of the points that an array is, or the one point, in its place:
 * no point's line is longer than the point with the comma or bracket before it,
 * but for the newline of a lone one, which is behind the text if that ends with it.
 * Returns how many bytes that is. */
static size_t take_points(const struct value *v, const struct span *array,
    int coordinates)
{
	char *const lines = text_of(v, array);
	char *out = lines;
	const char *s = json_space(lines + 1, array->end), *stop;
	struct value e = { .source = v->source, .in = v, .unused = v->unused };

	if (*s == ']')
		return 0;
	if (*s != '[') {
		stop = point_end(v, lines, array->end, coordinates);
		return (size_t)(copy_value(lines, stop, out) - lines);
	}
	for (;; e.index++) {
		stop = point_end(&e, s, array->end, coordinates);
		out = copy_value(s, stop, out);
		stop = json_space(stop, array->end);
		if (*stop == ']')
			return (size_t)(out - lines);
		s = json_space(stop + 1, array->end);
	}
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
		seen = (unsigned)object_read(root, scene_members, 0, m);
	else
		for (int i = 0; i < SCENE_MEMBERS; i++)
			if (w->bare == 1u << i) {
				d->bare = scene_members[i].name;
				m[i] = *root;
			}
	if (d->bare != NULL && value_member(root, "angle_unit", &m[ANGLE_UNIT]))
		seen |= SCENE_ANGLE_UNIT;
	return seen;
}

unsigned document_reads(const struct document_wants *w)
{
	bool angles = (w->used & (SCENE_CAMERA | SCENE_PROJECTION)) != 0;

	return w->used | SCENE_CONVENTION | (angles ? SCENE_ANGLE_UNIT : 0) |
	    (w->flat != 0 ? SCENE_WINDOW | SCENE_DEVICE : 0);
}

/* What is wanted of a document that is flat. */
static struct document_wants in_plane(const struct document_wants *w)
{
	struct document_wants flat = *w;

	flat.needed = 0;
	flat.used = document_reads(w) & ~(unsigned)SCENE_SPATIAL;
	flat.coordinates = w->coordinates > 0 ? 2 : 0;
	return flat;
}

static void check_needed(const struct value *root,
    const struct document_wants *w, unsigned seen)
{
	unsigned missing = w->needed & ~seen;

	for (int i = 0; i <= POINTS; i++) {
		const struct member *row = &scene_members[i];
		struct value v = value_missing(root, row->name);

		if (missing >> i & 1)
			value_refuse(&v, "missing; add \"%s\": %s%s", row->name,
			    row->example,
			    w->flat == 0 ? "" :
					   ", or for two dimensions "
					   "\"window\": {}");
	}
}

/* Refuses a document of two dimensions alone where the command is of three. */
static void refuse_flat(const struct value *root,
    const struct document_wants *w, unsigned seen)
{
	const char *name = seen & SCENE_WINDOW ? "window" : "device";
	struct value v = value_missing(root, name);

	if (w->flat == 0 && (w->used & SCENE_SPATIAL) == SCENE_SPATIAL &&
	    (seen & SCENE_SPATIAL) == 0 &&
	    (seen & ~w->used & (SCENE_WINDOW | SCENE_DEVICE)) != 0)
		value_refuse(&v,
		    "is of two dimensions, and the command of three; the "
		    "commands w2n, n2w, n2d, d2n, w2d and d2w are of two");
}

static void read_scene(struct document *d, const struct document_wants *w,
    const struct value m[SCENE_MEMBERS], unsigned seen)
{
	struct scene *s = &d->scene;
	double margin = 0;

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
	s->projection.alone = !s->has_camera;
	if (s->has_window)
		read_window(&m[WINDOW], &s->window);
	if (s->has_device && !read_device(&m[DEVICE], &s->device))
		find_origin(seen & SCENE_CONVENTION ? &m[CONVENTION] : NULL,
		    w->convention, &s->device.top_left);
	if (d->has_bounds)
		read_bounds(&m[BOUNDS], &d->bounds);
	if (seen & SCENE_PICK)
		read_pick(&m[PICK], &d->pick);
	if (seen & SCENE_MARGIN)
		margin = value_number(&m[MARGIN], &margins);
	if (w->used & SCENE_MARGIN)
		s->margin = margin;
}

static void read_points(struct document *d, const struct value *v,
    const struct span *array, int coordinates)
{
	size_t size = take_points(v, array, coordinates);

	if (coordinates == 0)
		return;
	d->points = array->s;
	d->points_size = size;
}

void document_read(struct document *d, const char *name, char *text,
    size_t size, const struct document_wants *wants)
{
	struct source source = { .name = name,
		.line = wants->line,
		.before = wants->column,
		.two = wants->two,
		.scene = scene_members };
	struct span points;
	struct value root = value_parse_without(&source, "/points", text, size,
	    &points);
	struct value m[SCENE_MEMBERS];

	source.fit = wants->fit;
	*d = (struct document){ .source = source };
	unsigned seen = read_members(d, &root, wants, m);

	d->flat = (seen & SCENE_PROJECTION) == 0 && (seen & wants->flat) != 0;
	const struct document_wants narrowed = in_plane(wants);
	const struct document_wants *w = d->flat ? &narrowed : wants;

	source.flat = d->flat;
	refuse_flat(&root, wants, seen);
	for (int i = 0; i < SCENE_MEMBERS; i++)
		m[i].unused = (w->used >> i & 1) == 0;
	d->scene.convention = w->convention != NULL ?
	    *w->convention :
	    conventions[CONVENTION_D3D];
	source.axes = w->convention != NULL;
	if (seen & SCENE_CONVENTION)
		source.axes |= read_convention(&m[CONVENTION],
		    &d->scene.convention);
	if (w->convention != NULL &&
	    !same_convention(w->convention, &d->scene.convention))
		d->scene.answer = w->convention;
	source.column = d->scene.convention.column;
	if (seen & SCENE_ANGLE_UNIT)
		d->unit = (enum angle_unit)value_word(&m[ANGLE_UNIT],
		    angle_units);
	source.unit = d->unit;
	check_needed(&root, w, seen);
	read_scene(d, w, m, seen);
	if (seen & SCENE_POINTS)
		read_points(d, &m[POINTS], &points, w->coordinates);
}

char *document_points(const char *name, char *text, size_t size,
    int coordinates, size_t *points_size)
{
	struct source source = { .name = name,
		.operand = true,
		.scene = scene_members };
	struct span points;
	struct value root = value_parse_without(&source, "", text, size,
	    &points);

	*points_size = take_points(&root, &points, coordinates);
	return (char *)points.s;
}

void document_refuse(const struct document *d, const char *why)
{
	size_t bare = d->bare != NULL ? strlen(d->bare) : 0;
	size_t n = *why == '/' ? strcspn(why, ":") : 0;
	const char *what = n > 0 ? why + n + 2 : why;
	char pointer[64];

	/* "/camera/up" to "/up" */
	if (bare > 0 && strncmp(why + 1, d->bare, bare) == 0 &&
	    (why[bare + 1] == '/' || why[bare + 1] == ':')) {
		why += bare + 1;
		n -= bare + 1;
	}
	snprintf(pointer, sizeof pointer, "%.*s", (int)n, why);
	const struct place place = source_place(&d->source, pointer);

	die_at(EXIT_INPUT, &place, "%s", what);
}

void document_check(const struct document *d, const char *why)
{
	if (why != NULL)
		document_refuse(d, why);
}
