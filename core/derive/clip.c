/* SPDX-License-Identifier: MIT */
#include "clip.h"

#include <math.h>
#include <string.h>

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
    const struct transform *image, const struct frustum *f, struct clipper *c,
    struct refusals *faults)
{
	const bool flat = space_is_flat(from), given = from > SPACE_VIEW;
	const enum space base = given ? from : SPACE_VIEW;

	c->in = image->in;
	c->out = image->out;
	c->reaches_eye = !flat && projection_is_open(&s->projection) && to > SPACE_CLIP;
	c->planes = flat || projection_is_open(&s->projection) ? 4 : CLIP_PLANES;
	c->mapped = from != base;
	c->by_distance = to == SPACE_DEVICE && s->has_viewport && s->viewport.distance;
	c->has_weight = from == SPACE_CLIP && to == SPACE_CLIP;
	c->sides = given ? &f->sides.map : &f->sides.from_view;
	c->ends = given ? &f->ends.map : &f->ends.from_view;
	c->is_quick = quick_cut_of(&c->quick, from, to, image, f);
	if (!can_be_cut(s, from, faults) ||
	    !scene_map_factor(s, from, base, &c->to_base, faults) ||
	    !scene_map_factor(s, base, to, &c->to_target, faults) ||
	    (c->by_distance && !set_depth(s, base, c, faults)))
		return false;
	return !ex_has_overflowed() || scene_refuse_too_wide(s, flat, faults);
}

void clip_vertex_set(struct clip_vertex *v, const struct clipper *c, const double *in,
    size_t index, unsigned outside)
{
	memcpy(v->in, in, (size_t)c->in * sizeof *in);
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
	memcpy(r, v, offsetof(struct clip_vertex, at));
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
	map_image(plane < 4 ? c->sides : c->ends, plane % 4, at, side);
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
	map_image(c->ends, 2, v->at, &w);
	return sum_sign(w) <= 0;
}

/* Where a plane cuts a segment from p to q: its functions there. If not exact, they are
 * doubles of which quick_cut_sides is sure. */
struct crossing {
	int plane;
	bool exact;
	double near[2];
	struct sum side[2];
};

static void make_exact(const struct clipper *c, struct clip_vertex *p,
    struct clip_vertex *q, struct crossing *x)
{
	if (x->exact)
		return;
	x->exact = true;
	find_side(c, x->plane, p, &x->side[0]);
	find_side(c, x->plane, q, &x->side[1]);
}

static void find_crossing(const struct clipper *c, bool quick, int plane,
    struct clip_vertex *p, struct clip_vertex *q, struct crossing *x)
{
	x->plane = plane;
	x->exact = false;
	if (!quick ||
	    !quick_cut_sides(&c->quick, plane, p->in, q->in, &x->near[0], &x->near[1]))
		make_exact(c, p, q, x);
}

static int side_sign(const struct crossing *x, int end)
{
	return x->exact ? sum_sign(x->side[end]) : x->near[end] < 0 ? -1 : 1;
}

/* Sets r to the vertex where the plane cuts the segment from p to q. If the crossing is
 * not exact, p and q are points and nothing is located, as no other plane cuts the
 * segment there. */
static void cut_vertex(const struct clipper *c, const struct crossing *x,
    const struct clip_vertex *p, const struct clip_vertex *q, struct clip_vertex *r)
{
	r->cut = true;
	r->located = x->exact;
	r->outside = x->exact ? OUT_BEHIND : 0;
	r->on = (p->on & q->on) | 1u << x->plane;
	memcpy(r->in, p->in, sizeof r->in);
	memcpy(r->other, q->in, sizeof r->other);
	if (x->exact)
		cut_at(c, p->at, &x->side[0], q->at, &x->side[1], r->at);
}

/* Returns the sign of how much farther from p the segment is cut by x than by y: at
 * |a| / (|a| + |b|) of the way, of the functions a at p and b at q. Of doubles that are
 * within 2^-52 the products are within 2^-50 if they are normal. */
static int compare_crossings(const struct clipper *c, struct clip_vertex *p,
    struct clip_vertex *q, struct crossing *x, struct crossing *y)
{
	if (!x->exact && !y->exact) {
		const double far_x = fabs(x->near[0] * y->near[1]);
		const double far_y = fabs(y->near[0] * x->near[1]);
		const double least = fmin(far_x, far_y), most = fmax(far_x, far_y);

		if (least > 0x1p-1000 && most < HUGE_VAL &&
		    least < (1 - 0x1p-40) * most)
			return far_x < far_y ? -1 : 1;
	}
	make_exact(c, p, q, x);
	make_exact(c, p, q, y);
	return sum_sign(sum_minor(sum_abs(x->side[0]), sum_abs(y->side[1]),
	    sum_abs(y->side[0]), sum_abs(x->side[1])));
}

/* Finds by which of the crossings at[] the segment is cut off most at p and at q.
 * Returns false if no more than a point is on the inner sides of all planes. */
static bool find_crossings(const struct clipper *c, struct clip_vertex *p,
    struct clip_vertex *q, struct crossing at[CLIP_PLANES], struct crossing *most[2])
{
	const bool known = knows_planes(p) && knows_planes(q);
	const unsigned all = (1u << c->planes) - 1;

	for (unsigned left = known ? p->outside | q->outside : all; left != 0;
	     left &= left - 1) {
		const int k = __builtin_ctz(left);
		struct crossing *x = &at[k];

		find_crossing(c, c->is_quick && known, k, p, q, x);
		const int a = side_sign(x, 0), b = side_sign(x, 1);
		const int end = a > 0; /* which is cut off */

		if (a >= 0 && b >= 0)
			continue;
		if (a <= 0 && b <= 0)
			return false;
		if (most[end] == NULL ||
		    compare_crossings(c, p, q, x, most[end]) == (end == 0 ? 1 : -1))
			most[end] = x;
	}
	return most[0] == NULL || most[1] == NULL ||
	    compare_crossings(c, p, q, most[0], most[1]) < 0;
}

bool clip_segment(const struct clipper *c, struct clip_vertex *p, struct clip_vertex *q,
    struct clip_vertex end[2])
{
	struct crossing at[CLIP_PLANES], *most[2] = { NULL, NULL };

	if (!find_crossings(c, p, q, at, most))
		return false;
	for (int i = 0; i < 2; i++) {
		end[i].cut = most[i] != NULL;
		if (end[i].cut)
			cut_vertex(c, most[i], p, q, &end[i]);
		/* from the eye on a segment has one point as its image */
		if (is_eye(c, end[i].cut ? &end[i] : i == 0 ? p : q))
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
	const bool quick = c->is_quick && !p->cut && !q->cut &&
	    (p->outside | q->outside) == 1u << plane;
	struct crossing x;

	find_crossing(c, quick, plane, p, q, &x);
	if (side_sign(&x, 0) * side_sign(&x, 1) >= 0)
		return;
	cut_vertex(c, &x, p, q, cut);
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
	if (!v->cut || v->located ||
	    !quick_cut_image(&c->quick, plane_on(v), v->in, v->other, image))
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
static void learn_edge(struct clipper *c, struct clip_vertex *v)
{
	const int plane = plane_on(v);
	double image[4];

	if (!c->quick.has_edges || (v->on & (v->on - 1)) != 0 ||
	    !isnan(c->quick.edge[plane]))
		return;
	exact_image(c, v, false, image);
	c->quick.edge[plane] = image[plane / 2];
}

void clip_image(struct clipper *c, struct clip_vertex *v, bool single, double image[4])
{
	if (quick_image(c, v, single, image))
		return;
	exact_image(c, v, single, image);
	if (v->cut && c->is_quick)
		learn_edge(c, v);
}
