#include "compare.h"

#include <math.h>
#include <string.h>

#include "../points.h"
#include "../test/sample.h"
#include "../test/truth.h"

enum { POINTS = 256 };

/* A regime at one severity. */
struct task {
	const struct regime *regime;
	struct scene scene;
	struct transform exact;
	struct truth truth;
	int n; /* coordinates */
};

static const char *task_of(const struct regime *r, double severity,
    struct task *t)
{
	const struct scene *s = &t->scene;
	enum space from = r->back ? SPACE_DEVICE : SPACE_WORLD;
	enum space to = r->back ? SPACE_WORLD : SPACE_DEVICE;

	t->regime = r;
	regime_scene(r, severity, &t->scene);
	t->n = s->has_window ? 2 : 3;
	if (s->has_window) {
		truth_flat(s, FLAT_WINDOW, FLAT_DEVICE, &t->truth);
		return flat_transform(s, FLAT_WINDOW, FLAT_DEVICE, &t->exact);
	}
	truth_scene(s, from, to, &t->truth);
	return scene_transform(s, from, to, false, &t->exact);
}

static void carry(const struct transform *t, double (*in)[3], double (*out)[4])
{
	double from[3][POINTS_BLOCK], to[3][POINTS_BLOCK] = { { 0 } };
	const double *const x[4] = { from[0], from[1], from[2] };
	double *const y[4] = { to[0], to[1], to[2] };
	const struct accuracy exact = { .precision = PRECISION_EXACT };
	bool single[POINTS_BLOCK];

	for (int i = 0; i < POINTS; i++)
		for (int j = 0; j < 3; j++)
			from[j][i] = in[i][j];
	points_carry(t, &exact, x, y, single, POINTS);
	for (int i = 0; i < POINTS; i++)
		for (int j = 0; j < 3; j++)
			out[i][j] = to[j][i];
}

/* Where points are read, which is not where the regime places them. */
static const char *place(const struct task *t, double (*in)[3])
{
	const struct scene *s = &t->scene;
	double out[POINTS][4];
	struct transform to;
	struct map clip;
	const char *why = s->has_window ?
	    flat_transform(s, FLAT_NDC, FLAT_WINDOW, &to) :
	    scene_transform(s, SPACE_VIEW,
		t->regime->back ? SPACE_DEVICE : SPACE_WORLD, false, &to);

	if (why == NULL)
		why = projection_map(&s->projection, &s->convention, false,
		    &clip);
	if (why != NULL)
		return why;
	sample_seed(1);
	for (int i = 0; i < POINTS; i++)
		t->regime->place(&s->projection, &clip, in[i]);
	carry(&to, in, out);
	for (int i = 0; i < POINTS; i++)
		memcpy(in[i], out[i], sizeof in[i]);
	return NULL;
}

/* The truth about one point. */
struct image {
	int n;
	real q[4], sum[4], at[3];
	double kappa[3];
	bool seen; /* not behind the eye */
};

static void image_of(const struct task *t, const double p[3], struct image *r)
{
	bool divide = t->exact.divide;

	truth_image(&t->truth, (double[]){ p[0], p[1], p[2], 1 }, r->q, r->sum);
	r->n = t->n;
	r->seen = !divide || mpfr_sgn(r->q[3]) > 0;
	for (int j = 0; j < r->n && r->seen; j++) {
		r->at[j] = divide ? over(r->q[j], r->q[3]) : r->q[j];
		r->kappa[j] = truth_kappa(r->q, r->sum, j, divide);
	}
}

static void widen(double *most, double a)
{
	if (!(a <= *most))
		*most = a;
}

static void tally(const struct image *truth, const double got[4],
    struct cell *c)
{
	bool finite = isfinite(got[0]) && isfinite(got[1]) && isfinite(got[2]);

	c->nan |= truth->seen && !finite;
	c->sign |= finite && truth->seen != (got[3] > 0);
	for (int j = 0; j < truth->n && truth->seen && finite; j++) {
		real off = magnitude(sub(number(got[j]), truth->at[j]));

		widen(&c->units, mpfr_get_d(off, MPFR_RNDU));
		if (!is_zero(truth->q[j], truth->sum[j]))
			widen(&c->ulps, ulps(got[j], truth->at[j]));
	}
}

/* Has every point changed sides, from left to right or from top to bottom? */
static void watch_sides(const struct image *truth, const double got[4],
    const struct viewport *v, bool mirrored[2])
{
	const double center[2] = { v->width / 2, v->height / 2 };

	for (int j = 0; j < 2 && truth->seen; j++)
		mirrored[j] &= (got[j] > center[j]) !=
		    (mpfr_cmp_d(truth->at[j], center[j]) > 0);
}

/* The promise of exact, with no tolerance but its own. */
static void check(const struct image *truth, const double got[4], struct row *r)
{
	for (int j = 0; j < truth->n; j++) {
		double error;

		if (isnan(got[j]) || !truth->seen) {
			r->wrong += isnan(got[j]) != !truth->seen;
			continue;
		}
		if (is_zero(truth->q[j], truth->sum[j])) {
			r->wrong += got[j] != 0;
			continue;
		}
		error = (ulps(got[j], truth->at[j]) - 0.5) / truth->kappa[j];
		widen(&r->promise, error / POINTS_BOUND);
		r->wrong += !(error <= POINTS_BOUND);
	}
}

/* The loop for many points and the careful way for one. */
static void check_exact(const struct task *t, const struct image *truth,
    const double in[3], const double got[4], struct row *r)
{
	double p[4] = { in[0], in[1], in[2] }, q[4], kappa;

	check(truth, got, r);
	point_exact(&t->exact, p, q, &kappa);
	check(truth, q, r);
}

static void compute(const struct task *t, double (*in)[3],
    double out[WAYS][POINTS][4])
{
	for (int way = 0; way < EXACT; way++)
		naive_carry(&t->scene, (enum way)way, t->regime->back, in,
		    out[way], POINTS);
	carry(&t->exact, in, out[EXACT]);
	for (int i = 0; i < POINTS; i++)
		out[EXACT][i][3] = 1;
}

void ways_compare(const struct regime *regime, double severity, struct row *r)
{
	static struct task t;
	static double in[POINTS][3], out[WAYS][POINTS][4];
	bool mirrored[WAYS][2];
	int mark = real_mark();

	memset(r, 0, sizeof *r);
	memset(mirrored, !regime->back, sizeof mirrored);
	if (task_of(regime, severity, &t) != NULL || place(&t, in) != NULL) {
		r->wrong++;
		real_release(mark);
		return;
	}
	compute(&t, in, out);
	for (int i = 0; i < POINTS; i++) {
		int point = real_mark();
		struct image truth;

		image_of(&t, in[i], &truth);
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
