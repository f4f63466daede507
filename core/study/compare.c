/* SPDX-License-Identifier: MIT */
#include "compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../test/block.h"

enum { MANY = 256 };

/* The scene of a regime at one severity, and its maps. */
struct task {
	const struct regime *regime;
	struct scene scene;
	struct transform exact;
	struct truth truth;
	int n; /* coordinates */
};

static bool task_of(const struct regime *r, double severity, struct task *t)
{
	const struct scene *s = &t->scene;
	enum space from = r->back ? SPACE_DEVICE : SPACE_MODEL;
	enum space to = r->back ? SPACE_MODEL : SPACE_DEVICE;

	t->regime = r;
	regime_scene(r, severity, &t->scene);
	t->n = s->has_window ? 2 : 3;
	if (s->has_window) {
		truth_flat(s, FLAT_WINDOW, FLAT_DEVICE, &t->truth);
		return transform_of_scene(s, FLAT_WINDOW, FLAT_DEVICE, false, &t->exact,
		    NULL);
	}
	truth_scene(s, from, to, &t->truth);
	return transform_of_scene(s, from, to, false, &t->exact, NULL);
}

static void fill(struct block *b, double (*in)[3])
{
	for (int i = 0; i < MANY; i++)
		for (int j = 0; j < 3; j++)
			b->in[j][i] = in[i][j];
}

/* Computes images as the program does. Points with an image are in front of the eye, so
 * w becomes 1. */
static void carry_in(enum precision precision, const struct transform *t,
    double (*in)[3], double (*out)[4])
{
	static struct block b;

	fill(&b, in);
	memset(b.out, 0, sizeof b.out);
	map_block(t, precision, &b, MANY);
	for (int i = 0; i < MANY; i++) {
		for (int j = 0; j < 3; j++)
			out[i][j] = b.out[j][i];
		out[i][3] = 1;
	}
}

/* Returns the share of the points that a loop of core/points/kernel cannot round with
 * certainty. */
static double left_over(const struct transform *t, double (*in)[3])
{
	static struct block b;
	const double *const from[3] = { b.in[0], b.in[1], b.in[2] };
	double *const to[3] = { b.out[0], b.out[1], b.out[2] };
	int n = 0;

	fill(&b, in);
	kernels_chosen()->exact[t->kernel](&t->for_kernel, from, to, MANY);
	for (int i = 0; i < MANY; i++)
		n += isnan(b.out[0][i]) != 0;
	return n / (double)MANY;
}

/* Returns the double that is read after a was printed in 17 digits, as points are. */
static double printed(double a)
{
	char text[32];

	snprintf(text, sizeof text, "%.17g", a);
	return strtod(text, NULL);
}

/* Sets in to the points as the program reads them, which the regime places in another
 * space. */
static bool place(const struct task *t, double (*in)[3])
{
	const struct scene *s = &t->scene;
	double out[MANY][4];
	struct transform to;
	struct map clip;
	const enum space from = s->has_window ? FLAT_NDC : SPACE_VIEW;
	const enum space at = s->has_window ? FLAT_WINDOW :
	    t->regime->back                 ? SPACE_DEVICE :
					      SPACE_MODEL;

	if (!transform_of_scene(s, from, at, false, &to, NULL) ||
	    !projection_map(&s->projection, &s->convention, false, &clip, NULL))
		return false;
	sample_seed(1);
	for (int i = 0; i < MANY; i++)
		t->regime->place(&s->projection, &clip, in[i]);
	carry_in(PRECISION_EXACT, &to, in, out);
	for (int i = 0; i < MANY; i++)
		for (int j = 0; j < 3; j++)
			in[i][j] = printed(out[i][j]);
	return true;
}

/* The truth about one point. */
struct true_image {
	struct image image;
	int n;
	real at[3];
};

static void true_image_of(const struct task *t, const double p[3], struct true_image *r)
{
	image_of(&t->truth, &t->exact, (double[4]){ p[0], p[1], p[2] }, &r->image);
	r->n = t->n;
	for (int j = 0; j < r->n && r->image.exists; j++)
		r->at[j] = divide(r->image.n[j].value, r->image.d.value);
}

static void widen(double *most, double a)
{
	if (!(a <= *most))
		*most = a;
}

static void tally(const struct true_image *truth, const double got[4], struct cell *c)
{
	bool finite = isfinite(got[0]) && isfinite(got[1]) && isfinite(got[2]);
	bool seen = truth->image.exists;

	c->nan |= seen && !finite;
	c->sign |= finite && seen != (got[3] > 0);
	for (int j = 0; j < truth->n && seen && finite; j++) {
		real off = magnitude(sub(real_of(got[j]), truth->at[j]));

		widen(&c->units, mpfr_get_d(off, MPFR_RNDU));
		if (truth_sign(truth->image.n[j], NULL) != 0)
			widen(&c->ulps, ulps(got[j], truth->at[j]));
	}
}

/* Clears mirrored[j] if this point is on the right side of the centre along axis j. An
 * image is mirrored if that stays set for all points. */
static void watch_sides(const struct true_image *truth, const double got[4],
    const struct viewport *v, bool mirrored[2])
{
	const double center[2] = { v->x + v->width / 2, v->y + v->height / 2 };

	for (int j = 0; j < 2 && truth->image.exists; j++)
		mirrored[j] &= (got[j] > center[j]) !=
		    (mpfr_cmp_d(truth->at[j], center[j]) > 0);
}

/* Counts where exact is not the nearest double, in the loop for many points and in
 * point_exact for one. */
static void check_exact(const struct task *t, const struct true_image *truth,
    const double in[3], const double got[4], struct row *r)
{
	double p[4] = { in[0], in[1], in[2] }, q[4];
	struct tally verdicts = { 0 };

	judge_image(&truth->image, t->n, got, false, &verdicts);
	point_exact(&t->exact, p, q);
	judge_image(&truth->image, t->n, q, false, &verdicts);
	r->wrong += (int)verdicts.n[WRONG];
	r->ruled += (int)verdicts.n[WITHIN_TOLERANCE];
}

static void compute(const struct task *t, double (*in)[3], double out[WAYS][MANY][4])
{
	for (int way = 0; way < OUR_SINGLE; way++)
		naive_carry(&t->scene, (enum way)way, t->regime->back, in, out[way],
		    MANY);
	carry_in(PRECISION_SINGLE, &t->exact, in, out[OUR_SINGLE]);
	carry_in(PRECISION_DOUBLE, &t->exact, in, out[OUR_DOUBLE]);
	carry_in(PRECISION_EXACT, &t->exact, in, out[EXACT]);
}

void ways_compare(const struct regime *regime, double severity, struct row *r)
{
	static struct task t;
	static double in[MANY][3], out[WAYS][MANY][4];
	bool mirrored[WAYS][2];
	int mark = real_mark();

	memset(r, 0, sizeof *r);
	memset(mirrored, !regime->back, sizeof mirrored);
	r->refused = !task_of(regime, severity, &t) || !place(&t, in);
	r->wrong = r->refused != (severity == 0);
	if (r->refused) {
		for (int way = 0; way < OUR_SINGLE; way++)
			r->cell[way].nan = true;
		real_release(mark);
		return;
	}
	compute(&t, in, out);
	r->accurate = left_over(&t.exact, in);
	for (int i = 0; i < MANY; i++) {
		int point = real_mark();
		struct true_image truth;

		true_image_of(&t, in[i], &truth);
		for (int way = 0; way < WAYS; way++) {
			tally(&truth, out[way][i], &r->cell[way]);
			watch_sides(&truth, out[way][i], &t.scene.viewport,
			    mirrored[way]);
		}
		check_exact(&t, &truth, in[i], out[EXACT][i], r);
		real_release(point);
	}
	for (int way = 0; way < WAYS; way++)
		r->cell[way].sign |= mirrored[way][0] || mirrored[way][1];
	real_release(mark);
}
