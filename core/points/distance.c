/* SPDX-License-Identifier: MIT */
#include "distance.h"

#include <string.h>

const char *distance_of(const struct scene *s, struct distance *d)
{
	const struct projection *p = &s->projection;
	const bool back = convention_looks_back(scene_answer_convention(s));
	struct map m;
	const char *why = scene_map_factor(s, SPACE_VIEW, SPACE_CLIP, &m);

	for (int i = 0; i < 4 && why == NULL; i++)
		d->column[i] = m.m[i][3];
	sum_set(&d->length, 1);
	if (why != NULL)
		return why;
	d->parallel = vec3_is_zero(d->column);
	if (d->parallel) {
		bool reversed = projection_is_reversed(p, &s->convention);
		bool against = reversed != (sum_sign(m.m[3][3]) < 0);

		memset(d->column, 0, sizeof d->column);
		sum_set(&d->column[2], back ? -1 : 1);
		for (int i = 0; i < 3 && p->type == PROJECTION_MATRIX; i++)
			d->column[i] = sum_negated_if(against, m.m[i][2]);
	}
	if (!d->parallel || p->type == PROJECTION_MATRIX)
		d->length = vec3_length(d->column);
	return NULL;
}

/* Makes the map l from view space to x, y and w of the device. Its third column is the
 * distance times w, which is constant, if the projection is parallel, else 1. */
static const char *device_columns(const struct scene *s, struct distance *d,
    struct map *l)
{
	const char *why = distance_of(s, d);

	if (why == NULL)
		why = scene_map_factor(s, SPACE_VIEW, SPACE_DEVICE, l);
	if (why != NULL)
		return why;
	for (int i = 0; i < 4; i++)
		l->m[i][2] = d->parallel ? sum_mul(l->m[3][3], d->column[i]) :
					   sum_of_double(0);
	if (d->parallel) {
		l->m[4][2] = l->m[3][2];
		map_divide_column(l, 2, d->length);
	} else {
		l->m[3][2] = l->divisor;
		/* the length of the gradient in l, where w has another divisor */
		for (int i = 0; i < 3; i++)
			d->column[i] = l->m[i][3];
		d->length = vec3_length(d->column);
	}
	map_set_origin(l, NULL);
	return NULL;
}

/* Sets the members of t for a map to or from the columns in t->from_view. */
static void set_distance(const struct distance *d, bool back, enum space to,
    struct transform *t)
{
	if (d->parallel)
		return;
	t->distance = back ? DISTANCE_IN : DISTANCE_OUT;
	t->length = d->length;
	t->unit = t->from_view.divisor;
	t->kernel = KERNEL_NONE;
	t->divide = !back || to == SPACE_NDC;
}

/* Makes t, whose member map leads from view space to `to`, the transform from the
 * device to `to`. */
static const char *from_device(const struct scene *s, enum space to,
    struct transform *t)
{
	struct distance d;
	struct map inverse;
	const char *why = device_columns(s, &d, &t->from_view);

	if (why != NULL)
		return why;
	if (!map_invert(&t->from_view, &inverse))
		return "/projection: singular; it can't be inverted";
	map_multiply(&t->map, &inverse, true);
	why = scene_map_refuse_range(s, &t->map);
	transform_init(t, SPACE_DEVICE, to, false);
	set_distance(&d, true, to, t);
	return why != NULL ? why : transform_check(s, t);
}

static const char *to_device(const struct scene *s, enum space from,
    struct transform *t)
{
	struct distance d;
	const char *why = scene_map_factor(s, from, SPACE_VIEW, &t->map);

	if (why == NULL)
		why = device_columns(s, &d, &t->from_view);
	if (why != NULL)
		return why;
	if (from <= SPACE_VIEW) {
		why = transform_by_view(s, from, SPACE_DEVICE, false, t);
	} else {
		map_multiply(&t->map, &t->from_view, false);
		why = scene_map_refuse_range(s, &t->map);
		transform_init(t, from, SPACE_DEVICE, false);
	}
	set_distance(&d, false, SPACE_DEVICE, t);
	return why != NULL ? why : transform_check(s, t);
}

const char *distance_planes(const struct scene *s, struct transform *t)
{
	return from_device(s, SPACE_CLIP, t);
}

const char *distance_transform(const struct scene *s, enum space from, enum space to,
    struct transform *t)
{
	const bool device = (from == SPACE_DEVICE) != (to == SPACE_DEVICE);

	if (!device || !s->has_viewport || !s->viewport.distance)
		return transform_of_scene(s, from, to, false, t);
	if (to == SPACE_DEVICE)
		return to_device(s, from, t);
	const char *why = scene_map_factor(s, SPACE_VIEW, to, &t->map);

	return why != NULL ? why : from_device(s, to, t);
}
