#include "ray.h"

#include <math.h>

const char *ray_maker_of(const struct scene *s, struct ray_maker *r)
{
	const char *why = scene_map(s, SPACE_DEVICE, SPACE_VIEW, &r->to_view);
	bool reverse = s->projection.reverse_z;
	const struct viewport *v = &s->viewport;

	if (why != NULL)
		return why;
	r->depth = reverse ? v->max_z : v->min_z;
	r->sign = (v->max_z > v->min_z) == !reverse ? 1 : -1;
	return scene_map(s, SPACE_VIEW, SPACE_WORLD, &r->to_world);
}

/* A ray is computed in double-double, and where that may have rounded to the
 * wrong side, in expansions: the same sums, so that each has its twin below.
 *
 * View space is N(z) / D(z) at device depth z, numerators n[0..2] and
 * denominator n[3]. The direction is the derivative's numerator N' D - N D',
 * as D^2 > 0. Both go to world space, linearly: world and to.
 *
 * Errors in double-double, in u^2 of each sum's size: a map_column 13, and as
 * much as 20 more where it is taken for 0: n is within 33. A product (4) and a
 * difference (3): d within 41. Products and three sums: to within 55, world
 * within less. The quotient of two sums has the relative errors of both and 9
 * u^2 of its own; a length has the mean of its elements' errors and 16 u^2 of
 * its own. All are within 128 u^2 (size/|n| + size/|d|), each of which is at
 * least 1. */
#define RAY_BOUND 0x1p-99

static void add_product(struct sum *s, struct sum a, const struct map *m, int i,
    int j)
{
	s->value = dd_add(s->value, dd_mul(a.value, m->m[i][j]));
	s->size += a.size * m->sum[i][j];
}

static struct sum length_of(const struct sum to[3])
{
	dd square = { 0, 0 };
	double size = 0;

	for (int j = 0; j < 3; j++) {
		square = dd_add(square, dd_mul(to[j].value, to[j].value));
		size += to[j].size * fabs(to[j].value.hi);
	}
	double s = sqrt(square.hi);
	dd rest = dd_add(square, dd_neg(two_prod(s, s)));

	return (struct sum){ fast_two_sum(s, rest.hi / (2 * s)), size / s };
}

/* Rounds n / d; false where its error may turn the rounding, or anything comes
 * near the end of the range. */
static bool round_quick(struct sum n, struct sum d, double *q)
{
	double size = fabs(n.value.hi), divisor = fabs(d.value.hi);
	dd v = dd_div(n.value, d.value);
	double error = RAY_BOUND * (n.size + fabs(v.hi) * d.size) / divisor;

	*q = v.hi;
	if (n.size == 0)
		return true;
	return size > 0x1p-450 && size < 0x1p450 && divisor > 0x1p-450 &&
	    divisor < 0x1p450 && fabs(v.hi) > 0x1p-450 &&
	    v.hi + (v.lo - error) == v.hi && v.hi + (v.lo + error) == v.hi;
}

static bool ray_quick(const struct ray_maker *r, const double at[2],
    double point[3], double direction[3])
{
	const struct map *v = &r->to_view, *w = &r->to_world;
	struct sum n[4], world[3] = { 0 }, to[3] = { 0 };
	dd p[4] = { [3] = { 1, 0 } };
	bool sure = true;

	for (int i = 0; i < 3; i++)
		p[i] = two_sum(i < 2 ? at[i] : r->depth, -v->origin[i]);
	for (int j = 0; j < 4; j++)
		n[j] = map_column(v, j, p);
	for (int i = 0; i < 3; i++) {
		struct sum d = { { 0, 0 }, 0 };

		add_product(&d, n[3], v, 2, i);
		d.value = dd_neg(d.value);
		add_product(&d, n[i], v, 2, 3);
		d.value = dd_scale(d.value, -r->sign);
		for (int j = 0; j < 3; j++) {
			add_product(&world[j], n[i], w, i, j);
			add_product(&to[j], d, w, i, j);
		}
	}
	struct sum length = length_of(to);

	for (int j = 0; j < 3; j++) {
		add_product(&world[j], n[3], w, AT_ZERO, j);
		sure &= round_quick(world[j], n[3], &point[j]) &&
		    round_quick(to[j], length, &direction[j]);
	}
	return sure && n[3].value.hi > 0;
}

static struct ex_sum column(const struct map *m, int j, const ex p[3])
{
	struct ex_sum s = { ex_dd(m->m[AT_ORIGIN][j]), m->sum[AT_ORIGIN][j] };

	for (int i = 0; i < 3; i++) {
		s.value = ex_add(s.value, ex_mul(p[i], ex_dd(m->m[i][j])));
		s.size += fabs(ex_round(p[i]).hi) * m->sum[i][j];
	}
	s.value = ex_first(s.value, 4);
	return s;
}

static void add_ex_product(struct ex_sum *s, struct ex_sum a,
    const struct map *m, int i, int j)
{
	s->value = ex_add(s->value, ex_mul(a.value, ex_dd(m->m[i][j])));
	s->size += a.size * m->sum[i][j];
}

/* N' D - N D', away from the eye. */
static struct ex_sum slope(const struct ray_maker *r, const struct ex_sum n[4],
    int j)
{
	struct ex_sum d = { 0 }, minus = { ex_neg(n[j].value), n[j].size };

	add_ex_product(&d, n[3], &r->to_view, 2, j);
	add_ex_product(&d, minus, &r->to_view, 2, 3);
	d.value = ex_first(ex_scale(d.value, r->sign), 4);
	return d;
}

/* The quotient rounded; 0 where n may be nothing but the errors of the elements
 * that each of its products has so many of. */
static double over(struct ex_sum n, ex d, int elements)
{
	double bound = elements * MAP_BOUND * 0x1p-106 * n.size;

	return fabs(ex_round(n.value).hi) <= bound && isfinite(bound) ?
	    0 :
	    ex_div(n.value, d).hi;
}

void ray_exact(const struct ray_maker *r, const double at[2], double point[3],
    double direction[3])
{
	const struct map *v = &r->to_view, *w = &r->to_world;
	struct ex_sum n[4], d[3], world[3] = { 0 }, to[3] = { 0 };
	ex p[3], square = { 0 };

	if (ray_quick(r, at, point, direction))
		return;
	for (int i = 0; i < 3; i++)
		point[i] = direction[i] = (double)NAN;
	if (isnan(at[0]) || isnan(at[1]))
		return;
	for (int i = 0; i < 3; i++)
		p[i] = ex_diff(i < 2 ? at[i] : r->depth, v->origin[i]);
	for (int j = 0; j < 4; j++)
		n[j] = column(v, j, p);
	if (!(ex_round(n[3].value).hi > 0))
		return;
	for (int j = 0; j < 3; j++)
		d[j] = slope(r, n, j);
	for (int j = 0; j < 3; j++) {
		add_ex_product(&world[j], n[3], w, AT_ZERO, j);
		for (int i = 0; i < 3; i++) {
			add_ex_product(&world[j], n[i], w, i, j);
			add_ex_product(&to[j], d[i], w, i, j);
		}
		to[j].value = ex_first(to[j].value, 4);
		square = ex_add(square, ex_mul(to[j].value, to[j].value));
	}
	ex length = ex_sqrt(square);

	for (int j = 0; j < 3; j++) {
		point[j] = over(world[j], n[3].value, 2);
		direction[j] = over(to[j], length, 3);
	}
}
