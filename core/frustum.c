#include "frustum.h"

#include <math.h>
#include <string.h>

/* Column j of r becomes a x + b w, of x = column k and w = column 3 of m. */
static void combine(struct map *r, int j, const struct map *m, dd a, int k,
    dd b)
{
	for (int i = 0; i < 5; i++) {
		ex x = ex_mul(ex_dd(a), ex_dd(m->m[i][k]));
		ex w = ex_mul(ex_dd(b), ex_dd(m->m[i][3]));

		r->m[i][j] = ex_round(ex_add(x, w));
		r->sum[i][j] = fabs(a.hi) * m->sum[i][k] +
		    fabs(b.hi) * m->sum[i][3];
	}
}

/* left: x >= -limit w, right: x <= limit w, and so on; y's sign is turned
 * where ndc y points down, near and far where depth is reversed. */
static void planes(const struct scene *s, const struct map *m,
    struct map *sides, struct map *ends)
{
	const struct convention *c = &s->convention;
	const dd one = { 1, 0 }, zero = { 0, 0 };
	dd limit[2] = { one, one };
	bool reverse = s->projection.reverse_z;

	if (s->has_viewport)
		viewport_limits(&s->viewport, limit);
	for (int k = 0; k < 4; k++) {
		bool high = (k & 1) ^ (k >= 2 && c->ndc_y_down);

		combine(sides, k, m, high ? dd_neg(one) : one, k / 2,
		    limit[k / 2]);
	}
	combine(ends, reverse ? 1 : 0, m, one, 2, c->minus_one ? one : zero);
	combine(ends, reverse ? 0 : 1, m, dd_neg(one), 2, one);
}

const char *frustum_of(const struct scene *s, enum space from, bool homogeneous,
    struct frustum *f)
{
	struct map clip, view;
	bool back = from == SPACE_NDC || from == SPACE_DEVICE;
	const char *why = scene_map(s, from, SPACE_CLIP, &clip);

	if (why != NULL)
		return why;
	view = clip;
	if (back)
		why = scene_map(s, from, SPACE_VIEW, &view);
	struct map sides = clip, ends = clip;

	planes(s, &clip, &sides, &ends);
	for (int i = 0; i < 5; i++) {
		ends.m[i][2] = view.m[i][3];
		ends.sum[i][2] = view.sum[i][3];
	}
	f->sides = transform_of(&sides, from, SPACE_CLIP, homogeneous);
	f->ends = transform_of(&ends, from, SPACE_CLIP, homogeneous);
	f->sides.divide = f->ends.divide = false;
	f->ends.out = 3;
	return why;
}

unsigned frustum_out(const struct frustum *f, const double in[4])
{
	double side[4], end[4], size[4], kappa;
	unsigned out = 0;

	if (!point_estimate(&f->sides, in, 4, side, size) ||
	    !point_estimate(&f->ends, in, 3, end, size)) {
		point_exact(&f->sides, in, side, &kappa);
		point_exact(&f->ends, in, end, &kappa);
	}
	for (int i = 0; i < f->sides.in; i++)
		if (isnan(in[i]))
			return OUT_NAN;
	if (!(end[2] > 0) || (f->sides.reciprocal && !(in[3] > 0)))
		return OUT_BEHIND;
	for (int k = 0; k < 4; k++)
		out |= side[k] < 0 ? 1u << k : 0;
	for (int k = 0; k < 2; k++)
		out |= end[k] < 0 ? (unsigned)OUT_NEAR << k : 0;
	return out;
}

/* On the axis view z = N(z)/D(z) of ndc z; the gaze goes where that moves as z
 * leaves the near plane: N' D - N D', times -1 where depth is reversed. */
const char *depth_transform(const struct scene *s, struct transform *t)
{
	struct map view, back;
	bool reverse = s->projection.reverse_z;
	double z = reverse ? 1 : s->convention.minus_one ? -1 : 0;
	const char *why = scene_map(s, SPACE_NDC, SPACE_VIEW, &back);

	if (why == NULL)
		why = scene_map(s, SPACE_MODEL, SPACE_VIEW, &view);
	/* not seen: pick composes and inverts the same before */
	if (why != NULL)
		return why;
	dd(*m)[4] = back.m;
	ex n = ex_add(ex_scale(ex_dd(m[2][2]), z), ex_dd(m[AT_ZERO][2]));
	ex d = ex_add(ex_scale(ex_dd(m[2][3]), z), ex_dd(m[AT_ZERO][3]));
	ex slope = ex_sub(ex_mul(ex_dd(m[2][2]), d), ex_mul(n, ex_dd(m[2][3])));
	double sign = (ex_round(slope).hi > 0) == !reverse ? 1 : -1;
	dd near = ex_div(n, d);

	for (int i = 0; i < 5; i++)
		view.m[i][2] = dd_scale(view.m[i][2], sign);
	view.m[AT_ORIGIN][2] = dd_add(view.m[AT_ORIGIN][2],
	    dd_scale(near, -sign));
	view.sum[AT_ORIGIN][2] += fabs(near.hi);
	*t = transform_of(&view, SPACE_MODEL, SPACE_VIEW, false);
	return NULL;
}

double depth_of(const struct transform *t, const double in[4])
{
	double out[4], kappa;

	point_exact(t, in, out, &kappa);
	return out[2];
}

bool is_within(const double device[2], const double at[2], double radius)
{
	dd r = two_prod(radius, radius), d2 = { 0, 0 };

	for (int i = 0; i < 2; i++) {
		dd d = two_sum(device[i], -at[i]);

		d2 = dd_add(d2, dd_mul(d, d));
	}
	return dd_add(d2, dd_neg(r)).hi <= 0;
}

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

/* The ray in double-double, from sums each within 13 u^2 of size and 20 u^2 where
 * they are taken for 0: 33, with a product and a difference 41 in d, with a
 * product and three sums 55 in to and less in world. A quotient of two has both
 * errors in parts of its own, one of their sums of squares the length, and 25
 * u^2 of its own: all within 128 u^2 (cost + cost of the divisor), as each cost
 * is at least 1. */
#define RAY_BOUND 0x1p-99

struct quick {
	dd value;
	double cost; /* the products' sizes over the value */
};

static struct quick quick_of(struct sum s)
{
	return (struct quick){ s.value,
		s.size == 0 ? 1 : s.size / fabs(s.value.hi) };
}

static void accumulate(struct sum *s, struct sum a, const struct map *m, int i,
    int j)
{
	s->value = dd_add(s->value, dd_mul(a.value, m->m[i][j]));
	s->size += a.size * m->sum[i][j];
}

/* The length of three numbers, and its cost: the mean of theirs. */
static struct quick length_of(const struct sum to[3])
{
	dd square = { 0, 0 };
	double costs = 0;

	for (int j = 0; j < 3; j++) {
		square = dd_add(square, dd_mul(to[j].value, to[j].value));
		costs += to[j].size * fabs(to[j].value.hi);
	}
	double s = sqrt(square.hi);
	dd rest = dd_add(square, dd_neg(two_prod(s, s)));

	return (struct quick){ fast_two_sum(s, rest.hi / (2 * s)),
		costs / square.hi };
}

/* Rounds n / d; false where its error may turn the rounding, or anything comes
 * near the end of the range. */
static bool round_quick(struct quick n, struct quick d, double *q)
{
	double size = fabs(n.value.hi), divisor = fabs(d.value.hi);
	dd v = dd_div(n.value, d.value);
	double error = RAY_BOUND * (n.cost + d.cost) * fabs(v.hi);

	*q = v.hi;
	if (size == 0 && n.cost == 1)
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

		accumulate(&d, n[3], v, 2, i);
		d.value = dd_neg(d.value);
		accumulate(&d, n[i], v, 2, 3);
		d.value = dd_scale(d.value, -r->sign);
		for (int j = 0; j < 3; j++) {
			accumulate(&world[j], n[i], w, i, j);
			accumulate(&to[j], d, w, i, j);
		}
	}
	struct quick length = length_of(to), depth = quick_of(n[3]);

	for (int j = 0; j < 3; j++) {
		accumulate(&world[j], n[3], w, AT_ZERO, j);
		sure &= round_quick(quick_of(world[j]), depth, &point[j]) &&
		    round_quick(quick_of(to[j]), length, &direction[j]);
	}
	return sure && n[3].value.hi > 0;
}

/* A coordinate, and the sum of its products' sizes. */
struct sized {
	ex value;
	double size;
};

static struct sized affine(const struct map *m, int j, const ex p[3])
{
	struct sized s = { ex_dd(m->m[AT_ORIGIN][j]), m->sum[AT_ORIGIN][j] };

	for (int i = 0; i < 3; i++) {
		s.value = ex_add(s.value, ex_mul(p[i], ex_dd(m->m[i][j])));
		s.size += fabs(ex_round(p[i]).hi) * m->sum[i][j];
	}
	return s;
}

/* Adds a m[i][j]. */
static void add(struct sized *s, struct sized a, const struct map *m, int i,
    int j)
{
	s->value = ex_add(s->value, ex_mul(a.value, ex_dd(m->m[i][j])));
	s->size += a.size * m->sum[i][j];
}

/* The quotient rounded; 0 where n may be nothing but the errors of as many
 * elements as each of its products has. */
static double over(struct sized n, ex d, int elements)
{
	double bound = elements * MAP_BOUND * 0x1p-106 * n.size;

	return fabs(ex_round(n.value).hi) <= bound && isfinite(bound) ?
	    0 :
	    ex_div(n.value, d).hi;
}

/* Of N(z)/D(z) at the near depth, N/D and the direction N' D - N D', which has
 * the derivative's sign as D^2 > 0. Both go to world space, linearly. */
void ray_exact(const struct ray_maker *r, const double at[2], double point[3],
    double direction[3])
{
	const struct map *v = &r->to_view, *w = &r->to_world;
	struct sized n[4], d[3], world[3] = { 0 }, to[3] = { 0 };
	ex p[3], length = { 0 };

	if (ray_quick(r, at, point, direction))
		return;
	for (int i = 0; i < 3; i++)
		point[i] = direction[i] = (double)NAN;
	if (isnan(at[0]) || isnan(at[1]))
		return;
	for (int i = 0; i < 3; i++)
		p[i] = ex_diff(i < 2 ? at[i] : r->depth, v->origin[i]);
	for (int j = 0; j < 4; j++) {
		n[j] = affine(v, j, p);
		n[j].value = ex_first(n[j].value, 4);
	}
	if (!(ex_round(n[3].value).hi > 0))
		return;
	for (int j = 0; j < 3; j++) {
		struct sized minus = { ex_neg(n[j].value), n[j].size };

		d[j] = (struct sized){ 0 };
		add(&d[j], n[3], v, 2, j);
		add(&d[j], minus, v, 2, 3);
		d[j].value = ex_first(ex_scale(d[j].value, r->sign), 4);
	}
	for (int j = 0; j < 3; j++) {
		add(&world[j], n[3], w, AT_ZERO, j);
		for (int i = 0; i < 3; i++) {
			add(&world[j], n[i], w, i, j);
			add(&to[j], d[i], w, i, j);
		}
		to[j].value = ex_first(to[j].value, 4);
		length = ex_add(length, ex_mul(to[j].value, to[j].value));
	}
	length = ex_sqrt(length);
	for (int j = 0; j < 3; j++) {
		point[j] = over(world[j], n[3].value, 2);
		direction[j] = over(to[j], length, 3);
	}
}
