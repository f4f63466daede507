/* SPDX-License-Identifier: MIT */
#include "document.h"

#include <stdio.h>
#include <string.h>

#include "../json/look.h"
#include "../json/point_list.h"
#include "../message/message.h"
#include "convention_member.h"
#include "projection_member.h"
#include "types.h"

/* The members that decide how others are read. */
enum { FIRST = SCENE_CONVENTION | SCENE_ANGLE_UNIT };

/* The document itself as a member, for object_read and object_print. */
static const struct member scene_row = { .members = scene_members };

unsigned document_used_members(const struct document_wants *w)
{
	bool angles = (w->used & (SCENE_CAMERA | SCENE_PROJECTION)) != 0;

	return w->used | SCENE_CONVENTION | (angles ? SCENE_ANGLE_UNIT : 0) |
	    (w->flat_members != 0 ? SCENE_WINDOW | SCENE_DEVICE : 0);
}

/* Sets m[i] to the member with bit i, *seen to the members of the document as bits, and
 * *meant to those that unknown ones may mean. If it has none, or only angle_unit, the
 * document itself is w->lone_member. Returns false if the document is no object. */
static bool find_scene_members(struct json_source *source, const struct value *root,
    const struct document_wants *w, struct value m[SCENE_ROWS], unsigned *seen,
    unsigned *meant)
{
	struct found found;

	*seen = *meant = 0;
	if (!value_is(root, JSON_OBJECT))
		return value_refuse_type(root, "an object, {...},");
	for (int i = 0; i < SCENE_ROWS; i++)
		if (object_member(root, &scene_members[i], &m[i]))
			*seen |= 1u << i;
	if (w->lone_member == 0 || (*seen & ~(unsigned)SCENE_ANGLE_UNIT) != 0) {
		object_read(root, &scene_row, 0, NULL, &found);
		*meant = (unsigned)found.meant;
		return true;
	}
	const int lone = __builtin_ctz(w->lone_member);

	source->row = &scene_members[lone];
	m[lone] = *root;
	*seen |= w->lone_member;
	return true;
}

/* Refuses a document that lacks a member, or is 2D where the command is not. It has the
 * members `seen`, and unknown ones may mean others. */
static void check_members(const struct value *root, const struct document_wants *w,
    unsigned seen, unsigned meant)
{
	const bool may_be_flat = (meant & w->flat_members) != 0;
	const unsigned missing = may_be_flat ? 0 : w->needed & ~(seen | meant);
	const unsigned flat = seen & (SCENE_WINDOW | SCENE_DEVICE);
	const struct member *row =
	    &scene_members[missing != 0 ? __builtin_ctz(missing) : 0];

	if (w->flat_members == 0 && (w->used & SCENE_SPATIAL) == SCENE_SPATIAL &&
	    ((seen | meant) & SCENE_SPATIAL) == 0 && (flat & ~w->used) != 0)
		value_refuse(VALUE_NAMED(root, scene_members[__builtin_ctz(flat)].name),
		    "is of two dimensions", "so are w2n, n2w, n2d, d2n, w2d and d2w");
	else if (missing != 0 && (w->used & SCENE_SPATIAL) == 0 &&
	    ((seen | meant) & SCENE_SPATIAL) != 0)
		value_refuse(VALUE_NAMED(root, row->name), "missing",
		    "of a scene of three dimensions 'project', its --from and --to, "
		    "--ray and --plane do this");
	else if (missing != 0)
		value_refuse(VALUE_NAMED(root, row->name), "missing",
		    text("add \"%s\": %s%s", row->name, row->example,
			w->flat_members != 0 ?
			    ", or for two dimensions \"window\": {}" :
			    ""));
}

static void read_members(struct document *d, const struct value m[SCENE_ROWS],
    unsigned bits)
{
	for (int i = 0; i < SCENE_ROWS; i++) {
		d->source.is_camera = i == SCENE_ROW_CAMERA;
		if (bits >> i & 1)
			object_read_member(&m[i], &scene_members[i], d);
	}
}

/* Returns whether an object of the scene has the member `name`. */
static bool object_has(const struct value m[SCENE_ROWS], enum scene_row row,
    const char *name)
{
	struct value given;

	return m[row].item != NULL &&
	    object_member(&m[row], member_named(scene_members[row].members, 0, name),
		&given);
}

/* Returns whether a world, or a camera's matrix or steps, have a matrix of four rows of
 * four numbers without "vectors", so that only a convention says which vectors its rows
 * are for. */
static bool has_bare_rows(const struct value *v)
{
	struct value e = value_child(v), given;

	if (value_is(v, JSON_ARRAY) && value_count(v) == 4 && value_count(&e) == 4)
		return true;
	if (value_is(v, JSON_OBJECT) &&
	    object_member(v, member_named(step_members, 0, "vectors"), &given))
		return false;
	for (; e.item != NULL; value_next(&e))
		if (!(e.name != NULL && *e.name == '_') && has_bare_rows(&e))
			return true;
	return false;
}

/* Refuses a camera that needs a convention, which says where the axes of view space
 * point, where none is named, unless axes stand in for it. A gaze and up mean the same
 * in all conventions. */
static void check_camera(const struct value m[SCENE_ROWS], const struct camera *c)
{
	static const char *const names[] = { "orientation", "rvec", "rotation",
		"translation", "pose", "matrix", NULL };
	const struct value *v = &m[SCENE_ROW_CAMERA];
	int i = 0;

	while (names[i] != NULL && !object_has(m, SCENE_ROW_CAMERA, names[i]))
		i++;
	if (camera_is_by_gaze(c) || names[i] == NULL)
		return;
	if (!c->has_axes)
		convention_require(v, names[i], ", or give the camera \"axes\"");
	else if (has_bare_rows(v))
		convention_require(v, names[i],
		    ", or write {\"matrix\": [...], \"vectors\": \"column\"} (or "
		    "\"row\")");
}

static void check_distance(const struct value m[SCENE_ROWS])
{
	static const char *const names[] = { "min_z", "max_z" };

	for (int i = 0; i < 2; i++)
		if (object_has(m, SCENE_ROW_VIEWPORT, names[i])) {
			value_refuse(VALUE_NAMED(&m[SCENE_ROW_VIEWPORT], names[i]),
			    "not together with \"depth\": \"distance\"",
			    "it is for \"buffer\"");
			return;
		}
}

/* Sets the origin of a device that gives none: to that of -c or, without -c, of the
 * document's convention; without either, y points down if the window's does. */
static void set_device_origin(struct scene *s, const struct document_wants *w,
    const struct value m[SCENE_ROWS])
{
	if (object_has(m, SCENE_ROW_DEVICE, "origin"))
		return;
	if (w->convention != NULL)
		s->device.top_left = !w->convention->origin_bottom_left;
	else if (value_string(&m[SCENE_ROW_CONVENTION]) != NULL || /* each name does */
	    object_has(m, SCENE_ROW_CONVENTION, "origin"))
		s->device.top_left = !s->convention.origin_bottom_left;
	else if (window_has_y_down(&s->window))
		s->device.top_left = true;
}

/* Completes the scene that was read by what follows from several members, and notes
 * which of them the document has. */
static void complete_scene(struct document *d, const struct document_wants *w,
    const struct value m[SCENE_ROWS], unsigned seen)
{
	/* stands for a viewport whose lack is told, so that no other message follows
	 * from it */
	static const struct viewport assumed = { .width = 1, .height = 1 };
	const bool told = ((w->needed | d->present) & SCENE_VIEWPORT) != 0;
	struct scene *s = &d->scene;

	s->camera.unit = (enum angle_unit)d->source.unit;
	s->projection.without_camera = !s->has_camera;
	d->written.angle_unit = (seen & SCENE_ANGLE_UNIT) != 0;
	d->written.world_rows = s->has_world && has_bare_rows(&m[SCENE_ROW_WORLD]);
	d->written.scale = s->has_viewport &&
	    object_has(m, SCENE_ROW_VIEWPORT, "scale");
	d->has_eye = s->has_camera &&
	    (!camera_has_eye(&s->camera) || object_has(m, SCENE_ROW_CAMERA, "eye"));
	s->camera.has_default_up = s->has_camera &&
	    !object_has(m, SCENE_ROW_CAMERA, "up");
	/* also one without members, which is d3d's, is written */
	if (s->has_camera && !d->written.convention)
		check_camera(m, &s->camera);
	if (s->has_viewport && s->viewport.distance)
		check_distance(m);
	if (seen & SCENE_PROJECTION)
		projection_complete(&m[SCENE_ROW_PROJECTION],
		    s->has_viewport ? &s->viewport :
			told        ? &assumed :
				      NULL,
		    &s->projection);
	if (s->has_device)
		set_device_origin(s, w, m);
	if ((w->used & SCENE_MARGIN) == 0)
		s->margin = 0;
}

/* Reads the convention and the unit of angles, which decide how others are read. */
static void read_first(struct document *d, const struct document_wants *w,
    const struct value m[SCENE_ROWS], unsigned seen)
{
	struct json_source *source = &d->source;

	d->scene.convention = w->convention != NULL ? *w->convention :
						      conventions[CONVENTION_D3D];
	read_members(d, m, seen & SCENE_ANGLE_UNIT);
	const size_t faults = source->faults->n;

	read_members(d, m, seen & SCENE_CONVENTION);
	source->is_convention_wrong = source->faults->n != faults;
	/* an object without members is d3d */
	source->has_convention = w->convention != NULL ||
	    (seen & SCENE_CONVENTION) != 0;
	d->written.convention = source->has_convention;
	if (w->convention != NULL &&
	    memcmp(w->convention, &d->scene.convention, sizeof d->scene.convention) !=
		0)
		d->scene.answer = w->convention;
	source->column_vectors = d->scene.convention.column_vectors;
}

/* Cuts the points of the document from its text. */
static void cut_points(struct document *d, const struct value *v, struct span points,
    int coordinates)
{
	if (!value_is(v, JSON_ARRAY)) {
		value_refuse_type(v, "an array of points");
	} else if (points.s == NULL) {
		value_refuse(v, "its name has an escape", "write \"points\"");
	} else if (points_cut(v, &points, coordinates) && coordinates > 0) {
		d->points = points.s;
		d->points_size = (size_t)(points.end - points.s);
	}
}

bool document_read(struct document *d, const char *name, char *begin, size_t size,
    const struct document_wants *wants)
{
	struct document_wants w = *wants;
	struct json_source *source = &d->source;
	struct value root, m[SCENE_ROWS];
	struct span points;
	unsigned seen, meant;

	*d = (struct document){ .source = wants->source };
	source->name = name;
	source->scene_members = scene_members;
	source->row = &scene_row;
	d->ends_run = !value_parse_document(source, begin, size, &root, &points);
	source->root = d->ends_run ? NULL : root.item;
	if (d->ends_run || !find_scene_members(source, &root, wants, m, &seen, &meant))
		return false;
	d->flat = (seen & SCENE_PROJECTION) == 0 && (seen & w.flat_members) != 0;
	source->flat = d->flat;
	if (d->flat) {
		w.needed = 0;
		w.used = document_used_members(wants) & ~(unsigned)SCENE_SPATIAL;
		w.coordinates = w.coordinates > 0 ? 2 : 0;
	}
	for (int i = 0; i < SCENE_ROWS; i++)
		m[i].unused = (w.used >> i & 1) == 0;
	check_members(&root, &w, seen, meant);
	read_first(d, &w, m, seen);
	read_members(d, m, seen & ~(unsigned)(FIRST | SCENE_POINTS));
	d->present = seen | meant;
	complete_scene(d, &w, m, seen);
	if (seen & SCENE_POINTS)
		cut_points(d, &m[SCENE_ROW_POINTS], points, w.coordinates);
	return source->faults->n == 0;
}

bool document_read_points(struct json_source *source, char *begin, size_t size,
    int coordinates, struct span *points)
{
	const struct value root = { .source = source };

	return look_for_array(source, begin, size, points) &&
	    points_cut(&root, points, coordinates);
}

enum { POINTER_ROOM = sizeof((struct refusal *)NULL)->where };

/* Sets *v to the member of *v that a token of a pointer names: itself, or by the name
 * of its row. Returns its row, or NULL. */
static const struct member *enter_member(struct value *v, const struct member *table,
    const char *token)
{
	const struct member *row = member_named(table, ANY_VARIANT, token);
	struct value m = value_child(v);

	while (m.item != NULL && strcmp(m.name, token) != 0)
		value_next(&m);
	if (row == NULL ||
	    (m.item == NULL &&
		(strcmp(row->name, token) != 0 || !object_member(v, row, &m))))
		return NULL;
	*v = (struct value){ .source = v->source, .name = m.name, .item = m.item };
	return row;
}

/* Copies a pointer, with the names that the document has: /near may be its /zNear. */
static void write_given_names(const struct json_source *source, const char *pointer,
    char out[POINTER_ROOM])
{
	struct value v = { .source = source, .item = source->root };
	const struct member *row = source->row;
	char token[POINTER_ROOM];
	size_t n = 0;

	while (row != NULL && *pointer == '/' && value_is(&v, JSON_OBJECT)) {
		const int size = (int)strcspn(pointer + 1, "/");

		snprintf(token, sizeof token, "%.*s", size, pointer + 1);
		row = enter_member(&v, row->members, token);
		if (row == NULL || n + strlen(v.name) + 1 >= POINTER_ROOM)
			break;
		n += (size_t)sprintf(out + n, "/%s", v.name);
		pointer += size + 1;
	}
	snprintf(out + n, POINTER_ROOM - n, "%s", pointer);
}

/* Returns the place to which a JSON pointer leads, and writes the pointer to out. If
 * the document is a camera, "/camera/up" becomes "/up". */
static struct place document_place(const struct json_source *source,
    const char *pointer, char out[POINTER_ROOM])
{
	const char *name = source->row != NULL ? source->row->name : NULL;
	const size_t lone = name != NULL ? strlen(name) : 0;

	if (lone > 0 && *pointer == '/' && strncmp(pointer + 1, name, lone) == 0 &&
	    (pointer[lone + 1] == '\0' || pointer[lone + 1] == '/'))
		pointer += lone + 1;
	write_given_names(source, pointer, out);
	return look_at_pointer(source, out);
}

bool document_refuse(const struct document *d, const char *where, const char *what,
    const char *remedy)
{
	return refuse(d->source.faults, where, what, remedy);
}

void document_tell(const struct json_source *source, int status)
{
	const struct refusals *f = source->faults;
	const size_t kept = f->n < REFUSALS_MAX ? f->n : REFUSALS_MAX;
	char pointer[POINTER_ROOM];

	for (size_t i = 0; i < kept; i++) {
		const struct refusal *r = &f->list[i];
		struct place place = document_place(source, r->where, pointer);

		if (r->line > 0) {
			place.line = r->line;
			place.column = r->column;
		}
		say_at(status, &place, r->what, r->remedy);
	}
	if (f->n > kept) {
		const struct place place = document_place(source, "", pointer);

		say_at(status, &place, text("%zu more faults", f->n - kept), NULL);
	}
}

void document_note(const struct document *d, const char *pointer, const char *what,
    const char *remedy)
{
	char given[POINTER_ROOM];
	const struct place place = document_place(&d->source, pointer, given);

	say_at(SAY_NOTE, &place, what, remedy);
}

static void put_document(struct printer *p, const struct document *d, unsigned bits)
{
	p->column_vectors = d->scene.convention.column_vectors;
	object_print(p, &scene_row, 0, bits, d);
}

void put_scene(struct printer *p, const struct scene *s)
{
	struct document d = { .scene = *s };

	/* The world is printed as it was given, and the other angles that inspect finds
	 * are in its unit or, without one, in that of the projection's. */
	d.source.unit = s->has_world              ? s->world.unit :
	    projection_is_sheared(&s->projection) ? s->projection.unit :
						    ANGLE_DEGREES;
	put_document(p, &d, SCENE_CONVENTION | SCENE_ANGLE_UNIT | SCENE_SPATIAL);
}

void document_print(const struct document *d, bool compact)
{
	static char text[1 << 16];
	struct printer p = { .at = text, .compact = compact };
	unsigned unprinted = SCENE_POINTS | SCENE_BOUNDS;

	if (d->flat)
		unprinted |= SCENE_SPATIAL;
	/* a device counts from another corner if a convention is named */
	if (d->flat && !d->source.has_convention)
		unprinted |= SCENE_CONVENTION;
	put_document(&p, d, ~unprinted);
	put_text(&p, "\n");
	output_write(text, (size_t)(p.at - text));
}
