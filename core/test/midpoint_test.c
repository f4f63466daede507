/* SPDX-License-Identifier: MIT */
/* A search for points whose images are hard to round: each climbs toward the
 * midpoint of two doubles, or floats, in some coordinate, as near as Euclid's
 * algorithm brings it; on the way every copy of the kernels must be right. */
#include <stdlib.h>

#include "claims.h"
#include "points.h"

enum { STEPS = 60 };

/* The scene, its coordinate, and the digits of what it is rounded to. */
struct hill {
	struct transform t;
	struct truth truth;
	int j, bits;
};

/* Returns the distance of coordinate j from the nearest midpoint, in units in the last
 * place, from -1/2 to 1/2; 1 if there is no midpoint. */
static double height(const struct hill *h, const double p[4])
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

static double wrapped(double a)
{
	return a - rint(a);
}

/* The number of units in the last place of each coordinate, and by how much
 * they lift a point. */
struct move {
	double ulps[4], lift;
};

static void moved(const double p[4], const struct move *m, double times,
    double q[4])
{
	for (int i = 0; i < 4; i++) {
		double ulp = nextafter(fabs(p[i]), HUGE_VAL) - fabs(p[i]);

		q[i] = p[i] + times * m->ulps[i] * ulp;
	}
}

static void lift(const struct hill *h, const double p[4], struct move *m)
{
	double q[4];

	moved(p, m, 1, q);
	m->lift = wrapped(height(h, q) - height(h, p));
}

/* Subtracts from a the multiple of b that makes the lift of the rest least. */
static void reduce(const struct hill *h, const double p[4], struct move *a,
    const struct move *b)
{
	double times = rint(a->lift / b->lift);

	for (int i = 0; i < 4; i++)
		a->ulps[i] -= times * b->ulps[i];
	lift(h, p, a);
}

static bool is_small(const struct move *m)
{
	for (int i = 0; i < 4; i++)
		if (fabs(m->ulps[i]) > 0x1p40)
			return false;
	return true;
}

static int by_lift(const void *a, const void *b)
{
	double x = fabs(((const struct move *)a)->lift);
	double y = fabs(((const struct move *)b)->lift);

	return (x < y) - (x > y);
}

static void keep(struct block *b, size_t i, const double p[4])
{
	for (int k = 0; k < 4; k++)
		b->in[k][i] = p[k];
}

/* Fills a block with a point and its way to the midpoint; returns how near the last
 * point is. */
static double climb(const struct hill *h, double p[4], struct block *b,
    size_t *n)
{
	struct move m[4] = { 0 };
	double best = height(h, p);

	keep(b, 0, p);
	*n = 1;
	for (int k = 0; k < 4; k++) {
		m[k].ulps[k] = k < h->t.in;
		lift(h, p, &m[k]);
	}
	for (int step = 0; step < STEPS && best != 0 && best != 1; step++) {
		int last = 3;
		double q[4];

		qsort(m, 4, sizeof *m, by_lift);
		while (last > 0 && m[last].lift == 0)
			last--;
		if (m[last].lift == 0 || !is_small(&m[last]))
			break;
		moved(p, &m[last], -rint(best / m[last].lift), q);
		double now = height(h, q);

		if (fabs(now) < fabs(best)) {
			best = now;
			memcpy(p, q, sizeof q);
			keep(b, (*n)++, p);
		}
		if (last > 0)
			reduce(h, p, &m[(int)sample_below((unsigned)last)],
			    &m[last]);
	}
	return fabs(best);
}

/* Counts the points that the fast phase leaves undecided. */
struct count {
	struct tally tally;
	size_t points, accurate, climbs, near;
	double least;
};

static void judge_copies(const struct hill *h, struct block *b, size_t n,
    struct count *c)
{
	const double *const in[3] = { b->in[0], b->in[1], b->in[2] };
	double *const out[4] = { b->out[0], b->out[1], b->out[2], b->out[3] };

	for (int k = 0; k < COPIES; k++) {
		if (!kernels_choose(copies[k]))
			continue;
		exact_kernel fast = kernels_chosen()->exact[h->t.kind];

		if (fast != NULL) {
			fast(&h->t.for_kernel, in, out, n);
			for (size_t i = 0; i < n; i++)
				c->accurate += isnan(b->out[0][i]) != 0;
			c->points += n;
		}
		map_block_exactly(&h->t, b, n);
		judge_block(&h->truth, &h->t, b, n, false, &c->tally);
	}
	judge_block(&h->truth, &h->t, b, n, true, &c->tally);
}

static void climb_from(struct hill *h, const struct block *start, size_t i,
    struct count *c)
{
	static struct block way;
	double p[4];
	size_t n;

	h->j = (int)sample_below((unsigned)h->t.out);
	h->bits = sample_below(4) == 0 ? 24 : 53;
	block_point(start, i, p);
	double end = climb(h, p, &way, &n);

	if (end == 1)
		return;
	judge_copies(h, &way, n, c);
	c->climbs++;
	c->near += end < 0x1p-20;
	if (end > 0)
		c->least = fmin(c->least, end);
}

static void climb_hills(int e, int scenes)
{
	static struct hill h;
	static struct block start;
	struct count c = { .least = 1 };
	struct scene s;
	enum space from;

	sample_seed(11);
	for (int k = 0; k < scenes; k++) {
		int mark = real_mark();

		h.truth.n = 0;
		if (sample_transform(e, &s, &from, &h.t, &h.truth)) {
			sample_points(&s, from, &start, 8);
			for (size_t i = 0; i < 8; i++)
				climb_from(&h, &start, i, &c);
		}
		real_release(mark);
	}
	print_message("10^%d: %zu points climbed, %zu to within 2^-20 units in "
		      "the last place of a midpoint, the nearest to 2^%.0f; "
		      "%.3g %% of the kernels' points took the accurate "
		      "phase; %zu of %zu coordinates wrong\n",
	    e, c.climbs, c.near, log2(c.least),
	    100.0 * (double)c.accurate / (double)c.points, c.tally.n[WRONG],
	    c.tally.n[NEAREST] + c.tally.n[WRONG]);
	assert_int_equal(c.tally.n[WRONG], 0);
	assert_true(c.near > c.climbs / 4);
}

static void hard_points(void **state)
{
	(void)state;
	climb_hills(0, 60);
	climb_hills(3, 60);
	climb_hills(9, 40);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(hard_points),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
