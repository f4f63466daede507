/* SPDX-License-Identifier: MIT */
#include "fit_bounds.h"

#include <string.h>

#include "frustum.h"

bool hull_of(const struct bounds *b, int dimensions, struct hull *h,
    struct refusals *faults)
{
	static const char *const max_pointer[3] = {
		"/bounds/max/0",
		"/bounds/max/1",
		"/bounds/max/2",
	};

	bool is_right = true;

	*h = (struct hull){ .n = b->n > 0 ? b->n : 1 << dimensions };
	if (b->sphere) {
		h->n = 1;
		h->radius = b->radius;
		memcpy(h->point[0], b->center, sizeof b->center);
		return true;
	}
	for (int i = 0; i < dimensions; i++) {
		if (b->max[i] < b->min[i])
			is_right = refuse(faults, max_pointer[i], "less than min's",
			    "give the least x, y, z as min");
		for (int k = 0; k < h->n; k++)
			h->point[k][i] = b->n > 0 ? b->point[k][i] :
			    k >> i & 1            ? b->max[i] :
						    b->min[i];
	}
	return is_right;
}

/* Returns lowest - first, where lowest is the least value on the hull of column j or,
 * if `minus`, of its negative, and first the value at the hull's first point. A radius
 * lowers it by the radius times the length of the column's gradient. */
static struct sum lowest_offset(const struct hull *h, const struct map *m, int j,
    bool minus)
{
	struct sum slope[3], step[3], lowest = sum_of_double(0);

	for (int i = 0; i < 3; i++)
		slope[i] = sum_negated_if(minus, m->m[i][j]);
	for (int k = 1; k < h->n; k++) {
		for (int i = 0; i < 3; i++)
			step[i] = sum_difference(h->point[k][i], h->point[0][i]);
		struct sum value = vec3_dot(slope, step);

		if (sum_compare(value, lowest) < 0)
			lowest = value;
	}
	if (h->radius > 0)
		lowest = sum_sub(lowest, sum_scale(vec3_length(slope), h->radius));
	return lowest;
}

struct sum hull_lowest(const struct hull *h, const struct map *m, int j, bool minus)
{
	struct sum at, p[4] = { [3] = sum_of_double(1) };

	for (int i = 0; i < 3; i++)
		sum_set(&p[i], h->point[0][i]);
	map_image(m, j, p, &at);
	at = sum_add(sum_negated_if(minus, at), lowest_offset(h, m, j, minus));
	return sum_snap_zero(sum_quotient(at, m->divisor));
}

/* Computes the size from lowest_offset: the errors of high and low can exceed it. */
void extents_set(struct extents *r, int j, const struct hull *h, const struct map *m)
{
	struct sum size = sum_add(lowest_offset(h, m, j, false),
	    lowest_offset(h, m, j, true));

	r->low[j] = hull_lowest(h, m, j, false);
	r->high[j] = sum_neg(hull_lowest(h, m, j, true));
	r->size[j] = sum_neg(sum_quotient(size, m->divisor));
}

bool extents_widen(struct extents *r, int n, struct refusals *faults)
{
	struct sum most = sum_of_double(0);

	for (int j = 0; j < n; j++)
		if (sum_compare(r->size[j], most) > 0)
			most = r->size[j];
	struct sum half = sum_scale(most, 0x1p-21);

	for (int j = 0; j < n; j++) {
		if (sum_sign(r->size[j]) > 0)
			continue;
		r->low[j] = sum_sub(r->low[j], half);
		r->high[j] = sum_add(r->high[j], half);
	}
	return sum_sign(most) > 0 ||
	    refuse(faults, "/bounds", "no extent", "points that differ are wanted");
}

bool fit_maps(const struct scene *s, struct map *xy, struct map *depth,
    struct refusals *faults)
{
	const struct projection *p = &s->projection;
	bool flat = projection_family(p) == FAMILY_PARALLEL;

	if (!scene_map(s, SPACE_MODEL, flat ? SPACE_CLIP : SPACE_VIEW, xy, faults) ||
	    !scene_map(s, SPACE_MODEL, SPACE_VIEW, depth, faults))
		return false;
	for (int i = 0; i < 5; i++) {
		xy->m[i][1] = sum_negated_if(flat && s->convention.ndc_y_down,
		    xy->m[i][1]);
		depth->m[i][2] = sum_negated_if(convention_looks_back(&s->convention),
		    depth->m[i][2]);
		/* fit has refused a tilted P */
		if (i >= 3 && projection_has_intrinsics(p))
			depth->m[i][2] = sum_add(depth->m[i][2],
			    sum_scale(depth->divisor, p->section.intrinsics[2][3]));
	}
	return true;
}

bool hull_extents(const struct hull *h, const struct scene *s, struct extents *r,
    struct refusals *faults)
{
	struct map xy, depth;

	if (!fit_maps(s, &xy, &depth, faults))
		return false;
	for (int j = 0; j < 3; j++)
		extents_set(r, j, h, j < 2 ? &xy : &depth);
	return extents_widen(r, 3, faults);
}

unsigned hull_outside(const struct hull *h, const struct scene *s)
{
	/* static: fit calls this deep in its stack, which may have only 256 KB */
	static struct map sides, ends;
	unsigned out = 0;

	if (!frustum_planes(s, SPACE_MODEL, &sides, &ends, NULL))
		return ~0u;
	for (int k = 0; k < 7; k++) {
		int low = sum_sign(
		    hull_lowest(h, k < 4 ? &sides : &ends, k % 4, false));

		if (low < 0 || (low == 0 && 1 << k == OUT_BEHIND))
			out |= 1u << k;
	}
	return out;
}
