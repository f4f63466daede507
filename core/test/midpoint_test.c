/* SPDX-License-Identifier: MIT */
/* Searches for points whose images are hard to round. Each search moves a point by
 * whole units in the last place of its coordinates, so that one coordinate of the
 * image approaches the midpoint of two doubles, or of two floats. The moves are chosen
 * as in Euclid's algorithm. Every copy of the kernels must round the images of all
 * points on the way correctly. */
#include <stdlib.h>

#include "claims.h"
#include "block.h"

enum { STEPS = 60 };

/* A transform with its truth, the coordinate of the image, and how many binary digits
 * the format has to which it is rounded. */
struct search {
	struct transform t;
	struct truth truth;
	int j, bits;
};

/* Returns how far coordinate j of the image of p is from the nearest midpoint, in
 * units in the last place, from -1/2 to 1/2. Returns 1 if p has no image or the
 * coordinate is 0. */
static double midpoint_distance(const struct search *h, const double p[4])
{
	int mark = real_mark();
	struct image image;
	double r = 1;

	image_of(&h->truth, &h->t, p, &image);
	if (image.exists && truth_sign(image.n[h->j], NULL) != 0) {
		real v = divide(image.n[h->j].value, image.d.value);

		mpfr_mul_2si(v, v, h->bits - mpfr_get_exp(v), MPFR_RNDN);
		mpfr_frac(v, v, MPFR_RNDN);
		r = mpfr_get_d(sub(magnitude(v), real_of(0.5)), MPFR_RNDN) *
		    mpfr_sgn(v);
	}
	real_release(mark);
	return r;
}

static double without_integer(double a)
{
	return a - rint(a);
}

/* A move of a point by this many units in the last place of each coordinate, and how
 * much the move changes the distance from the midpoint. */
struct move {
	double ulps[4], change;
};

static void move_point(const double p[4], const struct move *m, double times,
    double q[4])
{
	for (int i = 0; i < 4; i++) {
		double ulp = nextafter(fabs(p[i]), HUGE_VAL) - fabs(p[i]);

		q[i] = p[i] + times * m->ulps[i] * ulp;
	}
}

static void measure_change(const struct search *h, const double p[4], struct move *m)
{
	double q[4];

	move_point(p, m, 1, q);
	m->change = without_integer(midpoint_distance(h, q) - midpoint_distance(h, p));
}

/* Subtracts a multiple of b from a so that the change of the rest is least. */
static void reduce(const struct search *h, const double p[4], struct move *a,
    const struct move *b)
{
	double times = rint(a->change / b->change);

	for (int i = 0; i < 4; i++)
		a->ulps[i] -= times * b->ulps[i];
	measure_change(h, p, a);
}

static bool is_move_small(const struct move *m)
{
	for (int i = 0; i < 4; i++)
		if (fabs(m->ulps[i]) > 0x1p40)
			return false;
	return true;
}

static int by_change(const void *a, const void *b)
{
	double x = fabs(((const struct move *)a)->change);
	double y = fabs(((const struct move *)b)->change);

	return (x < y) - (x > y);
}

static void store_point(struct block *b, size_t i, const double p[4])
{
	for (int k = 0; k < 4; k++)
		b->in[k][i] = p[k];
}

/* Fills a block with the point p and the n - 1 points on its way to a midpoint.
 * Returns the distance of the last point from the midpoint, or 1 if p has no image or
 * the coordinate is 0. */
static double approach_midpoint(const struct search *h, double p[4], struct block *b,
    size_t *n)
{
	struct move m[4] = { 0 };
	double best = midpoint_distance(h, p);

	store_point(b, 0, p);
	*n = 1;
	for (int k = 0; k < 4; k++) {
		m[k].ulps[k] = k < h->t.in;
		measure_change(h, p, &m[k]);
	}
	for (int step = 0; step < STEPS && best != 0 && best != 1; step++) {
		int last = 3;
		double q[4];

		qsort(m, 4, sizeof *m, by_change);
		while (last > 0 && m[last].change == 0)
			last--;
		if (m[last].change == 0 || !is_move_small(&m[last]))
			break;
		move_point(p, &m[last], -rint(best / m[last].change), q);
		double now = midpoint_distance(h, q);

		if (fabs(now) < fabs(best)) {
			best = now;
			memcpy(p, q, sizeof q);
			store_point(b, (*n)++, p);
		}
		if (last > 0)
			reduce(h, p, &m[(int)sample_below((unsigned)last)], &m[last]);
	}
	return fabs(best);
}

/* Counts of coordinates, of points that a kernel took, of those among them that it
 * left undecided, of searches, and of searches that ended within 2^-20 of a midpoint.
 * least is the least distance but 0. */
struct count {
	struct tally tally;
	size_t points, undecided, searches, near;
	double least;
};

static void judge_copies(const struct search *h, struct block *b, size_t n,
    struct count *c)
{
	const double *const in[3] = { b->in[0], b->in[1], b->in[2] };
	double *const out[4] = { b->out[0], b->out[1], b->out[2], b->out[3] };

	for (int k = 0; k < COPIES; k++) {
		if (!kernels_choose(copies[k]))
			continue;
		exact_kernel fast = kernels_chosen()->exact[h->t.kernel];

		if (fast != NULL) {
			fast(&h->t.for_kernel, in, out, n);
			for (size_t i = 0; i < n; i++)
				c->undecided += isnan(b->out[0][i]) != 0;
			c->points += n;
		}
		map_block_exactly(&h->t, b, n);
		judge_block(&h->truth, &h->t, b, n, false, &c->tally);
	}
	judge_block(&h->truth, &h->t, b, n, true, &c->tally);
}

static void search_from(struct search *h, const struct block *start, size_t i,
    struct count *c)
{
	static struct block way;
	double p[4];
	size_t n;

	h->j = (int)sample_below((unsigned)h->t.out);
	h->bits = sample_below(4) == 0 ? 24 : 53;
	block_point(start, i, p);
	double end = approach_midpoint(h, p, &way, &n);

	if (end == 1)
		return;
	judge_copies(h, &way, n, c);
	c->searches++;
	c->near += end < 0x1p-20;
	if (end > 0)
		c->least = fmin(c->least, end);
}

static void search_scenes(int e, int scenes)
{
	static struct search h;
	static struct block start;
	struct count c = { .least = 1 };
	struct scene s;
	enum space from;

	SAMPLES(k, scenes) {
		int mark = real_mark();

		h.truth.n = 0;
		if (sample_transform(e, &s, &from, &h.t, &h.truth)) {
			sample_points(&s, from, &start, 8);
			for (size_t i = 0; i < 8; i++)
				search_from(&h, &start, i, &c);
		}
		real_release(mark);
	}
	print_message("10^%d: %zu searches, %zu to within 2^-20 units in "
		      "the last place of a midpoint, the nearest to 2^%.0f; "
		      "%.3g %% of the kernels' points were left "
		      "undecided; %zu of %zu coordinates wrong\n",
	    e, c.searches, c.near, log2(c.least),
	    100.0 * (double)c.undecided / (double)c.points, c.tally.n[WRONG],
	    c.tally.n[NEAREST] + c.tally.n[WRONG]);
	assert_int_equal(c.tally.n[WRONG], 0);
	assert_true(c.near > c.searches / 4);
}

static void images_near_midpoints(void **state)
{
	(void)state;
	search_scenes(0, 60);
	search_scenes(3, 60);
	search_scenes(9, 40);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(images_near_midpoints),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
