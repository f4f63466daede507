#include "truth.h"

#include <string.h>

struct truth_stage *truth_stage(struct truth *t)
{
	struct truth_stage *s = &t->stage[t->n++];

	set(s->before, 3, NULL);
	set_unit(s->m);
	set(s->after, 3, NULL);
	return s;
}

/* A point under way: v + w c. A translation c isn't added to v until the next
 * stage's before has been taken from it, as their difference is one number. */
struct point {
	real v[4], sum[4], c[3];
};

static void join(struct point *p)
{
	for (int k = 0; k < 3; k++) {
		p->v[k] = add(p->v[k], mul(p->v[3], p->c[k]));
		p->sum[k] = add(p->sum[k], mul(p->sum[3], magnitude(p->c[k])));
		p->c[k] = number(0);
	}
}

static void pass(struct point *p, const struct truth_stage *s)
{
	real v[4], sum[4];

	for (int k = 0; k < 3; k++)
		p->c[k] = sub(p->c[k], s->before[k]);
	join(p);
	set(v, 4, NULL);
	set(sum, 4, NULL);
	for (int k = 0; k < 4; k++)
		for (int j = 0; j < 4; j++) {
			v[j] = add(v[j], mul(p->v[k], s->m[k][j]));
			sum[j] = add(sum[j],
			    mul(p->sum[k], magnitude(s->m[k][j])));
		}
	memcpy(p->v, v, sizeof v);
	memcpy(p->sum, sum, sizeof sum);
	memcpy(p->c, s->after, sizeof p->c);
}

void truth_image(const struct truth *t, const double at[4], real q[4],
    real sum[4])
{
	struct point p;
	bool place = at[3] == 1;

	set(p.v, 4, place ? (double[]){ 0, 0, 0, 1 } : at);
	set(p.c, 3, place ? at : NULL);
	for (int k = 0; k < 4; k++)
		p.sum[k] = magnitude(p.v[k]);
	for (int i = 0; i < t->n; i++)
		pass(&p, &t->stage[i]);
	join(&p);
	memcpy(q, p.v, sizeof p.v);
	memcpy(sum, p.sum, sizeof p.sum);
}

void truth_matrix(const struct truth *t, real m[4][4], real sum[4][4])
{
	for (int i = 0; i < 4; i++) {
		double unit[4] = { 0 };

		unit[i] = 1;
		truth_image(t, unit, m[i], sum[i]);
	}
}

double truth_kappa(real q[4], real sum[4], int j, bool divided)
{
	real kappa = over(sum[j], magnitude(q[j]));

	if (divided)
		kappa = mul(kappa, over(sum[3], magnitude(q[3])));
	return mpfr_get_d(kappa, MPFR_RNDN);
}

/* One element: how far it is off, how far what it prints, and whether it is 0
 * where the truth is. */
static void compare(dd got, double size, real exact, real sum, struct worst *w)
{
	double kappa = mpfr_get_d(over(sum, magnitude(exact)), MPFR_RNDU);
	double e = u2_error(got, exact, size);

	if (!(e <= w->error))
		w->error = e;
	if (is_zero(exact, sum)) {
		w->ghosts += got.hi != 0 || got.lo != 0;
		return;
	}
	/* Of doubles below 2^-968 the low part would be below the least double. */
	e = (ulps(got.hi, exact) - 0.5) / kappa * 0x1p47;
	if (!(e <= w->printed) && mpfr_cmpabs(exact, number(0x1p-968)) > 0)
		w->printed = e;
	e = size / mpfr_get_d(sum, MPFR_RNDU);
	if (!(e <= w->size))
		w->size = e;
}

void truth_compare(const struct truth *t, const struct map *r, struct worst *w)
{
	int mark = real_mark();
	real m[4][4], sum[4][4], q[4], s[4];
	double at[4] = { [3] = 1 };

	memcpy(at, r->origin, sizeof r->origin);
	truth_matrix(t, m, sum);
	truth_image(t, at, q, s);
	for (int j = 0; j < 4; j++) {
		for (int i = 0; i < 3; i++)
			compare(r->m[i][j], r->sum[i][j], m[i][j], sum[i][j],
			    w);
		compare(r->m[AT_ZERO][j], r->sum[AT_ZERO][j], m[3][j],
		    sum[3][j], w);
		compare(r->m[AT_ORIGIN][j], r->sum[AT_ORIGIN][j], q[j], s[j],
		    w);
	}
	real_release(mark);
}
