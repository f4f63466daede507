/* SPDX-License-Identifier: MIT */
#include "box.h"

#include <math.h>
#include <string.h>

#include "../points/distance.h"
#include "frustum.h"

/* Widens the rectangle `edge`, of quotients, to hold x / w and y / w. */
static void widen(struct sum edge[4], const struct box_point *p, bool first)
{
	for (int k = 0; k < 4; k++) {
		struct sum at = sum_quotient(k < 2 ? p->x : p->y, p->w);
		int way = first ? 0 : sum_compare(at, edge[k]);

		if (first || way == (k & 1 ? 1 : -1))
			sum_copy(&edge[k], &at);
	}
}

/* Sets c to the point of the edge from a to b where the near plane's function is 0. */
static void cut_edge(const struct box_point *a, const struct box_point *b,
    struct box_point *c)
{
	struct sum na = sum_abs(a->near), nb = sum_abs(b->near);

	c->x = sum_add(sum_mul(a->x, nb), sum_mul(b->x, na));
	c->y = sum_add(sum_mul(a->y, nb), sum_mul(b->y, na));
	c->w = sum_add(sum_mul(a->w, nb), sum_mul(b->w, na));
}

/* Finds the rectangle. The corners of the part beyond the near plane are those of the box
 * there, and the points where the plane cuts an edge, along which one bit changes. */
static const char *find_rectangle(struct box *r)
{
	struct sum edge[4];
	struct box_point cut;
	bool none = true, reaches_eye = false;

	for (int a = 0; a < r->n; a++)
		for (int b = a; b < r->n; b++) {
			const struct box_point *p = &r->corner[a], *q = &r->corner[b];
			const int sign = sum_sign(p->near);

			if (((a ^ b) & ((a ^ b) - 1)) != 0 ||
			    (a == b ? sign < 0 : sign * sum_sign(q->near) >= 0))
				continue;
			if (a != b) {
				cut_edge(p, q, &cut);
				p = &cut;
			}
			reaches_eye |= sum_sign(p->w) <= 0;
			if (!reaches_eye)
				widen(edge, p, none);
			none = false;
		}
	for (int k = 0; k < 4; k++)
		(k & 1 ? r->max : r->min)[k / 2] = none || reaches_eye ?
		    (double)NAN :
		    sum_double(edge[k]);
	return ex_has_overflowed() ? "/bounds: " SCENE_TOO_WIDE : NULL;
}

/* Sets x, y and w of the corners' images under the map m. */
static void set_images(const struct map *m, struct box *r)
{
	for (int k = 0; k < r->n; k++) {
		map_image(m, 0, r->at[k], &r->corner[k].x);
		map_image(m, 1, r->at[k], &r->corner[k].y);
		map_image(m, 3, r->at[k], &r->corner[k].w);
	}
}

/* Sets what depends on the planes in r->sides and, unless flat, r->ends. */
static void set_planes(bool flat, struct box *r)
{
	unsigned some = 0, all = ~0u;

	for (int k = 0; k < r->n; k++) {
		unsigned out = 0;

		sum_set(&r->corner[k].near, 1);
		for (int i = 0; i < (flat ? 4 : 7); i++) {
			struct sum v;

			map_image(i < 4 ? &r->sides : &r->ends, i % 4, r->at[k], &v);
			const int sign = sum_sign(v);

			if (sign < 0 || (sign == 0 && 1 << i == OUT_BEHIND))
				out |= 1u << i;
			if (1 << i == OUT_NEAR)
				sum_copy(&r->corner[k].near, &v);
		}
		some |= out;
		all &= out;
	}
	r->behind = (all & OUT_BEHIND) != 0;
	r->out = (all & ~(unsigned)OUT_BEHIND) != 0;
	r->outside = some & ~(unsigned)OUT_BEHIND;
}

/* Sets the corners' images under the map m. */
static const char *set_corners(const struct bounds *b, int dimensions,
    const struct map *m, struct box *r)
{
	struct hull h;
	const char *why = hull_of(b, dimensions, &h);

	r->n = 1 << dimensions;
	for (int k = 0; k < r->n && why == NULL; k++) {
		struct sum p[4] = { [3] = sum_of_double(1) };

		for (int i = 0; i < 3; i++) {
			const double radius = i < dimensions ? h.radius : 0;

			p[i] = sum_difference(h.point[k % h.n][i],
			    k >> i & 1 ? -radius : radius);
		}
		for (int j = 0; j < 4; j++)
			map_image(m, j, p, &r->at[k][j]);
	}
	return why;
}

static const char *set_distances(const struct scene *s, struct box *r)
{
	struct distance d;
	struct sum low, high, v;
	const char *why = distance_of(s, &d);

	for (int k = 0; k < r->n && why == NULL; k++) {
		sum_dot(4, r->at[k], d.column, 1, &v);
		if (k == 0 || sum_compare(v, low) < 0)
			sum_copy(&low, &v);
		if (k == 0 || sum_compare(v, high) > 0)
			sum_copy(&high, &v);
	}
	if (why != NULL)
		return why;
	v = sum_mul(d.length, r->at[0][3]);
	r->distance[0] = sum_ratio_or_nan(low, v);
	r->distance[1] = sum_ratio_or_nan(high, v);
	return NULL;
}

const char *box_of(const struct scene *s, const struct bounds *b, bool flat,
    struct box *r)
{
	struct map *m = &r->sides;
	const char *why = NULL;

	map_identity(m);
	if (!flat)
		why = scene_map_factor(s, SPACE_MODEL, SPACE_VIEW, m);
	if (why == NULL)
		why = set_corners(b, flat ? 2 : 3, m, r);
	if (why == NULL && !flat)
		why = set_distances(s, r);
	if (why == NULL)
		why = flat ? scene_flat_map(s, FLAT_WINDOW,
				 s->has_device ? FLAT_DEVICE : FLAT_NDC, m) :
			     scene_map_factor(s, SPACE_VIEW,
				 s->has_viewport ? SPACE_DEVICE : SPACE_NDC, m);
	if (why != NULL)
		return why;
	set_images(m, r);
	why = flat ? frustum_window_planes(s, FLAT_WINDOW, m) :
		     frustum_planes(s, SPACE_VIEW, m, &r->ends);
	if (why != NULL)
		return why;
	set_planes(flat, r);
	return find_rectangle(r);
}
