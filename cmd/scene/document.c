/* SPDX-License-Identifier: MIT */
#include "document.h"

#include <stdio.h>
#include <string.h>

#include "../json/text.h"
#include "../message/message.h"
#include "convention_member.h"
#include "projection_member.h"

/* The index of a member in scene_members[], and of its bit in enum scene_member. */
#define ROW_OF(member) __builtin_ctz(SCENE_##member)

enum { SCENE_MEMBERS = ROW_OF(MARGIN) + 1 };

/* The document itself as a member, for object_read and object_print. */
static const struct member scene_row = { .members = scene_members };

/* Writes the point v, whose text begins at s and is JSON, to *out as a line without
 * blanks, moves *out to its end, and returns the text's end. A point is an array: first
 * the coordinates, each a number or null, then any values but arrays and objects. */
static const char *write_point(struct value *v, const char *s, const char *end,
    int coordinates, char **out)
{
	struct value e = { v->source, .parent = v, .unused = v->unused };
	int n = 0;

	if (*s == '{')
		value_refuse(v,
		    "is an object; -i json reads lines of them, as jq -c '.[]' makes");
	if (*s != '[') {
		value_peek(v, s, end);
		value_refuse_type(v, "an array of coordinates");
	}
	for (s = json_skip_blanks(s + 1, end); *s != ']'; e.index++) {
		const char *stop = value_peek(&e, s, end);

		*(*out)++ = n == 0 ? '[' : ',';
		if (n++ < coordinates && *s != 'n')
			value_number(&e, &range_any);
		else if (*s == '[' || *s == '{')
			value_refuse_type(&e, "a number, a string or null");
		memmove(*out, s, (size_t)(stop - s));
		*out += stop - s;
		s = json_next_item(stop, end);
	}
	if (n < coordinates)
		value_refuse(v, "has %d element%s; %d coordinates are wanted%s", n,
		    n == 1 ? "" : "s", coordinates,
		    n == 2 && v->source->two_numbers_hint != NULL ?
			v->source->two_numbers_hint :
			"");
	*(*out)++ = ']';
	*(*out)++ = '\n';
	return s + 1;
}

/* Replaces the text of an array of points, or of one point, by a line for each point,
 * and returns the size of the lines. These fit into the text, as a comma or bracket is
 * before each point; the newline of a single point may take the byte after the text. */
static size_t write_points(const struct value *v, const struct span *array,
    int coordinates)
{
	struct value e = { v->source, .parent = v, .unused = v->unused };
	const char *s = array->s, *end = array->end;
	char *out = (char *)array->s;

	if (!value_is(v, JSON_ARRAY))
		value_refuse_type(v, "an array of points");
	s = json_skip_blanks(s + 1, end);
	if (*s != '[' && *s != '{' && *s != ']') {
		e = *v;
		s = array->s;
	}
	for (; s < end && *s != ']'; e.index++)
		s = json_next_item(write_point(&e, s, end, coordinates, &out), end);
	return (size_t)(out - array->s);
}

unsigned document_used_members(const struct document_wants *w)
{
	bool angles = (w->used & (SCENE_CAMERA | SCENE_PROJECTION)) != 0;

	return w->used | SCENE_CONVENTION | (angles ? SCENE_ANGLE_UNIT : 0) |
	    (w->flat_members != 0 ? SCENE_WINDOW | SCENE_DEVICE : 0);
}

/* Sets m[i] to the member of a faulty document that may mean the object with bit i, if
 * this is not `seen`. Returns these objects as bits. */
static unsigned find_meant(const struct value *root, unsigned seen,
    struct value m[SCENE_MEMBERS])
{
	unsigned meant = 0;

	for (struct value v = value_child(root); v.item != NULL; value_next(&v)) {
		const struct member *row = object_meant(&v, scene_members, 0);
		const ptrdiff_t i = row != NULL ? row - scene_members : 0;

		if (row == NULL || row->members == NULL || (seen >> i & 1) != 0)
			continue;
		m[i] = v;
		meant |= 1u << i;
	}
	return meant;
}

/* Sets m[i] to the member with bit i, and returns the members of the document as bits.
 * If it has none, or only angle_unit, the document itself is w->lone_member. */
static unsigned find_members(struct json_source *source, const struct value *root,
    const struct document_wants *w, struct value m[SCENE_MEMBERS])
{
	unsigned seen = 0;

	if (!value_is(root, JSON_OBJECT))
		value_refuse_type(root, "an object, {...},");
	for (int i = 0; i < SCENE_MEMBERS; i++)
		if (value_member(root, scene_members[i].name, &m[i]))
			seen |= 1u << i;
	source->used = document_used_members(w);
	if (w->lone_member == 0 || (seen & ~(unsigned)SCENE_ANGLE_UNIT) != 0) {
		if (object_read(root, &scene_row, 0, NULL).faulty)
			seen |= find_meant(root, seen, m);
		return seen;
	}
	const int lone = __builtin_ctz(w->lone_member);

	source->row = &scene_members[lone];
	m[lone] = *root;
	return seen | w->lone_member;
}

/* Tells that a document lacks a member, or is 2D where the command is not. */
static void check_members(const struct value *root, const struct document_wants *w,
    unsigned seen)
{
	const unsigned missing = w->needed & ~seen;
	const unsigned flat = seen & (SCENE_WINDOW | SCENE_DEVICE);
	const struct member *row =
	    &scene_members[missing != 0 ? __builtin_ctz(missing) : 0];

	if (w->flat_members == 0 && (w->used & SCENE_SPATIAL) == SCENE_SPATIAL &&
	    (seen & SCENE_SPATIAL) == 0 && (flat & ~w->used) != 0)
		value_fault(VALUE_MISSING(root,
				scene_members[__builtin_ctz(flat)].name),
		    "is of two dimensions; so are w2n, n2w, n2d, d2n, w2d and d2w");
	else if (missing != 0 && (w->used & SCENE_SPATIAL) == 0 &&
	    (seen & SCENE_SPATIAL) != 0)
		value_fault(VALUE_MISSING(root, row->name),
		    "missing; of a scene of three dimensions 'project', its --from and "
		    "--to, --ray and --plane do this");
	else if (missing != 0)
		value_fault(VALUE_MISSING(root, row->name), "missing; add \"%s\": %s%s",
		    row->name, row->example,
		    w->flat_members != 0 ? ", or for two dimensions \"window\": {}" :
					   "");
}

static void read_members(struct document *d, const struct value m[SCENE_MEMBERS],
    unsigned bits)
{
	for (int i = 0; i < SCENE_MEMBERS; i++)
		if (bits >> i & 1)
			object_read_member(&m[i], &scene_members[i], d);
}

/* Returns whether a "convention" gives a member, as each name of one does. */
static bool convention_gives(const struct value *v, const char *name)
{
	struct value given;

	return value_is(v, JSON_OBJECT) ? value_member(v, name, &given) :
					  v->item != NULL;
}

/* Returns the member of a camera that needs the axes of a convention, or NULL. */
static const char *find_needs_axes(const struct camera *c)
{
	if (c->way == CAMERA_RVEC || c->way == CAMERA_RVEC_TRANSLATION)
		return "rvec";
	if (c->steps.step != NULL && c->way == CAMERA_POSE)
		return "pose";
	return c->steps.step != NULL && c->way == CAMERA_MATRIX ? "matrix" : NULL;
}

/* A device without "origin" takes it from -c or, without -c, from the document's. */
static void complete_scene(struct document *d, const struct document_wants *w,
    const struct value m[SCENE_MEMBERS], unsigned seen)
{
	struct scene *s = &d->scene;
	const struct convention *answer = w->convention;
	const char *needs_axes = find_needs_axes(&s->camera);
	struct value given;

	s->camera.unit = (enum angle_unit)d->source.unit;
	s->projection.without_camera = !s->has_camera;
	d->written.angle_unit = (seen & SCENE_ANGLE_UNIT) != 0;
	d->written.scale = s->has_viewport &&
	    value_member(&m[ROW_OF(VIEWPORT)], "scale", &given);
	d->has_eye = s->has_camera &&
	    (s->camera.way >= CAMERA_TRANSLATION ||
		value_member(&m[ROW_OF(CAMERA)], "eye", &given));
	if (needs_axes != NULL)
		convention_require(&m[ROW_OF(CAMERA)], needs_axes);
	if (s->has_viewport && s->viewport.distance &&
	    (value_member(&m[ROW_OF(VIEWPORT)], "min_z", &given) ||
		value_member(&m[ROW_OF(VIEWPORT)], "max_z", &given)))
		value_fault(&given,
		    "not together with \"depth\": \"distance\"; it is for \"buffer\"");
	if (seen & SCENE_PROJECTION)
		projection_complete(&m[ROW_OF(PROJECTION)],
		    s->has_viewport ? &s->viewport : NULL, &s->projection);
	if (s->has_device && answer == NULL &&
	    convention_gives(&m[ROW_OF(CONVENTION)], "origin"))
		answer = &s->convention;
	if (s->has_device && answer != NULL &&
	    !value_member(&m[ROW_OF(DEVICE)], "origin", &given))
		s->device.top_left = !answer->origin_bottom_left;
	if ((w->used & SCENE_MARGIN) == 0)
		s->margin = 0;
}

void document_read(struct document *d, const char *name, char *text, size_t size,
    const struct document_wants *wants)
{
	struct document_wants w = *wants;
	struct json_source *source = &d->source;
	struct span points;
	struct value m[SCENE_MEMBERS];
	const unsigned first = SCENE_CONVENTION | SCENE_ANGLE_UNIT;

	*d = (struct document){ .source = wants->source };
	source->name = name;
	source->scene_members = scene_members;
	source->row = &scene_row;
	const struct value root = value_parse_document(source, "/points", text, size,
	    &points);
	const unsigned seen = find_members(source, &root, wants, m);

	d->flat = (seen & SCENE_PROJECTION) == 0 && (seen & w.flat_members) != 0;
	source->flat = d->flat;
	if (d->flat) {
		w.needed = 0;
		w.used = document_used_members(wants) & ~(unsigned)SCENE_SPATIAL;
		w.coordinates = w.coordinates > 0 ? 2 : 0;
	}
	for (int i = 0; i < SCENE_MEMBERS; i++)
		m[i].unused = (w.used >> i & 1) == 0;
	d->scene.convention = w.convention != NULL ? *w.convention :
						     conventions[CONVENTION_D3D];
	const size_t faults = json_faults.n;

	read_members(d, m, seen & first);
	/* a wrong convention would give them */
	source->has_axes = w.convention != NULL || json_faults.n != faults;
	for (const struct member *row = convention_members; row->name != NULL; row++)
		source->has_axes |= convention_gives(&m[ROW_OF(CONVENTION)], row->name);
	d->written.convention = source->has_axes || (seen & SCENE_CONVENTION) != 0;
	if (w.convention != NULL &&
	    memcmp(w.convention, &d->scene.convention, sizeof d->scene.convention) != 0)
		d->scene.answer = w.convention;
	source->column_vectors = d->scene.convention.column_vectors;
	check_members(&root, &w, seen);
	read_members(d, m, seen & ~(first | SCENE_POINTS));
	complete_scene(d, &w, m, seen);
	if (json_faults.n > 0)
		value_give_up(&root);
	if (seen & SCENE_POINTS) {
		d->points_size = write_points(&m[ROW_OF(POINTS)], &points,
		    w.coordinates);
		d->points = w.coordinates > 0 ? points.s : NULL;
	}
}

char *document_read_points(const char *name, char *text, size_t size, int coordinates,
    const char *two_numbers_hint, size_t *points_size)
{
	struct json_source source = { .name = name,
		.two_numbers_hint = two_numbers_hint,
		.is_operand = true,
		.scene_members = scene_members };
	struct span points;
	struct value root = value_parse_document(&source, "", text, size, &points);

	*points_size = write_points(&root, &points, coordinates);
	return (char *)points.s;
}

/* Returns the place to which the first n bytes of s, a JSON pointer, lead, and writes
 * the pointer. If the document is a camera, "/camera/up" becomes "/up". */
static struct place document_place(const struct document *d, const char *s, size_t n,
    char pointer[POINTER_ROOM])
{
	const char *name = d->source.row->name;
	const size_t lone = name != NULL ? strlen(name) : 0;

	if (lone > 0 && n > lone && strncmp(s + 1, name, lone) == 0 &&
	    (n == lone + 1 || s[lone + 1] == '/')) {
		s += lone + 1;
		n -= lone + 1;
	}
	snprintf(pointer, POINTER_ROOM, "%.*s", (int)n, s);
	return json_source_place(&d->source, pointer);
}

void document_refuse(const struct document *d, const char *reason)
{
	const size_t n = *reason == '/' ? strcspn(reason, ":") : 0;
	char pointer[POINTER_ROOM];
	const struct place place = document_place(d, reason, n, pointer);

	die_at(EXIT_INPUT, &place, "%s", n > 0 ? reason + n + 2 : reason);
}

void document_note(const struct document *d, const char *pointer, const char *text)
{
	char of_document[POINTER_ROOM];
	const struct place place = document_place(d, pointer, strlen(pointer),
	    of_document);

	say_at(SAY_NOTE, &place, "%s", text);
}

void document_refuse_if(const struct document *d, const char *reason)
{
	if (reason != NULL)
		document_refuse(d, reason);
}

static void put_document(struct printer *p, const struct document *d, unsigned bits)
{
	p->column_vectors = d->scene.convention.column_vectors;
	object_print(p, &scene_row, 0, bits, d);
}

void put_scene(struct printer *p, const struct scene *s)
{
	struct document d = { .scene = *s };
	struct projection_shear *shear = &d.scene.projection.shear;

	/* the world is printed as it was given, with its angles in radians; the other
	 * angles that inspect finds are in degrees */
	d.source.unit = s->has_world ? s->world.unit : ANGLE_DEGREES;
	if (d.source.unit == ANGLE_RADIANS) {
		shear->projector_angle *= PI / 180;
		shear->direction *= PI / 180;
	}
	put_document(p, &d, SCENE_CONVENTION | SCENE_ANGLE_UNIT | SCENE_SPATIAL);
}

void put_device(struct printer *p, const struct device *d)
{
	scene_members[ROW_OF(DEVICE)].type->print(p, &scene_members[ROW_OF(DEVICE)], d);
}

void document_print(const struct document *d, bool compact)
{
	static char text[1 << 16];
	struct printer p = { .at = text, .compact = compact };
	unsigned unprinted = SCENE_POINTS | SCENE_BOUNDS;

	put_document(&p, d, ~(unprinted | (d->flat ? SCENE_SPATIAL : 0u)));
	put_text(&p, "\n");
	output_write(text, (size_t)(p.at - text));
}
