#include "document.h"

#include <stdlib.h>
#include <string.h>

#include "../json/scan.h"
#include "members.h"
#include "../talk.h"

/* Rows of scene_members; those of enum scene_member are its bits. */
enum {
	CONVENTION,
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

static const char *const hands[] = { "left", "right", NULL };
static const char *const depths[] = { "zero_to_one", "minus_one_to_one", NULL };
static const char *const vectors[] = { "row", "column", NULL };
static const char *const ys[] = { "up", "down", NULL };
static const char *const origins[] = { "top-left", "bottom-left", NULL };

#define SECOND(label, list, m)                                     \
	{                                                          \
		.name = label, .read = read_second, .words = list, \
		.at = offsetof(struct convention, m)               \
	}

static const struct member convention_members[] = {
	SECOND("handedness", hands, right_handed),
	SECOND("depth", depths, minus_one),
	SECOND("vectors", vectors, column),
	SECOND("ndc_y", ys, ndc_y_down),
	SECOND("origin", origins, bottom_left),
	{ .name = NULL },
};

static const char *const convention_names[] = { "d3d", "gl", "vulkan", "webgpu",
	NULL };
static const struct convention conventions[] = {
	{ 0 },
	{ .right_handed = true,
	    .minus_one = true,
	    .column = true,
	    .bottom_left = true },
	{ .right_handed = true, .column = true, .ndc_y_down = true },
	{ .right_handed = true, .column = true },
};

bool convention_find(const char *name, struct convention *c)
{
	for (int i = 0; convention_names[i] != NULL; i++)
		if (strcmp(name, convention_names[i]) == 0) {
			*c = conventions[i];
			return true;
		}
	return false;
}

static void read_convention(const struct value *v, struct convention *c)
{
	*c = (struct convention){ 0 };
	if (value_is_object(v))
		object_read(v, convention_members, 0, c);
	else
		*c = conventions[value_word(v, convention_names)];
}

/* Each is kept, to be read in the order in which they need one another. */
#define MEMBER(row, label, table, other, like)      \
	[row] = { .name = label,                    \
		.read = read_value,                 \
		.at = (row) * sizeof(struct value), \
		.fields = table,                    \
		.aliases = other,                   \
		.example = like }

static const struct member scene_members[SCENE_MEMBERS + 1] = {
	MEMBER(CONVENTION, "convention", convention_members, NULL, "\"d3d\""),
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

/* Returns whether it is one point and not a list of them. */
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

/* Copies a value of checked text without blanks, and a newline. */
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

/* Where in a checked document the points begin, which are all of it or a
 * member. */
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

/* A document without any of a scene's members is the bare one. */
static bool is_bare(const struct value *v, enum scene_member bare)
{
	struct value m = value_child(v);

	for (; m.item != NULL; value_next(&m))
		if (member_bit(scene_members, 0, m.name) != 0)
			return false;
	return bare != 0;
}

static unsigned read_members(struct document *d, const struct value *root,
    const struct json_wants *w, struct value m[SCENE_MEMBERS])
{
	if (!value_is_object(root))
		value_wrong(root, "an object, {...},");
	if (!is_bare(root, w->bare))
		return object_read(root, scene_members, 0, m);
	for (int i = 0; i < SCENE_MEMBERS; i++)
		if (w->bare == 1u << i) {
			d->bare = scene_members[i].name;
			m[i] = *root;
		}
	return w->bare;
}

static void check_needed(const struct value *root, unsigned missing)
{
	for (int i = 0; i <= POINTS; i++) {
		const struct member *f = &scene_members[i];
		struct value v = value_missing(root, f->name);

		if (missing >> i & 1)
			value_refuse(&v, "missing; add \"%s\": %s", f->name,
			    f->example);
	}
}

static const struct value *member(struct source *source, unsigned unused,
    const struct value m[SCENE_MEMBERS], int row)
{
	source->form = unused >> row & 1;
	return &m[row];
}

static void read_scene(struct document *d, struct source *source,
    const struct json_wants *w, struct value m[SCENE_MEMBERS], unsigned seen)
{
	struct scene *s = &d->scene;

#define READ(row) member(source, w->unused, m, row)
	s->has_world = seen & SCENE_WORLD;
	s->has_camera = seen & SCENE_CAMERA;
	s->has_viewport = seen & SCENE_VIEWPORT;
	s->has_window = seen & SCENE_WINDOW;
	s->has_device = seen & SCENE_DEVICE;
	d->has_bounds = seen & SCENE_BOUNDS;
	if (s->has_world)
		read_matrix(READ(WORLD), &scene_members[WORLD], s->world);
	if (s->has_camera)
		d->has_eye = read_camera(READ(CAMERA), &s->camera);
	if (s->has_viewport)
		read_viewport(READ(VIEWPORT), &s->viewport);
	if (seen & SCENE_PROJECTION)
		read_projection(READ(PROJECTION), w->projection,
		    s->has_viewport ? &s->viewport : NULL, &s->projection);
	if (s->has_window)
		read_window(READ(WINDOW), &s->window);
	if (s->has_device)
		read_device(READ(DEVICE), &s->device);
	if (d->has_bounds)
		read_bounds(READ(BOUNDS), &d->bounds);
	if (seen & SCENE_PICK)
		read_pick(READ(PICK), &d->pick);
#undef READ
}

void json_read(struct document *d, const char *name, char *text, size_t size,
    const struct json_wants *w)
{
	struct source source = { .name = name, .scene = scene_members };
	struct value root = value_parse(&source, text, size);
	struct value m[SCENE_MEMBERS];
	struct convention option = { 0 };

	source.fit = w->fit;
	*d = (struct document){ .name = name };
	unsigned seen = read_members(d, &root, w, m);

	if (w->convention != NULL)
		convention_find(w->convention, &option);
	d->scene.convention = option;
	if (seen & SCENE_CONVENTION)
		read_convention(&m[CONVENTION], &d->scene.convention);
	source.column = d->scene.convention.column;
	check_needed(&root, w->needed & ~seen);
	read_scene(d, &source, w, m, seen);
	source.form = false;
	if (seen & SCENE_POINTS && w->coordinates > 0)
		take_points(&m[POINTS], w->coordinates, text, size, &d->points,
		    &d->points_size);
	else if (seen & SCENE_POINTS)
		check_points(&m[POINTS], 0);
	if (w->convention != NULL)
		d->scene.convention = option;
	value_free(&root);
}

void json_points(const char *name, char *text, size_t size, int coordinates,
    char **points, size_t *points_size)
{
	struct source source = { .name = name, .scene = scene_members };
	struct value root = value_parse(&source, text, size);

	take_points(&root, coordinates, text, size, points, points_size);
	value_free(&root);
}

void json_refuse(const struct document *d, const char *why)
{
	size_t n = d->bare != NULL ? strlen(d->bare) : 0;

	/* "/camera/up: ..." to "/up: ...", "/camera: ..." to "..." */
	if (n > 0 && strncmp(why + 1, d->bare, n) == 0 &&
	    (why[n + 1] == '/' || why[n + 1] == ':'))
		why += n + 1 + (why[n + 1] == ':' ? 2 : 0);
	die(EXIT_INPUT, "%s: %s", d->name, why);
}
