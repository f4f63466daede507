#include "frustum.h"

#include <math.h>

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

/* In ndc, which is in clip space where w is 1. */
static void ndc_corner(const struct scene *s, bool reversed, int corner,
    ex clip[4])
{
	static const int right[4] = { -1, 1, 1, -1 }, up[4] = { -1, -1, 1, 1 };
	const struct convention *c = &s->convention;
	dd limit[2] = { { 1, 0 }, { 1, 0 } };
	double y = c->ndc_y_down ? -up[corner % 4] : up[corner % 4];
	double depth = (corner >= 4) != reversed ? 1 : c->minus_one ? -1 : 0;

	if (s->has_viewport)
		viewport_limits(&s->viewport, limit);
	clip[0] = ex_scale(ex_dd(limit[0]), right[corner % 4]);
	clip[1] = ex_scale(ex_dd(limit[1]), y);
	clip[2] = ex_of(depth);
	clip[3] = ex_of(1);
}

void view_corner(const struct scene *s, const struct map *from_clip,
    bool reversed, int corner, struct ex_sum h[4])
{
	ex clip[4];

	ndc_corner(s, reversed, corner, clip);
	for (int j = 0; j < 4; j++) {
		h[j] = (struct ex_sum){ 0 };
		for (int i = 0; i < 4; i++) {
			int row = i < 3 ? i : AT_ZERO;
			ex m = ex_dd(from_clip->m[row][j]);

			h[j].value = ex_add(h[j].value, ex_mul(clip[i], m));
			h[j].size += fabs(ex_round(clip[i]).hi) *
			    from_clip->sum[row][j];
		}
	}
}
