/* SPDX-License-Identifier: MIT */
#include "print_scene.h"

#include <math.h>
#include <string.h>

#include "../json/print.h"
#include "convention_member.h"
#include "members.h"
#include "../message/message.h"

static void put_number_member(struct printer *p, const char *name, double v)
{
	put_name(p, name);
	put_number(p, v);
}

static void put_numbers_member(struct printer *p, const char *name,
    const double *v, int n)
{
	put_name(p, name);
	put_numbers(p, v, n);
}

static void put_string_member(struct printer *p, const char *name,
    const char *word)
{
	put_name(p, name);
	put_string(p, word);
}

/* A number is left out if it is what a reader takes for a missing one. */
static void put_unless(struct printer *p, const char *name, double v,
    double usual)
{
	if (v != usual)
		put_number_member(p, name, v);
}

static bool convention_has(const struct convention *c, const struct member *m)
{
	return *(const bool *)((const char *)c + m->at);
}

/* By name, or by what differs from d3d. */
static void put_convention(struct printer *p, const struct convention *c)
{
	put_name_on_new_line(p, "convention");
	for (int i = 0; i < CONVENTIONS; i++)
		if (same_convention(c, &conventions[i])) {
			put_string(p, convention_names[i]);
			return;
		}
	put_open(p, "{");
	for (const struct member *m = convention_members; m->name != NULL; m++)
		if (convention_has(c, m))
			put_string_member(p, m->name, m->words[1]);
	put_close(p, "}");
}

static void put_world(struct printer *p, const double m[4][4], bool column)
{
	put_name_on_new_line(p, "world");
	put_open(p, "[");
	for (int i = 0; i < 4; i++) {
		double row[4];

		for (int j = 0; j < 4; j++)
			row[j] = column ? m[j][i] : m[i][j];
		put_numbers(p, row, 4);
	}
	put_close(p, "]");
}

static void put_camera(struct printer *p, const struct camera *c)
{
	put_name_on_new_line(p, "camera");
	put_open(p, "{");
	put_numbers_member(p, "eye", c->eye, 3);
	put_numbers_member(p, "gaze", c->at, 3);
	put_numbers_member(p, "up", c->up, 3);
	put_unless(p, "roll", c->roll, 0);
	put_close(p, "}");
}

void put_edges(struct printer *p, double left, double right, double bottom,
    double top)
{
	put_number_member(p, "left", left);
	put_number_member(p, "right", right);
	put_number_member(p, "bottom", bottom);
	put_number_member(p, "top", top);
}

/* As P, or where there is no offset K, or without skew four numbers. */
static void put_intrinsics(struct printer *p, const double k[3][4])
{
	const double four[4] = { k[0][0], k[1][1], k[0][2], k[1][2] };
	bool offset = k[0][3] != 0 || k[1][3] != 0 || k[2][3] != 0 ||
	    k[1][0] != 0 || k[2][0] != 0 || k[2][1] != 0 || k[2][2] != 1 ||
	    !(k[0][0] > 0) || !(k[1][1] > 0);

	if (!offset && k[0][1] == 0) {
		put_numbers_member(p, "intrinsics", four, 4);
		return;
	}
	put_name(p, "intrinsics");
	put_open(p, "[");
	for (int i = 0; i < 3; i++)
		put_numbers(p, k[i], offset ? 4 : 3);
	put_close(p, "]");
}

/* The cross-section. The aspect is left out if it is the viewport's. */
static void put_section(struct printer *p, const struct projection *q,
    const struct viewport *v)
{
	static const char *const angles[] = { "fovy", "fovx", "view_angle",
		"field" };
	const double edges[4] = { q->left, q->right, q->bottom, q->top };

	if (q->extent == EXTENT_EDGES) {
		put_edges(p, q->left, q->right, q->bottom, q->top);
	} else if (q->extent == EXTENT_SIZE) {
		put_number_member(p, "width", q->width);
		put_number_member(p, "height", q->height);
	} else if (q->extent == EXTENT_ANGLES) {
		put_numbers_member(p, "angles", edges, 4);
	} else if (q->extent == EXTENT_INTRINSICS) {
		put_intrinsics(p, q->intrinsics);
	} else {
		put_number_member(p, angles[q->extent], q->angle);
		if (v == NULL || q->aspect[1] == 1)
			put_number_member(p, "aspect", q->aspect[0]);
	}
}

static void put_shear(struct printer *p, const struct projection *q)
{
	if (q->kind == OBLIQUE_ANGLE)
		put_number_member(p, "angle", q->projector);
	else
		put_string_member(p, "kind",
		    oblique_kinds[q->kind - OBLIQUE_CAVALIER]);
	if (q->direction != 45 || q->direction_unit == RADIANS)
		put_number_member(p, "direction", q->direction);
	put_unless(p, "plane", q->plane, 0);
}

void put_distance(struct printer *p, double v)
{
	if (isinf(v))
		put_string(p, "infinity");
	else
		put_number(p, v);
}

static void put_depth(struct printer *p, const struct projection *q)
{
	put_number_member(p, "near", q->near);
	put_name(p, "far");
	put_distance(p, q->far);
	if (q->reverse_z) {
		put_name(p, "reverse_z");
		put_flag(p, true);
	}
}

/* The larger half side is times the aspect, where that isn't the viewport's. */
static void put_seven(struct printer *p, const struct projection *q,
    const struct viewport *v)
{
	if (q->aspect[1] == 0) {
		put_number_member(p, "half_width", q->half_width);
		put_number_member(p, "half_height", q->half_height);
	} else {
		put_number_member(p, "size", 2 * q->half_width);
		if (v == NULL || q->aspect[1] == 1)
			put_number_member(p, "aspect", q->aspect[0]);
	}
	put_number_member(p, "z_near", q->z_near);
	put_number_member(p, "z_far", q->z_far);
	if (q->has_eye) {
		put_numbers_member(p, "eye", q->eye, 3);
		return;
	}
	if (q->has_angle)
		put_number_member(p, "view_angle", q->angle);
	else
		put_unless(p, "inverse_eye_z", q->inverse_eye_z, 0);
	if (q->tan_skew[0] != 0 || q->tan_skew[1] != 0)
		put_numbers_member(p, "tan_skew", q->tan_skew, 2);
}

static void put_projection(struct printer *p, const struct projection *q,
    const struct viewport *v)
{
	put_name_on_new_line(p, "projection");
	put_open(p, "{");
	put_string_member(p, "type",
	    projection_types[q->type - PROJECTION_PERSP]);
	if (q->type == PROJECTION_OBLIQUE)
		put_shear(p, q);
	if (q->type == PROJECTION_VOLUME)
		put_seven(p, q, v);
	else
		put_section(p, q, v);
	if (q->type == PROJECTION_PERSP)
		put_unless(p, "edges_at", q->edges_at, 0);
	if (q->type != PROJECTION_VOLUME && !projection_is_open(q))
		put_depth(p, q);
	if (q->type == PROJECTION_PERSP || q->type == PROJECTION_VOLUME)
		put_unless(p, "near_ratio", q->near_ratio, 0.0005);
	put_close(p, "}");
}

static void put_rectangle(struct printer *p, double x, double y, double width,
    double height)
{
	put_open(p, "{");
	put_number_member(p, "x", x);
	put_number_member(p, "y", y);
	put_number_member(p, "width", width);
	put_number_member(p, "height", height);
}

static void put_viewport(struct printer *p, const struct viewport *v)
{
	put_name_on_new_line(p, "viewport");
	put_rectangle(p, v->x, v->y, v->width, v->height);
	put_unless(p, "min_z", v->min_z, 0);
	put_unless(p, "max_z", v->max_z, 1);
	if (v->scale == SCALE_UNIFORM)
		put_string_member(p, "scale", "uniform");
	if (v->scale == SCALE_GIVEN)
		put_numbers_member(p, "scale", v->scales, 2);
	put_close(p, "}");
}

static void put_window(struct printer *p, const struct window *w)
{
	put_name_on_new_line(p, "window");
	put_open(p, "{");
	if (w->by_edges) {
		put_edges(p, w->left, w->right, w->bottom, w->top);
	} else {
		put_numbers_member(p, "center", w->center, 2);
		put_number_member(p, "width", w->width);
		put_number_member(p, "height", w->height);
	}
	if (w->pan[0] != 0 || w->pan[1] != 0)
		put_numbers_member(p, "pan", w->pan, 2);
	put_unless(p, "zoom", w->zoom, 1);
	if (w->has_about)
		put_numbers_member(p, "about", w->about, 2);
	if (w->adapt != ADAPT_STRETCH)
		put_string_member(p, "adapt", adapt_names[w->adapt]);
	put_close(p, "}");
}

void put_device(struct printer *p, const struct device *d)
{
	put_name_on_new_line(p, "device");
	put_rectangle(p, d->x, d->y, d->width, d->height);
	if (d->top_left)
		put_string_member(p, "origin", "top-left");
	put_close(p, "}");
}

static void put_pick(struct printer *p, const struct pick *k)
{
	put_name_on_new_line(p, "pick");
	put_open(p, "{");
	if (k->has_at)
		put_numbers_member(p, "at", k->at, 2);
	put_unless(p, "radius", k->radius, 0);
	put_close(p, "}");
}

/* What leads from model space to the device. */
static void put_stages(struct printer *p, const struct scene *s)
{
	if (s->has_world)
		put_world(p, s->world, s->convention.column);
	put_camera(p, &s->camera);
	put_projection(p, &s->projection,
	    s->has_viewport ? &s->viewport : NULL);
	if (s->has_viewport)
		put_viewport(p, &s->viewport);
}

void put_scene(struct printer *p, const struct scene *s)
{
	put_open(p, "{");
	p->on_line = true;
	put_convention(p, &s->convention);
	put_stages(p, s);
	p->on_line = false;
	put_close(p, "}");
}

void print_scene(const struct document *d)
{
	static char text[1 << 16];
	struct printer p = { .at = text, .between = "" };
	const struct scene *s = &d->scene;

	put_open(&p, "{");
	put_convention(&p, &s->convention);
	if (d->unit == RADIANS) {
		put_name_on_new_line(&p, "angle_unit");
		put_string(&p, angle_units[RADIANS]);
	}
	if (!d->flat)
		put_stages(&p, s);
	if (s->has_window)
		put_window(&p, &s->window);
	if (s->has_device)
		put_device(&p, &s->device);
	if (d->pick.has_at || d->pick.radius > 0)
		put_pick(&p, &d->pick);
	if (s->margin > 0) {
		put_name_on_new_line(&p, "margin");
		put_number(&p, s->margin);
	}
	put_text(&p, "\n}\n");
	put_all(text, (size_t)(p.at - text));
}
