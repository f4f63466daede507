#include "expansion.h"

/* Operands have their largest term in [2^(TOP-1), 2^TOP): two of them multiply
 * without overflow and leave the most room below. */
enum { TOP = 300 };

/* The same value with terms 2^e times as large. */
static void shift(ex *a, int e)
{
	int n = 0;

	for (int i = 0; i < a->n; i++) {
		double t = ldexp(a->t[i], e);

		if (t != 0)
			a->t[n++] = t;
	}
	a->n = n;
	a->e -= e;
}

static void normalise(ex *a)
{
	int e = TOP;

	if (a->n > 0)
		frexp(a->t[a->n - 1], &e);
	if (e != TOP)
		shift(a, TOP - e);
}

/* Makes each term carry 53 bits again, which bounds their number (Shewchuk,
 * section 2.8). */
static void compress(ex *a)
{
	double kept[EX_TERMS], q = a->t[a->n - 1];
	int bottom = EX_TERMS, n = 0;

	for (int i = a->n - 2; i >= 0; i--) {
		dd s = fast_two_sum(q, a->t[i]);

		q = s.hi;
		if (s.lo != 0) {
			kept[--bottom] = s.hi;
			q = s.lo;
		}
	}
	for (; bottom < EX_TERMS; bottom++) {
		dd s = fast_two_sum(kept[bottom], q);

		q = s.hi;
		if (s.lo != 0)
			a->t[n++] = s.lo;
	}
	a->t[n++] = q;
	a->n = n;
}

/* Grow-expansion with the zeros left out. Where even full terms do not make
 * room, the range promised is exceeded and the smallest is dropped. */
static void grow(ex *a, double b)
{
	int n = 0;

	if (a->n == EX_TERMS)
		compress(a);
	for (int i = a->n == EX_TERMS; i < a->n; i++) {
		dd s = two_sum(b, a->t[i]);

		b = s.hi;
		if (s.lo != 0)
			a->t[n++] = s.lo;
	}
	if (b != 0)
		a->t[n++] = b;
	a->n = n;
}

ex ex_of(double a)
{
	ex r = { .n = a != 0, .t = { a } };

	normalise(&r);
	return r;
}

ex ex_dd(dd a)
{
	return ex_add(ex_of(a.hi), ex_of(a.lo));
}

ex ex_diff(double a, double b)
{
	return ex_sub(ex_of(a), ex_of(b));
}

ex ex_add(ex a, ex b)
{
	if (a.n == 0)
		return b;
	if (b.n == 0)
		return a;
	normalise(&a);
	normalise(&b);
	if (a.e < b.e)
		shift(&a, a.e - b.e);
	else
		shift(&b, b.e - a.e);
	for (int i = 0; i < b.n; i++)
		grow(&a, b.t[i]);
	return a;
}

ex ex_neg(ex a)
{
	for (int i = 0; i < a.n; i++)
		a.t[i] = -a.t[i];
	return a;
}

ex ex_abs(ex a)
{
	return ex_sign(a) < 0 ? ex_neg(a) : a;
}

ex ex_sub(ex a, ex b)
{
	return ex_add(a, ex_neg(b));
}

ex ex_mul(ex a, ex b)
{
	ex r = { 0 };

	normalise(&a);
	normalise(&b);
	for (int i = 0; i < b.n; i++)
		for (int j = 0; j < a.n; j++) {
			dd p = two_prod(a.t[j], b.t[i]);

			grow(&r, p.lo);
			grow(&r, p.hi);
		}
	r.e = a.e + b.e;
	normalise(&r);
	return r;
}

ex ex_scale(ex a, double b)
{
	return ex_mul(a, ex_of(b));
}

ex ex_shift(ex a, int e)
{
	a.e += e;
	return a;
}

int ex_sign(ex a)
{
	return a.n == 0 ? 0 : a.t[a.n - 1] > 0 ? 1 : -1;
}

ex ex_first(ex a, int n)
{
	ex r = { .e = a.e };

	if (a.n > n)
		compress(&a);
	for (int i = a.n > n ? a.n - n : 0; i < a.n; i++)
		r.t[r.n++] = a.t[i];
	return r;
}

/* Compressed, the largest term is within half its last place of the sum, u of
 * it at most, and the rest is rounded once at its own size: u^2 / 2. */
dd ex_round(ex a)
{
	double rest = 0;

	if (a.n == 0)
		return (dd){ 0, 0 };
	normalise(&a);
	compress(&a);
	for (int i = 0; i < a.n - 1; i++)
		rest += a.t[i];
	return dd_shift(fast_two_sum(a.t[a.n - 1], rest), a.e);
}

/* Long division: four digits of 53 bits, each with its exact remainder. */
ex ex_quotient(ex a, ex b)
{
	ex r = ex_of(0);

	normalise(&a);
	normalise(&b);
	int e = a.e - b.e;

	a.e = b.e = 0;
	double by = ex_round(b).hi;

	for (int i = 0; i < 4; i++) {
		ex q = ex_of(ex_round(a).hi / by);

		a = ex_sub(a, ex_mul(b, q));
		r = ex_add(r, q);
	}
	return ex_shift(r, e);
}

dd ex_div(ex a, ex b)
{
	return ex_round(ex_quotient(a, b));
}

/* Newton from the rounded root, each step with its exact residual. */
ex ex_sqrt(ex a)
{
	normalise(&a);
	if (a.e % 2 != 0)
		shift(&a, 1);
	int e = a.e / 2;

	a.e = 0;
	double s = sqrt(ex_round(a).hi);
	ex r = ex_of(s);

	for (int i = 0; i < 3 && s > 0; i++) {
		ex rest = ex_sub(a, ex_mul(r, r));

		r = ex_add(r, ex_of(ex_round(rest).hi / (2 * s)));
	}
	return ex_shift(r, e);
}

ex ex_settled(ex a, ex size)
{
	return ex_sign(ex_sub(ex_abs(a), ex_shift(size, -190))) > 0 ? a :
								      ex_of(0);
}
