#include "print_scene.h"

#include <string.h>

#include "../json/print.h"
#include "../talk.h"

static void put_member(struct printer *p, const char *name, double v)
{
	put_name(p, name);
	put_number(p, v);
}

static void put_vector(struct printer *p, const char *name, const double *v,
    int n)
{
	put_name(p, name);
	put_numbers(p, v, n);
}

static void put_choice(struct printer *p, const char *name, const char *word)
{
	put_name(p, name);
	put_word(p, word);
}

/* Left out where it is what is read when it isn't there. */
static void put_unless(struct printer *p, const char *name, double v,
    double usual)
{
	if (v != usual)
		put_member(p, name, v);
}

static bool same_convention(const struct convention *a,
    const struct convention *b)
{
	return a->right_handed == b->right_handed &&
	    a->minus_one == b->minus_one && a->column == b->column &&
	    a->ndc_y_down == b->ndc_y_down && a->bottom_left == b->bottom_left;
}

/* By name, or by what differs from d3d. */
static void put_convention(struct printer *p, const struct convention *c)
{
	static const char *const names[] = { "d3d", "gl", "vulkan", "webgpu" };
	struct convention known;

	member(p, "convention");
	for (size_t i = 0; i < sizeof names / sizeof *names; i++)
		if (convention_find(names[i], &known) &&
		    same_convention(c, &known)) {
			put_word(p, names[i]);
			return;
		}
	enter(p, "{");
	if (c->right_handed)
		put_choice(p, "handedness", "right");
	if (c->minus_one)
		put_choice(p, "depth", "minus_one_to_one");
	if (c->column)
		put_choice(p, "vectors", "column");
	if (c->ndc_y_down)
		put_choice(p, "ndc_y", "down");
	if (c->bottom_left)
		put_choice(p, "origin", "bottom-left");
	leave(p, "}");
}

static void put_world(struct printer *p, const double m[4][4], bool column)
{
	member(p, "world");
	enter(p, "[");
	for (int i = 0; i < 4; i++) {
		double row[4];

		for (int j = 0; j < 4; j++)
			row[j] = column ? m[j][i] : m[i][j];
		put_numbers(p, row, 4);
	}
	leave(p, "]");
}

static void put_camera(struct printer *p, const struct camera *c)
{
	member(p, "camera");
	enter(p, "{");
	put_vector(p, "eye", c->eye, 3);
	put_vector(p, "gaze", c->at, 3);
	put_vector(p, "up", c->up, 3);
	put_unless(p, "roll", c->roll, 0);
	leave(p, "}");
}

static void put_edges(struct printer *p, double left, double right,
    double bottom, double top)
{
	put_member(p, "left", left);
	put_member(p, "right", right);
	put_member(p, "bottom", bottom);
	put_member(p, "top", top);
}

/* The aspect is left out where the viewport says it. */
static void put_section(struct printer *p, const struct projection *q,
    const struct viewport *v)
{
	static const char *const angles[] = { "fovy", "fovx", "view_angle",
		"field" };

	if (q->extent == EXTENT_EDGES) {
		put_edges(p, q->left, q->right, q->bottom, q->top);
	} else if (q->extent == EXTENT_SIZE) {
		put_member(p, "width", q->width);
		put_member(p, "height", q->height);
	} else {
		put_member(p, angles[q->extent], q->angle);
		if (v == NULL || q->aspect[1] == 1)
			put_member(p, "aspect", q->aspect[0]);
	}
}

static void put_shear(struct printer *p, const struct projection *q)
{
	if (q->kind == OBLIQUE_ANGLE)
		put_member(p, "angle", q->projector);
	else
		put_choice(p, "kind",
		    q->kind == OBLIQUE_CABINET ? "cabinet" : "cavalier");
	put_unless(p, "direction", q->direction, 45);
	put_unless(p, "plane", q->plane, 0);
}

static void put_projection(struct printer *p, const struct projection *q,
    const struct viewport *v)
{
	member(p, "projection");
	enter(p, "{");
	put_choice(p, "type",
	    q->type == PROJECTION_PERSP     ? "persp" :
		q->type == PROJECTION_ORTHO ? "ortho" :
					      "oblique");
	if (q->type == PROJECTION_OBLIQUE)
		put_shear(p, q);
	put_section(p, q, v);
	put_member(p, "near", q->near);
	put_member(p, "far", q->far);
	if (q->type == PROJECTION_PERSP)
		put_unless(p, "near_ratio", q->near_ratio, 0.0005);
	if (q->reverse_z) {
		put_name(p, "reverse_z");
		put_text(p, "true");
	}
	leave(p, "}");
}

static void put_rectangle(struct printer *p, double x, double y, double width,
    double height)
{
	enter(p, "{");
	put_member(p, "x", x);
	put_member(p, "y", y);
	put_member(p, "width", width);
	put_member(p, "height", height);
}

static void put_viewport(struct printer *p, const struct viewport *v)
{
	member(p, "viewport");
	put_rectangle(p, v->x, v->y, v->width, v->height);
	put_unless(p, "min_z", v->min_z, 0);
	put_unless(p, "max_z", v->max_z, 1);
	if (v->scale == SCALE_UNIFORM)
		put_choice(p, "scale", "uniform");
	if (v->scale == SCALE_GIVEN)
		put_vector(p, "scale", v->scales, 2);
	leave(p, "}");
}

static void put_window(struct printer *p, const struct window *w)
{
	static const char *const adapts[] = { "stretch", "grow", "shrink" };

	member(p, "window");
	enter(p, "{");
	if (w->by_edges) {
		put_edges(p, w->left, w->right, w->bottom, w->top);
	} else {
		put_vector(p, "center", w->center, 2);
		put_member(p, "width", w->width);
		put_member(p, "height", w->height);
	}
	if (w->pan[0] != 0 || w->pan[1] != 0)
		put_vector(p, "pan", w->pan, 2);
	put_unless(p, "zoom", w->zoom, 1);
	if (w->has_about)
		put_vector(p, "about", w->about, 2);
	if (w->adapt != ADAPT_STRETCH)
		put_choice(p, "adapt", adapts[w->adapt]);
	leave(p, "}");
}

static void put_device(struct printer *p, const struct device *d)
{
	member(p, "device");
	put_rectangle(p, d->x, d->y, d->width, d->height);
	if (d->top_left)
		put_choice(p, "origin", "top-left");
	leave(p, "}");
}

static void put_pick(struct printer *p, const struct pick *k)
{
	member(p, "pick");
	enter(p, "{");
	if (k->has_at)
		put_vector(p, "at", k->at, 2);
	put_unless(p, "radius", k->radius, 0);
	leave(p, "}");
}

void print_scene(const struct document *d)
{
	static char text[1 << 16];
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	struct printer p = { text, shortest, "" };
	const struct scene *s = &d->scene;

	enter(&p, "{");
	put_convention(&p, &s->convention);
	if (s->has_world)
		put_world(&p, s->world, s->convention.column);
	put_camera(&p, &s->camera);
	put_projection(&p, &s->projection,
	    s->has_viewport ? &s->viewport : NULL);
	if (s->has_viewport)
		put_viewport(&p, &s->viewport);
	if (s->has_window)
		put_window(&p, &s->window);
	if (s->has_device)
		put_device(&p, &s->device);
	if (d->pick.has_at || d->pick.radius > 0)
		put_pick(&p, &d->pick);
	put_text(&p, "\n}\n");
	put_all(text, (size_t)(p.at - text));
}
