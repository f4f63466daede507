/* SPDX-License-Identifier: MIT */
#include "truth.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "sample.h"

struct truth_stage *truth_stage(struct truth *t)
{
	struct truth_stage *s = &t->stage[t->n++];

	set_identity(s->m);
	memset(s->size, 0, sizeof s->size);
	return s;
}

static real size_of(const struct truth_stage *s, int i, int j)
{
	return s->size[i][j] != NULL ? s->size[i][j] : magnitude(s->m[i][j]);
}

static void append_stage(struct truth_stage *r, const struct truth_stage *s)
{
	struct truth_stage product;

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++) {
			real v = real_of(0), size = real_of(0);

			for (int k = 0; k < 4; k++) {
				v = add(v, mul(r->m[i][k], s->m[k][j]));
				size = add(size, mul(r->size[i][k], size_of(s, k, j)));
			}
			product.m[i][j] = v;
			product.size[i][j] = size;
		}
	*r = product;
}

void truth_compose(struct truth *t)
{
	set_identity(t->product.m);
	set_identity(t->product.size);
	for (int i = 0; i < t->n; i++)
		append_stage(&t->product, &t->stage[i]);
}

struct sized sized_of(double a)
{
	return (struct sized){ real_of(a), magnitude(real_of(a)) };
}

struct sized sized_add(struct sized a, struct sized b)
{
	return (struct sized){ add(a.value, b.value), add(a.size, b.size) };
}

struct sized sized_sub(struct sized a, struct sized b)
{
	return (struct sized){ sub(a.value, b.value), add(a.size, b.size) };
}

struct sized sized_mul(struct sized a, struct sized b)
{
	return (struct sized){ mul(a.value, b.value), mul(a.size, b.size) };
}

struct sized sized_dot(const struct sized a[3], const struct sized b[3])
{
	struct sized s = sized_of(0);

	for (int i = 0; i < 3; i++)
		s = sized_add(s, sized_mul(a[i], b[i]));
	return s;
}

struct sized sized_length(const struct sized v[3])
{
	real r = root(sized_dot(v, v).value);

	return (struct sized){ r, add(add(r, v[0].size), add(v[1].size, v[2].size)) };
}

struct sized truth_column(const struct truth *t, int j, const double p[4])
{
	struct sized s = sized_of(0);

	for (int i = 0; i < 4; i++)
		if (p[i] != 0)
			s = sized_add(s,
			    sized_mul(sized_of(p[i]), truth_element(t, i, j)));
	return s;
}

struct sized truth_element(const struct truth *t, int i, int j)
{
	return (struct sized){ t->product.m[i][j], t->product.size[i][j] };
}

/* Returns a bound of the error of a number with this size, which is more than the bound
 * that struct sum keeps. */
static real tolerance(real size)
{
	return mul(size, real_of(TRUTH_TOLERANCE));
}

int truth_sign(struct sized a, bool *doubtful)
{
	if (doubtful != NULL)
		*doubtful = mpfr_cmpabs(a.value, tolerance(a.size)) <= 0;
	return is_zero(a.value, a.size) ? 0 : mpfr_sgn(a.value);
}

static double rounded(real a, bool single)
{
	return single ? (double)mpfr_get_flt(a, MPFR_RNDN) : mpfr_get_d(a, MPFR_RNDN);
}

static bool is_even(double a, bool single)
{
	float narrow = (float)a;
	uint64_t bits;
	uint32_t narrow_bits;

	memcpy(&bits, &a, sizeof bits);
	memcpy(&narrow_bits, &narrow, sizeof narrow_bits);
	return ((single ? narrow_bits : bits) & 1) == 0;
}

/* Returns the double, or float, nearest to a. If a is within this distance of the
 * midpoint of two, returns the even one. */
static double nearest(real a, real within, bool single)
{
	double low = rounded(sub(a, within), single);
	double high = rounded(add(a, within), single);

	return is_even(low, single) ? low : high;
}

static enum verdict judge(double printed, struct sized n, struct sized d, bool single)
{
	if (truth_sign(n, NULL) == 0)
		return printed == 0 ? NEAREST : WRONG;
	real v = divide(n.value, d.value), within = magnitude(divide(n.size, n.value));

	within = add(within, magnitude(divide(d.size, d.value)));
	within = mul(within, magnitude(v));
	real least = mul(within, real_of(0x1p-1000));
	double best = nearest(v, mul(least, real_of(0x1p-900)), single);

	if (printed == best || (isnan(printed) && isinf(best)))
		return NEAREST;
	real none = tolerance(within);

	return printed >= rounded(sub(v, none), single) &&
		printed <= rounded(add(v, none), single) ?
	    WITHIN_TOLERANCE :
	    WRONG;
}

enum verdict truth_verdict(double printed, struct sized n, struct sized d, bool single)
{
	int mark = real_mark();
	enum verdict r = judge(printed, n, d, single);

	real_release(mark);
	return r;
}

double element(const struct map *m, int i, int j)
{
	return map_element_nearest(m, i, j, false);
}

/* Keeps the value a of element i j if it is the largest so far. */
static void keep_largest(struct largest *l, double a, const struct map *m, int i, int j)
{
	if (a <= l->value)
		return;
	l->value = a;
	snprintf(l->where, sizeof l->where, "%s; element %d %d is %.17g", sample_name(),
	    i, j, map_element_nearest(m, i, j, false));
}

static void compare_element(const struct map *m, int i, int j, const struct truth *t,
    struct worst *w)
{
	struct sized exact = truth_element(t, i, j), one = sized_of(1);
	struct sum got = map_element(m, i, j);
	dd pair = sum_dd(got);
	real bound = real_of(!sum_is_exact(&got));
	real off = magnitude(sub(real_of_ex(got.value), exact.value));

	for (int single = 0; single < 2; single++) {
		enum verdict v = truth_verdict(map_element_nearest(m, i, j, single),
		    exact, one, single);

		w->verdicts[v == WITHIN_TOLERANCE && !t->irrational ? WRONG : v]++;
	}
	if (truth_sign(exact, NULL) == 0)
		w->false_nonzeros += sum_sign(got) != 0;
	mpfr_mul_2si(bound, bound, got.error - EX_RANGE, MPFR_RNDN);
	if (truth_sign(exact, NULL) != 0 &&
	    truth_verdict(pair.hi, exact, one, false) == NEAREST) {
		double size = mpfr_get_d(magnitude(exact.value), MPFR_RNDN);

		keep_largest(&w->pair_error,
		    u2_error(pair, exact.value, size) -
			0x1p106 * mpfr_get_d(bound, MPFR_RNDN) / size,
		    m, i, j);
	}
	/* The truth has rounding errors, too: its sine of 180 degrees and its
	 * difference of equal roots are not 0. */
	real rounding = real_of(1);

	mpfr_mul_2si(rounding, rounding, 100 - REAL_BITS, MPFR_RNDN);
	off = sub(off, add(rounding, mul(exact.size, real_of(0x1p-1000))));
	if (!t->irrational || !mpfr_zero_p(bound))
		w->beyond_error += mpfr_cmp(off, bound) > 0;
	keep_largest(&w->fault,
	    w->verdicts[WRONG] + w->beyond_error + w->false_nonzeros > 0, m, i, j);
	if (!mpfr_zero_p(bound))
		keep_largest(&w->sum_bound,
		    mpfr_get_d(divide(bound, tolerance(exact.size)), MPFR_RNDU), m, i,
		    j);
}

void truth_compare(const struct truth *t, const struct map *r, struct worst *w)
{
	int mark = real_mark();

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			compare_element(r, i, j, t, w);
	real_release(mark);
}
