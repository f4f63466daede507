/* SPDX-License-Identifier: MIT */
#include "distance.h"

#include <string.h>

bool distance_of(const struct scene *s, struct distance *d, struct refusals *faults)
{
	const struct projection *p = &s->projection;
	const bool back = convention_looks_back(scene_answer_convention(s));
	struct map m;

	if (!scene_map_factor(s, SPACE_VIEW, SPACE_CLIP, &m, faults))
		return false;
	for (int i = 0; i < 4; i++)
		d->column[i] = m.m[i][3];
	sum_set(&d->length, 1);
	d->parallel = vec3_is_zero(d->column);
	if (d->parallel) {
		bool reversed = projection_is_reversed(p, &s->convention);
		bool against = reversed != (sum_sign(m.m[3][3]) < 0);

		memset(d->column, 0, sizeof d->column);
		sum_set(&d->column[2], back ? -1 : 1);
		for (int i = 0; i < 3 && projection_is_given_matrix(p); i++)
			d->column[i] = sum_negated_if(against, m.m[i][2]);
	}
	if (!d->parallel || projection_is_given_matrix(p))
		d->length = vec3_length(d->column);
	return true;
}

/* Makes the map l from view space to x, y and w of the device. Its third column is the
 * distance times w, which is constant, if the projection is parallel, else 1. */
static bool device_columns(const struct scene *s, struct distance *d, struct map *l,
    struct refusals *faults)
{
	if (!distance_of(s, d, faults) ||
	    !scene_map_factor(s, SPACE_VIEW, SPACE_DEVICE, l, faults))
		return false;
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
	return true;
}

bool distance_by_view(const struct scene *s, enum space from, enum space to,
    struct transform *t, struct refusals *faults)
{
	const bool back = from == SPACE_DEVICE;
	struct distance d;
	struct map inverse;

	if (!device_columns(s, &d, &t->from_view, faults))
		return false;
	map_copy(&inverse, &t->from_view);
	if (back && !map_invert(&inverse))
		return refuse(faults, "/projection", "singular",
		    "it can't be inverted");
	if (from <= SPACE_VIEW) {
		if (!transform_by_view(s, from, to, false, t, faults))
			return false;
	} else {
		map_multiply(&t->map, back ? &inverse : &t->from_view, back);
		if (!scene_map_refuse_range(s, false, &t->map, faults))
			return false;
		transform_init(t, from, to, false);
	}
	if (!d.parallel) {
		t->distance = back ? DISTANCE_IN : DISTANCE_OUT;
		t->length = d.length;
		t->unit = t->from_view.divisor;
		t->kernel = KERNEL_NONE;
		t->divide = !back || to == SPACE_NDC;
	}
	return transform_check(s, t, faults);
}

bool distance_transform(const struct scene *s, enum space from, enum space to,
    struct transform *t, struct refusals *faults)
{
	const bool back = from == SPACE_DEVICE;

	if (back == (to == SPACE_DEVICE) || !s->has_viewport || !s->viewport.distance)
		return transform_of_scene(s, from, to, false, t, faults);
	return scene_map_factor(s, back ? SPACE_VIEW : from, back ? to : SPACE_VIEW,
		   &t->map, faults) &&
	    distance_by_view(s, from, to, t, faults);
}
