/* SPDX-License-Identifier: MIT */
#include "pick.h"

#include <math.h>

/* Where the near plane is on the axis of view space, z = n / d, and whether the gaze
 * goes toward larger z. As z leaves the plane, n / d moves by n' d - n d' over
 * something positive. Where there are no planes distances are from the eye. Of a tilted P
 * z is that of its level space. */
static const char *near_plane(const struct scene *s, struct sum *n,
    struct sum *d, bool *upward)
{
	const struct projection *p = &s->projection;
	const struct convention *c = &s->convention;
	bool reversed = projection_is_reversed(p, c);
	double depth = reversed ? 1 : c->minus_one ? -1 : 0;
	struct map back;

	if (projection_is_open(p) || projection_is_tilted(p)) {
		*upward = !looks_back(c);
		*n = sum_sub(sum_of_double(p->near),
		    sum_of_double(projection_w_at_eye(p)));
		*n = sum_negated_if(!*upward, *n);
		*d = sum_of_double(1);
		return NULL;
	}
	const char *why = projection_map(p, c, true, &back);
	const struct sum(*m)[4] = back.m;

	if (why != NULL)
		return why;
	*n = sum_add(sum_scale(m[2][2], depth), m[3][2]);
	*d = sum_add(sum_scale(m[2][3], depth), m[3][3]);
	*upward = (sum_sign(sum_minor(m[2][2], *d, *n, m[2][3])) > 0) ==
	    !reversed;
	return NULL;
}

/* Puts w, which is the depth of a tilted P, in the place of view z: both are negative
 * where the camera looks along -z. */
static void view_by_w(const struct scene *s, struct map *view)
{
	double level[4][4];

	projection_level(&s->projection, &s->convention, level);
	for (int i = 0; i < 4; i++) {
		struct sum w = sum_of_double(0);

		for (int k = 0; k < 4; k++)
			w = sum_add(w, sum_scale(view->m[i][k], level[k][2]));
		view->m[i][2] = w;
	}
}

/* Distances are the same in every convention; they are measured in the scene's. */
const char *picker_of(const struct scene *given,
    const struct transform *to_device, struct picker *k)
{
	struct scene own = *given;
	struct map *view = &k->depth.map;
	struct sum n, d;
	bool upward;

	own.answer = NULL;
	k->to_device = to_device;
	const char *why = near_plane(&own, &n, &d, &upward);

	if (why == NULL)
		why = scene_map(&own, SPACE_MODEL, SPACE_VIEW, view);
	if (why != NULL)
		return why;
	if (projection_is_tilted(&own.projection))
		view_by_w(&own, view);
	for (int i = 0; i < 4; i++) {
		struct sum z = sum_mul(view->m[i][2], d);

		if (i == 3)
			z = sum_sub(z, sum_mul(n, view->divisor));
		view->m[i][2] = sum_negated_if(!upward, z);
	}
	map_column_over(view, 2, d);
	map_column_over(view, 2, projection_w_slope(&own.projection));
	transform_init(&k->depth, SPACE_MODEL, SPACE_VIEW, false);
	return NULL;
}

static struct sum square(struct sum a)
{
	return sum_mul(a, a);
}

/* The device position is N / w: (N - at w)^2 <= (r w)^2. The device
 * position is within a few u of its size; where the radius is above 2^-40 of
 * that, d2 is within 2^-10 of itself, and doubles decide what lies farther
 * than 2^-8 from the circle. */
bool pick_holds(const struct picker *k, const double in[4],
    const double device[2])
{
	const struct transform *t = k->to_device;
	double x = device[0] - k->at[0], y = device[1] - k->at[1];
	double d2 = x * x + y * y, r2 = k->radius * k->radius;
	double large = fmax(fabs(k->at[0]), fabs(k->at[1]));

	if (k->radius > 0x1p-40 * large && r2 > 0x1p-900 && r2 < 0x1p900 &&
	    fabs(d2 - r2) > 0x1p-8 * r2)
		return d2 < r2;
	struct sum w = point_column(t, 3, in);
	struct sum d = sum_neg(square(sum_mul(w, sum_of_double(k->radius))));

	for (int j = 0; j < 2; j++) {
		struct sum at = sum_mul(w, sum_of_double(k->at[j]));

		d = sum_add(d, square(sum_sub(point_column(t, j, in), at)));
	}
	return sum_sign(d) <= 0;
}

double pick_distance(const struct picker *k, const double in[4])
{
	return sum_over(point_column(&k->depth, 2, in), k->depth.map.divisor);
}

int pick_compare(const struct picker *k, const double p[4], const double q[4])
{
	return sum_sign(sum_sub(point_column(&k->depth, 2, p),
	    point_column(&k->depth, 2, q)));
}
