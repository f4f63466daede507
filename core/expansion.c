#include "expansion.h"

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
	return (ex){ .n = a != 0, .t = { a } };
}

ex ex_dd(dd a)
{
	ex r = ex_of(a.lo);

	grow(&r, a.hi);
	return r;
}

ex ex_diff(double a, double b)
{
	return ex_dd(two_sum(a, -b));
}

ex ex_add(ex a, ex b)
{
	for (int i = 0; i < b.n; i++)
		grow(&a, b.t[i]);
	return a;
}

ex ex_scale(ex a, double b)
{
	ex r = { 0 };

	for (int i = 0; i < a.n; i++) {
		dd p = two_prod(a.t[i], b);

		grow(&r, p.lo);
		grow(&r, p.hi);
	}
	return r;
}

ex ex_sub(ex a, ex b)
{
	for (int i = 0; i < b.n; i++)
		grow(&a, -b.t[i]);
	return a;
}

ex ex_mul(ex a, ex b)
{
	ex r = { 0 };

	for (int i = 0; i < b.n; i++)
		r = ex_add(r, ex_scale(a, b.t[i]));
	return r;
}

ex ex_first(ex a, int n)
{
	ex r = { 0 };

	if (a.n > n)
		compress(&a);
	for (int i = a.n > n ? a.n - n : 0; i < a.n; i++)
		r.t[r.n++] = a.t[i];
	return r;
}

/* Compressed, the largest term is within half its last place of the sum, and
 * the rest is rounded once at its own size: u^2. */
dd ex_round(ex a)
{
	double rest = 0;

	if (a.n == 0)
		return (dd){ 0, 0 };
	compress(&a);
	for (int i = 0; i < a.n - 1; i++)
		rest += a.t[i];
	return fast_two_sum(a.t[a.n - 1], rest);
}

/* Long division: three digits of 53 bits, each with its exact remainder. */
dd ex_div(ex a, ex b)
{
	double by = ex_round(b).hi, q[3];

	for (int i = 0; i < 3; i++) {
		q[i] = ex_round(a).hi / by;
		a = ex_sub(a, ex_scale(b, q[i]));
	}
	dd s = fast_two_sum(q[0], q[1]);

	return fast_two_sum(s.hi, s.lo + q[2]);
}

/* Newton from the rounded root, each step with its exact residual. */
ex ex_sqrt(ex a)
{
	double s = sqrt(ex_round(a).hi);
	ex r = ex_of(s);

	for (int i = 0; i < 2 && s > 0; i++)
		grow(&r, ex_round(ex_sub(a, ex_mul(r, r))).hi / (2 * s));
	return r;
}
