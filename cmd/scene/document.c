/* SPDX-License-Identifier: MIT */
#include "document.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../json/text.h"
#include "../number/number.h"
#include "convention_member.h"
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

/* Finds the members in m; returns those that there are, as bits. An object with none of
 * a scene's members is one of them itself, beside which may stand the unit of angles. */
static unsigned find_members(struct document *d, const struct value *root,
    const struct document_wants *w, struct value m[SCENE_MEMBERS])
{
	unsigned seen = 0;

	if (!value_is_object(root))
		value_wrong(root, "an object, {...},");
	for (int i = 0; i < SCENE_MEMBERS; i++)
		if (value_member(root, scene_members[i].name, &m[i]))
			seen |= 1u << i;
	if (w->bare == 0 || (seen & ~(unsigned)SCENE_ANGLE_UNIT) != 0) {
		object_read(root, scene_members, 0, NULL);
		return seen;
	}
	for (int i = 0; i < SCENE_MEMBERS; i++)
		if (w->bare == 1u << i) {
			d->bare = scene_members[i].name;
			m[i] = *root;
		}
	return seen | w->bare;
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

/* Returns whether the document's convention says anything. */
static bool read_convention(const struct value *v, struct document *d)
{
	object_read_member(v, &scene_members[CONVENTION], d);
	return !value_is_object(v) ||
	    object_read(v, convention_members, 0, NULL) != 0;
}

/* A device's corner that is not given is that of the answer's convention, else of the
 * document's, where that is a name or has an origin. */
static void find_origin(const struct document_wants *w, const struct value *v,
    const struct convention *c, struct device *device)
{
	struct value given;

	if (w->convention != NULL)
		device->top_left = !w->convention->bottom_left;
	else if (v->item != NULL &&
	    (!value_is_object(v) || value_member(v, "origin", &given)))
		device->top_left = !c->bottom_left;
}

/* What one member says of another. */
static void complete_scene(struct document *d, const struct document_wants *w,
    const struct value m[SCENE_MEMBERS], unsigned seen)
{
	struct scene *s = &d->scene;
	struct value given;

	s->camera.unit = d->unit;
	s->projection.alone = !s->has_camera;
	d->has_eye = s->has_camera &&
	    (s->camera.by >= CAMERA_TRANSLATION ||
		value_member(&m[CAMERA], "eye", &given));
	if (s->camera.by == CAMERA_RVEC ||
	    s->camera.by == CAMERA_RVEC_TRANSLATION)
		check_axes(&m[CAMERA], "rvec");
	if (seen & SCENE_PROJECTION)
		projection_complete(&m[PROJECTION],
		    s->has_viewport ? &s->viewport : NULL, &s->projection);
	if (s->has_device && !value_member(&m[DEVICE], "origin", &given))
		find_origin(w, &m[CONVENTION], &s->convention, &s->device);
	if ((w->used & SCENE_MARGIN) == 0)
		s->margin = 0;
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
	unsigned seen = find_members(d, &root, wants, m);

	d->flat = (seen & SCENE_PROJECTION) == 0 && (seen & wants->flat) != 0;
	const struct document_wants narrowed = in_plane(wants);
	const struct document_wants *w = d->flat ? &narrowed : wants;

	source.flat = d->flat;
	refuse_flat(&root, wants, seen);
	for (int i = 0; i < SCENE_MEMBERS; i++)
		m[i].unused = (w->used >> i & 1) == 0;
	d->scene.convention = conventions[CONVENTION_D3D];
	if (w->convention != NULL)
		d->scene.convention = *w->convention;
	source.axes = w->convention != NULL;
	if (seen & SCENE_CONVENTION)
		source.axes |= read_convention(&m[CONVENTION], d);
	if (w->convention != NULL &&
	    !same_convention(w->convention, &d->scene.convention))
		d->scene.answer = w->convention;
	source.column = d->scene.convention.column;
	source.implied = (unsigned)w->projection;
	if (seen & SCENE_ANGLE_UNIT)
		object_read_member(&m[ANGLE_UNIT], &scene_members[ANGLE_UNIT],
		    d);
	source.unit = d->unit;
	check_needed(&root, w, seen);
	for (int i = WORLD; i < SCENE_MEMBERS; i++)
		if (seen >> i & 1 && i != POINTS)
			object_read_member(&m[i], &scene_members[i], d);
	complete_scene(d, w, m, seen);
	if (seen & SCENE_POINTS)
		size = take_points(&m[POINTS], &points, w->coordinates);
	if (seen & SCENE_POINTS && w->coordinates > 0) {
		d->points = points.s;
		d->points_size = size;
	}
}

char *document_points(const char *name, char *text, size_t size,
    int coordinates, const char *two, size_t *points_size)
{
	struct source source = { .name = name,
		.two = two,
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

/* Puts the members of a document's scene that bits are. */
static void put_members(struct printer *p, const struct document *d,
    unsigned bits)
{
	p->column = d->scene.convention.column;
	put_open(p, "{");
	object_put(p, scene_members, 0, bits, d, put_name_on_new_line);
}

void put_scene(struct printer *p, const struct scene *s)
{
	const struct document d = { .scene = *s };
	const bool on_line = p->on_line;

	p->on_line = true;
	put_members(p, &d, SCENE_CONVENTION | SCENE_SPATIAL);
	p->on_line = on_line;
	put_close(p, "}");
}

void put_device(struct printer *p, const struct device *d)
{
	scene_members[DEVICE].type->print(p, &scene_members[DEVICE], d);
}

void print_scene(const struct document *d, bool on_line)
{
	static char text[1 << 16];
	struct printer p = { .at = text,
		.on_line = on_line,
		.compact = on_line,
		.between = "" };
	unsigned unprinted = SCENE_POINTS | SCENE_BOUNDS;

	put_members(&p, d, ~(unprinted | (d->flat ? SCENE_SPATIAL : 0u)));
	put_text(&p, on_line ? "}\n" : "\n}\n");
	output_write(text, (size_t)(p.at - text));
}
