/* SPDX-License-Identifier: MIT */
#include "clip.h"

#include <math.h>

#include "../points/kernel/midway.h"

/* A number has at most CUT_WORDS words before it is multiplied, so that EX_WORDS hold
 * each product of a cut. A cut's coordinates have about twice the words of its
 * segment's, and those of ordinary scenes fit through four cuts of cuts. What does not
 * fit is rounded to 3008 bits, with a bound of the error, as numbers with roots are: it
 * counts as 0, or as midway between doubles, only if it is so to as many bits. */
enum {
	CUT_WORDS = 48,
	CUT_ERROR = EX_RANGE - 64 * (CUT_WORDS - 1) + 5,
};

static void shorten(struct sum *a)
{
	if (a->value.n <= CUT_WORDS)
		return;
	const struct sum before = { .error = a->error };

	*a = sum_with_error(sum_truncate(*a, CUT_WORDS), CUT_ERROR);
	if (!sum_is_exact(&before))
		*a = sum_add_error(*a, before);
}

/* Makes the columns of c->depth, from the space where points are cut. */
static bool set_depth(const struct scene *s, enum space base, struct clipper *c,
    struct refusals *faults)
{
	struct distance d;
	struct map to_view;

	if (!distance_of(s, &d, faults) ||
	    !scene_map_factor(s, base, SPACE_VIEW, &to_view, faults))
		return false;
	map_identity(&c->depth);
	for (int i = 0; i < 4; i++) {
		sum_dot(4, to_view.m[i], d.column, 1, &c->depth.m[i][2]);
		c->depth.m[i][3] = sum_mul(to_view.m[i][3], d.length);
	}
	map_set_origin(&c->depth, NULL);
	return true;
}

/* Refuses points of a space that straight lines of view space do not reach. */
static bool can_be_cut(const struct scene *s, enum space from, struct refusals *faults)
{
	if (from == SPACE_DEVICE && s->has_viewport && s->viewport.distance)
		return refuse(faults, "/viewport/depth",
		    "is \"distance\", and no straight lines join points of such a "
		    "device",
		    "take the points to view space first");
	if ((from == SPACE_NDC || from == SPACE_DEVICE) &&
	    projection_is_open(&s->projection))
		return refuse(faults, "/projection/near", "missing",
		    "lines of ndc and device are cut at near and far");
	return true;
}

bool clipper_of(const struct scene *s, enum space from, enum space to,
    struct clipper *c, struct refusals *faults)
{
	const bool flat = space_is_flat(from);
	const bool open = !flat && projection_is_open(&s->projection);
	const enum space base = from > SPACE_VIEW ? from : SPACE_VIEW;

	c->in = flat ? 2 : from == SPACE_CLIP ? 4 : 3;
	c->out = flat ? 2 : to == SPACE_CLIP ? 4 : 3;
	c->reaches_eye = open && to > SPACE_CLIP;
	c->planes = flat || open ? 4 : CLIP_PLANES;
	c->mapped = from != base;
	c->by_distance = to == SPACE_DEVICE && s->has_viewport && s->viewport.distance;
	c->has_weight = from == SPACE_CLIP && to == SPACE_CLIP;
	c->quick = NULL;
	if (!can_be_cut(s, from, faults) ||
	    !scene_map_factor(s, from, base, &c->to_base, faults) ||
	    !scene_map_factor(s, base, to, &c->to_target, faults) ||
	    !frustum_planes(s, base, &c->sides, &c->ends, faults) ||
	    (c->by_distance && !set_depth(s, base, c, faults)))
		return false;
	return !ex_has_overflowed() || scene_refuse_too_wide(s, flat, faults);
}

void clip_vertex_set(struct clip_vertex *v, const struct clipper *c, const double *in,
    size_t index, unsigned outside)
{
	for (int i = 0; i < c->in; i++)
		v->in[i] = in[i];
	v->index = index;
	v->outside = outside;
	v->on = 0;
	v->cut = v->located = false;
}

static int elements(const struct clipper *c)
{
	return c->has_weight ? 5 : 4;
}

static void vertex_copy(const struct clipper *c, struct clip_vertex *r,
    const struct clip_vertex *v)
{
	r->cut = v->cut;
	r->on = v->on;
	r->located = v->located;
	r->index = v->index;
	r->outside = v->outside;
	for (int i = 0; i < c->in; i++) {
		r->in[i] = v->in[i];
		r->other[i] = v->other[i];
	}
	for (int j = 0; j < elements(c) && v->located; j++)
		sum_copy(&r->at[j], &v->at[j]);
}

static void locate_point(const struct clipper *c, const double *in, struct sum at[5])
{
	struct sum p[4];

	for (int i = 0; i < 4; i++)
		sum_set(&p[i], i < c->in ? in[i] : i == 3);
	for (int j = 0; j < 4; j++) {
		if (c->mapped)
			map_image(&c->to_base, j, p, &at[j]);
		else
			sum_copy(&at[j], &p[j]);
		shorten(&at[j]);
	}
	if (c->has_weight)
		sum_set(&at[4], 1);
}

/* Sets *side to the function of a plane at a located point. */
static void plane_side(const struct clipper *c, int plane, const struct sum at[5],
    struct sum *side)
{
	map_image(plane < 4 ? &c->sides : &c->ends, plane % 4, at, side);
	shorten(side);
}

void clip_cut(int n, const struct sum *p, const struct sum *a, const struct sum *q,
    const struct sum *b, struct sum *r)
{
	const bool negative = sum_sign(*a) < 0;

	for (int j = 0; j < n; j++)
		r[j] = sum_negated_if(negative, sum_minor(*a, q[j], *b, p[j]));
}

static void cut_at(const struct clipper *c, const struct sum *p, const struct sum *a,
    const struct sum *q, const struct sum *b, struct sum at[5])
{
	clip_cut(elements(c), p, a, q, b, at);
	for (int j = 0; j < elements(c); j++)
		shorten(&at[j]);
}

/* Returns the plane that has made a vertex which one plane alone has. */
static int plane_on(const struct clip_vertex *v)
{
	return __builtin_ctz(v->on);
}

static void locate(const struct clipper *c, struct clip_vertex *v)
{
	struct sum p[5], q[5], a, b;

	if (v->located)
		return;
	v->located = true;
	if (!v->cut) {
		locate_point(c, v->in, v->at);
		return;
	}
	locate_point(c, v->in, p);
	locate_point(c, v->other, q);
	plane_side(c, plane_on(v), p, &a);
	plane_side(c, plane_on(v), q, &b);
	cut_at(c, p, &a, q, &b, v->at);
}

/* Sets *side to the function of a plane. */
static void find_side(const struct clipper *c, int plane, struct clip_vertex *v,
    struct sum *side)
{
	locate(c, v);
	plane_side(c, plane, v->at, side);
}

/* Returns whether the bits of the vertex tell of which planes it is outside. */
static bool knows_planes(const struct clip_vertex *v)
{
	return (v->outside & OUT_BEHIND) == 0;
}

static bool is_outside(const struct clipper *c, int plane, struct clip_vertex *v)
{
	struct sum side;

	if (knows_planes(v))
		return (v->outside >> plane & 1) != 0;
	find_side(c, plane, v, &side);
	return sum_sign(side) < 0;
}

/* Returns whether a vertex that is not outside of any plane is the eye. */
static bool is_eye(const struct clipper *c, struct clip_vertex *v)
{
	struct sum w;

	if (!c->reaches_eye || knows_planes(v))
		return false;
	locate(c, v);
	map_image(&c->ends, 2, v->at, &w);
	return sum_sign(w) <= 0;
}

static void cut_vertex(const struct clipper *c, int plane, const struct clip_vertex *p,
    const struct sum *a, const struct clip_vertex *q, const struct sum *b,
    struct clip_vertex *r)
{
	r->cut = r->located = true;
	r->outside = OUT_BEHIND;
	r->on = (p->on & q->on) | 1u << plane;
	cut_at(c, p->at, a, q->at, b, r->at);
}

/* Does what cut_vertex does for two points, but locates nothing. Other planes do not
 * cut the segment there. */
static void cut_later(const struct clipper *c, int plane, const struct clip_vertex *p,
    const struct clip_vertex *q, struct clip_vertex *r)
{
	r->cut = true;
	r->located = false;
	r->outside = 0;
	r->on = 1u << plane;
	for (int i = 0; i < c->in; i++) {
		r->in[i] = p->in[i];
		r->other[i] = q->in[i];
	}
}

/* Returns whether the vertices are points, of which the bits are known. */
static bool are_points(const struct clip_vertex *p, const struct clip_vertex *q)
{
	return !p->cut && !q->cut && knows_planes(p) && knows_planes(q);
}

/* Where a plane cuts a segment from p to q, of whose functions a and b one is negative
 * and one positive. */
struct crossing {
	int plane;
	struct sum a, b;
};

/* Returns the sign of how much farther from p the segment is cut by x than by y: at
 * |a| / (|a| + |b|) of the way. */
static int compare_crossings(const struct crossing *x, const struct crossing *y)
{
	return sum_sign(
	    sum_minor(sum_abs(x->a), sum_abs(y->b), sum_abs(y->a), sum_abs(x->b)));
}

static void crossing_copy(struct crossing *r, const struct crossing *x)
{
	r->plane = x->plane;
	sum_copy(&r->a, &x->a);
	sum_copy(&r->b, &x->b);
}

/* Finds by which crossings the segment is cut off most at p and at q. Returns false if
 * no more than a point is on the inner sides of all planes. */
static bool find_crossings(const struct clipper *c, struct clip_vertex *p,
    struct clip_vertex *q, bool cut[2], struct crossing most[2])
{
	const bool known = knows_planes(p) && knows_planes(q);
	struct crossing x;

	for (int k = 0; k < c->planes; k++) {
		if (known && ((p->outside | q->outside) >> k & 1) == 0)
			continue;
		x.plane = k;
		find_side(c, k, p, &x.a);
		find_side(c, k, q, &x.b);
		const int a = sum_sign(x.a), b = sum_sign(x.b);
		const int end = a > 0; /* which is cut off */

		if (a >= 0 && b >= 0)
			continue;
		if (a <= 0 && b <= 0)
			return false;
		if (!cut[end] ||
		    compare_crossings(&x, &most[end]) == (end == 0 ? 1 : -1))
			crossing_copy(&most[end], &x);
		cut[end] = true;
	}
	return !cut[0] || !cut[1] || compare_crossings(&most[0], &most[1]) < 0;
}

/* Functions of a plane at p and q, as double-double arithmetic finds them. */
struct quick_crossing {
	int plane;
	double a, b;
};

/* Does what compare_crossings does, or returns 0 if it is not sure. */
static int compare_quickly(const struct quick_crossing *x,
    const struct quick_crossing *y)
{
	const double far_x = fabs(x->a * y->b), far_y = fabs(y->a * x->b);

	return far_x < (1 - 0x1p-40) * far_y ? -1 : far_y < (1 - 0x1p-40) * far_x;
}

/* Does what find_crossings does for two points, and locates neither. Returns false if
 * double-double arithmetic does not decide. */
static bool find_quickly(const struct clipper *c, const struct clip_vertex *p,
    const struct clip_vertex *q, bool cut[2], struct quick_crossing most[2], bool *some)
{
	struct quick_crossing x;

	for (unsigned left = p->outside | q->outside; left != 0; left &= left - 1) {
		x.plane = __builtin_ctz(left);
		const int end = (p->outside >> x.plane & 1) == 0;
		const int farther = end == 0 ? 1 : -1;

		if (!quick_cut_sides(c->quick, x.plane, p->in, q->in, &x.a, &x.b))
			return false;
		const int order = cut[end] ? compare_quickly(&x, &most[end]) : farther;

		if (order == 0)
			return false;
		if (order == farther)
			most[end] = x;
		cut[end] = true;
	}
	const int order = cut[0] && cut[1] ? compare_quickly(&most[0], &most[1]) : -1;

	*some = order < 0;
	return order != 0;
}

/* Does what clip_segment does if double-double arithmetic decides, and then returns
 * true and sets *some to its result. */
static bool clip_quickly(const struct clipper *c, const struct clip_vertex *p,
    const struct clip_vertex *q, struct clip_vertex end[2], bool *some)
{
	struct quick_crossing most[2];
	bool cut[2] = { false, false };

	if (c->quick == NULL || !are_points(p, q) || (p->outside & q->outside) != 0 ||
	    !find_quickly(c, p, q, cut, most, some))
		return false;
	for (int i = 0; i < 2; i++) {
		end[i].cut = cut[i];
		if (cut[i])
			cut_later(c, most[i].plane, p, q, &end[i]);
	}
	return true;
}

bool clip_segment(const struct clipper *c, struct clip_vertex *p, struct clip_vertex *q,
    struct clip_vertex end[2])
{
	struct crossing most[2];
	bool cut[2] = { false, false }, some;

	if (clip_quickly(c, p, q, end, &some))
		return some;
	if (!find_crossings(c, p, q, cut, most))
		return false;
	for (int i = 0; i < 2; i++) {
		end[i].cut = cut[i];
		if (cut[i])
			cut_vertex(c, most[i].plane, p, &most[i].a, q, &most[i].b,
			    &end[i]);
		/* from the eye on a segment has one point as its image */
		if (is_eye(c, cut[i] ? &end[i] : i == 0 ? p : q))
			return false;
	}
	return true;
}

void clip_ring_begin(struct clip_ring *r, const struct clipper *c,
    void (*emit)(void *data, struct clip_vertex *), void *data)
{
	r->clipper = c;
	r->emit = emit;
	r->data = data;
	for (int k = 0; k < CLIP_PLANES; k++)
		r->stage[k].begun = false;
}

static void ring_pass(struct clip_ring *r, int plane, struct clip_vertex *v);

/* Hands on where the plane cuts the edge from p to q, of which one is outside. If the
 * other lies on the plane, nothing is cut. */
static void ring_cross(struct clip_ring *r, int plane, struct clip_vertex *p,
    struct clip_vertex *q)
{
	const struct clipper *c = r->clipper;
	struct clip_vertex *cut = &r->stage[plane].cut;
	struct sum a, b;
	double near_a, near_b;

	if (c->quick != NULL && are_points(p, q) &&
	    (p->outside | q->outside) == 1u << plane &&
	    quick_cut_sides(c->quick, plane, p->in, q->in, &near_a, &near_b)) {
		cut_later(c, plane, p, q, cut);
		ring_pass(r, plane + 1, cut);
		return;
	}
	find_side(c, plane, p, &a);
	find_side(c, plane, q, &b);
	if (sum_sign(a) * sum_sign(b) >= 0)
		return;
	cut_vertex(c, plane, p, &a, q, &b, cut);
	ring_pass(r, plane + 1, cut);
}

/* Gives a vertex to the stage of a plane. */
static void ring_pass(struct clip_ring *r, int plane, struct clip_vertex *v)
{
	const struct clipper *c = r->clipper;
	struct clip_stage *s = &r->stage[plane];

	if (plane == c->planes) {
		if (!is_eye(c, v))
			r->emit(r->data, v);
		return;
	}
	const bool out = is_outside(c, plane, v);

	if (!s->begun)
		vertex_copy(c, &s->first, v);
	else if (out != s->last_out)
		ring_cross(r, plane, &s->last, v);
	if (!s->begun)
		s->first_out = out;
	s->begun = true;
	s->last_out = out;
	vertex_copy(c, &s->last, v);
	if (!out)
		ring_pass(r, plane + 1, v);
}

void clip_ring_add(struct clip_ring *r, const double *in, size_t index,
    unsigned outside)
{
	clip_vertex_set(&r->given, r->clipper, in, index, outside);
	ring_pass(r, 0, &r->given);
}

void clip_ring_end(struct clip_ring *r)
{
	for (int k = 0; k < r->clipper->planes; k++) {
		struct clip_stage *s = &r->stage[k];

		if (s->begun && s->first_out != s->last_out)
			ring_cross(r, k, &s->last, &s->first);
	}
}

static void exact_image(const struct clipper *c, struct clip_vertex *v, bool single,
    double image[4])
{
	struct sum n, d, z;

	locate(c, v);
	if (c->out == 4)
		d = sum_mul(c->to_target.divisor, v->at[c->has_weight ? 4 : 3]);
	else
		map_image(&c->to_target, 3, v->at, &d);
	for (int k = 0; k < c->out; k++) {
		const bool depth = k == 2 && c->by_distance;

		if (depth)
			map_image(&c->depth, 3, v->at, &z);
		map_image(depth ? &c->depth : &c->to_target, k, v->at, &n);
		image[k] = (double)NAN;
		if (sum_sign(d) != 0)
			image[k] = sum_ratio_nearest(&n, depth ? &z : &d, single);
		if (!isfinite(image[k]))
			image[k] = (double)NAN;
	}
}

/* Does what exact_image does, unless it is not sure, and then returns false. A double
 * that is not midway between two floats rounds to the same float as the exact image. */
static bool quick_image(const struct clipper *c, const struct clip_vertex *v,
    bool single, double image[4])
{
	if (!v->cut || v->located || c->quick == NULL ||
	    !quick_cut_image(c->quick, plane_on(v), v->in, v->other, image))
		return false;
	for (int k = 0; k < c->out && single; k++) {
		if (is_midway(image[k]))
			return false;
		image[k] = (double)(float)image[k];
		if (isinf(image[k]))
			image[k] = (double)NAN;
	}
	return true;
}

/* Takes the coordinate that all images of cuts by the vertex's plane have in common. */
static void learn_edge(const struct clipper *c, struct clip_vertex *v)
{
	const int plane = plane_on(v);
	double image[4];

	if (!c->quick->has_edges || (v->on & (v->on - 1)) != 0 ||
	    !isnan(c->quick->edge[plane]))
		return;
	exact_image(c, v, false, image);
	c->quick->edge[plane] = image[plane / 2];
}

void clip_image(const struct clipper *c, struct clip_vertex *v, bool single,
    double image[4])
{
	if (quick_image(c, v, single, image))
		return;
	exact_image(c, v, single, image);
	if (v->cut && c->quick != NULL)
		learn_edge(c, v);
}
