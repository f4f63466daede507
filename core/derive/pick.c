/* SPDX-License-Identifier: MIT */
#include "pick.h"

#include <math.h>

/* Where the near plane is on the axis of view space, and whether the gaze goes
 * toward larger z. */
static const char *near_plane(const struct scene *s, struct sum *near,
    bool *upward)
{
	const struct projection *p = &s->projection;
	const struct convention *c = &s->convention;
	bool reversed = projection_is_reversed(p, c);
	struct sum z = sum_of_double(reversed ? 1 : c->minus_one ? -1 : 0);
	struct map back;

	*upward = looks_back(c) == (p->near > p->far);
	*near = sum_of(ex_diff(p->near, projection_w_at_eye(p)));
	if (looks_back(c))
		*near = sum_neg(*near);
	switch (p->type) {
	case PROJECTION_PERSP:
	case PROJECTION_ORTHO:
	case PROJECTION_OBLIQUE:
		return NULL;
	case PROJECTION_VOLUME:
		*upward = p->z_far > p->z_near;
		*near = sum_of_double(p->z_near);
		return NULL;
	default:
		break;
	}
	/* On the axis view z = N(z)/D(z) of ndc z; as z leaves the near plane that
	 * moves by N' D - N D' over something positive. */
	const char *why = scene_map(s, SPACE_NDC, SPACE_VIEW, &back);

	if (why != NULL)
		return why;
	const struct sum(*m)[4] = back.m;
	struct sum n = sum_add(sum_mul(m[2][2], z), m[3][2]);
	struct sum d = sum_add(sum_mul(m[2][3], z), m[3][3]);

	*near = sum_quotient(n, d);
	*upward = (sum_sign(sum_sub(sum_mul(m[2][2], d), sum_mul(n, m[2][3]))) >
		      0) == !reversed;
	return NULL;
}

/* Of a tilted P depth is w, which is z of its level space. */
static void make_level(const struct scene *s, struct map *view)
{
	double m[4][4];
	struct map given = *view, level;

	projection_level(&s->projection, &s->convention, m);
	map_of_doubles(m, &level);
	map_then(&given, &level, view);
}

/* Distances are the same in every convention; they are measured in the scene's. */
const char *picker_of(const struct scene *given,
    const struct transform *to_device, struct picker *k)
{
	struct scene own = *given;
	const struct scene *s = &own;
	struct map *view = &k->depth.map;
	struct sum near;
	bool upward;

	own.answer = NULL;
	const char *why = near_plane(s, &near, &upward);

	k->to_device = to_device;
	if (why == NULL)
		why = scene_map(s, SPACE_MODEL, SPACE_VIEW, view);
	if (why != NULL)
		return why;
	if (projection_is_tilted(&s->projection))
		make_level(s, view);
	view->m[3][2] = sum_sub(view->m[3][2], sum_mul(near, view->divisor));
	for (int i = 0; i < 4 && !upward; i++)
		view->m[i][2] = sum_neg(view->m[i][2]);
	map_column_over(view, 2, projection_w_slope(&s->projection));
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
