/* SPDX-License-Identifier: MIT */
/* What is left of segments and polygons, and the images of cuts, are what MPFR finds:
 * of a segment by the parts of the way at which the planes cut it, of a polygon by
 * cutting it at one plane after another. Images are the nearest doubles, also those
 * that quick_cut.h computes. */
#include "../derive/clip.h"

#include "claims.h"
#include "block.h"

enum { VERTICES = 7, VERTICES_MAX = 128, W = 6 };

/* A point or vertex, homogeneous in the space of the points: its coordinates times the
 * weight. */
struct truth_vertex {
	struct sized at[4], weight;
	int index; /* of the point; -1: a cut */
};

struct truth_clip {
	bool flat, keeps_w, by_distance, irrational, doubtful;
	int in, out, planes;
	struct truth to_clip, to_target, to_view;
	struct sized plane[4][W]; /* of the unit vectors of clip space */
	real distance[4];
};

static struct sized scaled(struct sized a, real factor)
{
	return (struct sized){ mul(a.value, factor), mul(a.size, magnitude(factor)) };
}

static struct sized image_at(const struct truth *t, int j, const struct sized p[4])
{
	struct sized r = sized_of(0);

	for (int i = 0; i < 4; i++)
		r = sized_add(r, sized_mul(p[i], truth_element(t, i, j)));
	return r;
}

static void set_truth(const struct scene *s, enum space from, enum space to,
    struct truth_clip *t)
{
	memset(t, 0, sizeof *t);
	t->flat = space_is_flat(from);
	t->in = t->flat ? 2 : from == SPACE_CLIP ? 4 : 3;
	t->out = t->flat ? 2 : to == SPACE_CLIP ? 4 : 3;
	t->keeps_w = to == SPACE_CLIP;
	t->planes = t->flat || projection_is_open(&s->projection) ? 4 : 6;
	t->by_distance = to == SPACE_DEVICE && s->viewport.distance;
	if (t->flat) {
		truth_flat(s, from, FLAT_NDC, &t->to_clip);
		truth_flat(s, from, to, &t->to_target);
	} else {
		truth_scene(s, from, SPACE_CLIP, &t->to_clip);
		truth_scene(s, from, to, &t->to_target);
		truth_scene(s, from, SPACE_VIEW, &t->to_view);
		truth_distance(s, t->distance);
	}
	for (int j = 0; j < 4 && !t->flat; j++) {
		struct sized unit[4];

		for (int i = 0; i < 4; i++)
			unit[i] = sized_of(i == j);
		truth_planes(s, unit, t->plane[j]);
	}
	t->irrational = t->to_clip.irrational || t->to_target.irrational ||
	    t->to_view.irrational || t->by_distance;
}

/* Sets the functions of the planes and of w at a point. */
static void find_planes(const struct truth_clip *t, const struct sized p[4],
    struct sized plane[W + 1])
{
	struct sized q[4];

	for (int j = 0; j < 4; j++)
		q[j] = image_at(&t->to_clip, j, p);
	plane[W] = q[3];
	for (int k = 0; k < t->planes && !t->flat; k++) {
		plane[k] = sized_of(0);
		for (int j = 0; j < 4; j++)
			plane[k] = sized_add(plane[k], sized_mul(q[j], t->plane[j][k]));
	}
	if (!t->flat)
		return;
	for (int i = 0; i < 4; i++)
		plane[i] = i % 2 ? sized_sub(q[3], q[i / 2]) :
				   sized_add(q[3], q[i / 2]);
}

/* Returns a sign, and remembers if it is in doubt. */
static int sign_of(struct truth_clip *t, struct sized a)
{
	bool doubtful;
	const int sign = truth_sign(a, &doubtful);

	t->doubtful |= t->irrational && sign != 0 && doubtful;
	return sign;
}

static void cut_truth(const struct truth_vertex *p, struct sized a,
    const struct truth_vertex *q, struct sized b, struct truth_vertex *r)
{
	a = (struct sized){ magnitude(a.value), a.size };
	b = (struct sized){ magnitude(b.value), b.size };
	for (int j = 0; j < 4; j++)
		r->at[j] = sized_add(sized_mul(b, p->at[j]), sized_mul(a, q->at[j]));
	r->weight = sized_add(sized_mul(b, p->weight), sized_mul(a, q->weight));
	r->index = -1;
}

static void judge(const struct truth_clip *t, const struct truth_vertex *v,
    const double *image, bool single, struct tally *tally)
{
	struct sized n, d, w = v->weight;

	if (!t->keeps_w)
		w = image_at(&t->to_target, 3, v->at);
	for (int k = 0; k < t->out; k++) {
		n = image_at(&t->to_target, k, v->at);
		d = w;
		if (k == 2 && t->by_distance) {
			n = sized_of(0);
			for (int i = 0; i < 4; i++)
				n = sized_add(n,
				    scaled(image_at(&t->to_view, i, v->at),
					t->distance[i]));
			d = image_at(&t->to_view, 3, v->at);
		}
		if (truth_sign(d, NULL) == 0) { /* far is at infinity */
			assert_true(isnan(image[k]));
			continue;
		}
		const enum verdict verdict = truth_verdict(image[k], n, d, single);

		tally->n[verdict == WITHIN_TOLERANCE && !t->irrational ? WRONG :
									 verdict]++;
		if (verdict == WRONG)
			fail_msg("coordinate %d: came %.17g, expected %.17g", k,
			    image[k], mpfr_get_d(divide(n.value, d.value), MPFR_RNDN));
	}
}

/* Samples points near the volume, on its planes and far from it, some of them behind
 * the eye, with the first ones repeated now and then. */
static void sample_near(const struct scene *s, enum space from, struct block *b)
{
	static struct block ndc;
	struct transform t;
	const enum space space = space_is_flat(from) ? FLAT_NDC : SPACE_NDC;

	sample_points(s, space_is_flat(from) ? SPACE_MODEL : from, b, VERTICES);
	if (!transform_of_scene(s, space, from, false, &t, NULL))
		return;
	for (size_t i = 0; i < VERTICES; i++)
		for (int j = 0; j < 4; j++)
			ndc.in[j][i] = sample_below(4) > 0 ?
			    sample_between(-2, 2) :
			    (double)sample_below(3) - 1;
	map_block_exactly(&t, &ndc, VERTICES);
	for (size_t i = 0; i < VERTICES; i++)
		for (int j = 0;
		     j < t.out && sample_below(8) > 0 && !isnan(ndc.out[0][i]); j++)
			b->in[j][i] = ndc.out[j][i];
}

static void set_vertex(const struct truth_clip *t, const double p[4], int index,
    struct truth_vertex *v)
{
	for (int j = 0; j < 4; j++)
		v->at[j] = sized_of(j < t->in ? p[j] : j == 3);
	v->weight = sized_of(1);
	v->index = index;
}

struct counts {
	struct tally tally;
	int segments, polygons, cut, quick, deep;
};

/* Finds the visible part of a segment, from part[0] to part[1] of the way, and which
 * plane cuts it there; -1: none. Returns false if it is no more than a point. */
static bool find_part(struct truth_clip *t, const struct truth_vertex v[2], int cut[2],
    struct sized side[2][2])
{
	struct sized plane[2][W + 1], part[2] = { sized_of(0), sized_of(1) };
	bool some = true;

	for (int i = 0; i < 2; i++)
		find_planes(t, v[i].at, plane[i]);
	cut[0] = cut[1] = -1;
	for (int k = 0; k < t->planes; k++) {
		const struct sized a = plane[0][k], b = plane[1][k];
		const int sa = sign_of(t, a), sb = sign_of(t, b);

		some = some && !(sa < 0 && sb < 0);
		if (!some || (sa >= 0 && sb >= 0))
			continue;
		const struct sized whole = sized_sub(a, b);
		const struct sized at = { divide(a.value, whole.value),
			divide(mul(a.size, whole.size),
			    mul(whole.value, whole.value)) };
		const int end = sa >= 0;

		if (sign_of(t, sized_sub(at, part[end])) != (end == 0 ? 1 : -1))
			continue;
		part[end] = at;
		cut[end] = k;
		side[end][0] = a;
		side[end][1] = b;
	}
	return some && sign_of(t, sized_sub(part[1], part[0])) > 0;
}

static void check_segment(struct truth_clip *t, struct clipper *clipper,
    const struct block *b, const unsigned char *outside, size_t i, struct counts *c)
{
	static struct clip_vertex v[2], end[2];
	struct truth_vertex truth[2];
	struct sized side[2][2];
	double image[4], p[4];
	const bool single = sample_below(4) == 0;
	int cut[2];

	for (size_t k = 0; k < 2; k++) {
		block_point(b, i + k, p);
		set_vertex(t, p, 0, &truth[k]);
		clip_vertex_set(&v[k], clipper, p, i + k,
		    sample_below(4) == 0 ? OUT_BEHIND : outside[i + k]);
	}
	t->doubtful = false;
	bool some = find_part(t, truth, cut, side);
	const bool found = clip_segment(clipper, &v[0], &v[1], end);

	for (int k = 0; k < 2 && some && clipper->reaches_eye; k++) {
		struct truth_vertex at = truth[k];
		struct sized plane[W + 1];

		if (cut[k] >= 0)
			cut_truth(&truth[0], side[k][0], &truth[1], side[k][1], &at);
		find_planes(t, at.at, plane);
		some = some && sign_of(t, plane[W]) > 0;
	}
	if (t->doubtful)
		return;
	assert_int_equal(found, some);
	c->segments++;
	for (int k = 0; k < 2 && some; k++) {
		assert_int_equal(end[k].cut, cut[k] >= 0);
		if (cut[k] < 0)
			continue;
		struct truth_vertex at;

		cut_truth(&truth[0], side[k][0], &truth[1], side[k][1], &at);
		clip_image(clipper, &end[k], single, image);
		judge(t, &at, image, single, &c->tally);
		c->cut++;
		c->quick += !end[k].located;
	}
}

/* Cuts a polygon at a plane, and returns how many vertices it then has. */
static int cut_polygon(struct truth_clip *t, int k, const struct truth_vertex *v, int n,
    struct truth_vertex *r)
{
	int count = 0;

	struct sized side[VERTICES_MAX], plane[W + 1];

	for (int i = 0; i < n; i++) {
		find_planes(t, v[i].at, plane);
		side[i] = plane[k];
	}
	for (int i = 0; i < n; i++) {
		const int next = (i + 1) % n;
		const int a = sign_of(t, side[i]), b = sign_of(t, side[next]);

		if (a >= 0)
			r[count++] = v[i];
		if (a * b < 0)
			cut_truth(&v[i], side[i], &v[next], side[next], &r[count++]);
	}
	return count;
}

/* The vertices that came, with their images. */
struct came {
	struct clipper *clipper;
	int n, index[VERTICES_MAX], depth[VERTICES_MAX];
	double image[VERTICES_MAX][4];
};

static void take(void *data, struct clip_vertex *v)
{
	struct came *c = data;

	assert_true(c->n < VERTICES_MAX);
	c->index[c->n] = v->cut ? -1 : (int)v->index;
	c->depth[c->n] = v->cut ? __builtin_popcount(v->on) : 0;
	clip_image(c->clipper, v, false, c->image[c->n++]);
}

static void check_polygon(struct truth_clip *t, struct clipper *clipper,
    const struct block *b, const unsigned char *outside, int n, struct counts *c)
{
	static struct clip_ring ring;
	static struct came came;
	struct truth_vertex v[2][VERTICES_MAX], *from = v[0], *to = v[1];
	struct sized plane[W + 1];
	double p[4];
	int left = n, at = 0;

	came = (struct came){ .clipper = clipper };
	clip_ring_begin(&ring, clipper, take, &came);
	for (int i = 0; i < n; i++) {
		block_point(b, (size_t)i, p);
		set_vertex(t, p, i, &from[i]);
		clip_ring_add(&ring, p, (size_t)i, outside[i]);
	}
	clip_ring_end(&ring);
	t->doubtful = false;
	for (int k = 0; k < t->planes; k++) {
		struct truth_vertex *swap = from;

		left = cut_polygon(t, k, from, left, to);
		from = to;
		to = swap;
	}
	for (int i = 0; i < left; i++) {
		find_planes(t, from[i].at, plane);
		if (!clipper->reaches_eye || sign_of(t, plane[W]) > 0)
			from[at++] = from[i];
	}
	if (t->doubtful)
		return;
	assert_int_equal(came.n, at);
	c->polygons++;
	for (int i = 0; i < at; i++) {
		assert_int_equal(came.index[i], from[i].index);
		judge(t, &from[i], came.image[i], false, &c->tally);
		c->deep += came.depth[i] > 1;
	}
}

static bool sample_clip(int k, struct scene *s, enum space *from, enum space *to)
{
	const bool flat = k % 5 == 0;

	if (k % 5 == 1)
		sample_round_scene(s);
	else
		sample_scene(s, k % 5 == 2 ? 4 : 0);
	sample_answer(s);
	s->has_device &= sample_below(4) > 0;
	s->has_viewport &= sample_below(4) > 0 ||
	    projection_has_intrinsics(&s->projection);
	s->viewport.distance = sample_below(6) == 0;
	*from = flat        ? FLAT_WINDOW + sample_below(s->has_device ? 3 : 2) :
	    sample_below(2) ? SPACE_MODEL + sample_below(3) :
			      SPACE_MODEL + sample_below(s->has_viewport ? 6 : 5);
	*to = flat ? FLAT_WINDOW + sample_below(s->has_device ? 3 : 2) :
		     SPACE_MODEL + sample_below(s->has_viewport ? 6 : 5);
	return true;
}

static void parts_are_true(void **state)
{
	static struct block b;
	static struct clipper clipper;
	static struct transform image;
	static struct frustum f;
	static struct truth_clip t;
	static struct counts c;
	unsigned char outside[VERTICES];
	struct scene s;
	enum space from, to;

	(void)state;
	kernels_choose(NULL);
	SAMPLES(k, 1600) {
		const int mark = real_mark();

		ex_has_overflowed();
		if (!sample_clip(k, &s, &from, &to) ||
		    !frustum_of(&s, from, false, &f, NULL) ||
		    !distance_transform(&s, from, to, &image, NULL) ||
		    !clipper_of(&s, from, to, &image, &f, &clipper, NULL))
			continue;
		sample_near(&s, from, &b);
		frustum_outside_all(&f,
		    (const double *[4]){ b.in[0], b.in[1], b.in[2], b.in[3] }, outside,
		    VERTICES);
		set_truth(&s, from, to, &t);
		clipper.is_quick = clipper.is_quick && sample_below(4) > 0;
		const int of_points = real_mark();

		for (size_t i = 0; i + 1 < VERTICES; i++) {
			check_segment(&t, &clipper, &b, outside, i, &c);
			real_release(of_points);
		}
		for (int n = 3; n <= VERTICES; n += 2) {
			check_polygon(&t, &clipper, &b, outside, n, &c);
			real_release(of_points);
		}
		assert_false(k % 5 != 2 && ex_has_overflowed());
		real_release(mark);
	}
	print_message("%d segments, %d polygons: %d cuts, %d of them quick, and %d "
		      "cuts of cuts: %zu numbers, %zu within the tolerance\n",
	    c.segments, c.polygons, c.cut, c.quick, c.deep, c.tally.n[NEAREST],
	    c.tally.n[WITHIN_TOLERANCE]);
	assert_true(c.cut > 1500 && c.quick > 100 && c.deep > 500);
	assert_int_equal(c.tally.n[WRONG], 0);
	assert_true(c.tally.n[WITHIN_TOLERANCE] <= c.tally.n[NEAREST] / 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(parts_are_true),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
