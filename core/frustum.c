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

static ex affine(const struct map *m, int j, const ex p[3])
{
	ex s = ex_dd(m->m[AT_ORIGIN][j]);

	for (int i = 0; i < 3; i++)
		s = ex_add(s, ex_mul(p[i], ex_dd(m->m[i][j])));
	return s;
}

/* Of N(z)/D(z) at the near depth, N/D and the direction N' D - N D', which has
 * the derivative's sign as D^2 > 0. Both go to world space, linearly. */
void ray_exact(const struct ray_maker *r, const double at[2], double point[3],
    double direction[3])
{
	const struct map *v = &r->to_view, *w = &r->to_world;
	ex p[3], n[4], d[3], world[3], to[3], length = { 0 };

	for (int i = 0; i < 3; i++) {
		point[i] = direction[i] = (double)NAN;
		p[i] = ex_diff(i < 2 ? at[i] : r->depth, v->origin[i]);
	}
	for (int j = 0; j < 4; j++)
		n[j] = ex_first(affine(v, j, p), 4);
	if (!(ex_round(n[3]).hi > 0))
		return;
	for (int j = 0; j < 3; j++) {
		d[j] = ex_sub(ex_mul(ex_dd(v->m[2][j]), n[3]),
		    ex_mul(n[j], ex_dd(v->m[2][3])));
		d[j] = ex_first(ex_scale(d[j], r->sign), 4);
	}
	for (int j = 0; j < 3; j++) {
		ex zero = ex_mul(ex_dd(w->m[AT_ZERO][j]), n[3]);

		world[j] = zero;
		to[j] = (ex){ 0 };
		for (int i = 0; i < 3; i++) {
			ex axis = ex_dd(w->m[i][j]);

			world[j] = ex_add(world[j], ex_mul(n[i], axis));
			to[j] = ex_add(to[j], ex_mul(d[i], axis));
		}
		to[j] = ex_first(to[j], 4);
		length = ex_add(length, ex_mul(to[j], to[j]));
	}
	length = ex_sqrt(length);
	for (int j = 0; j < 3; j++) {
		point[j] = ex_div(world[j], n[3]).hi;
		direction[j] = ex_div(to[j], length).hi;
	}
}
