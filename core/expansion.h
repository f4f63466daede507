/* Exact arithmetic for the few numbers that a scene is made of. An expansion
 * is an unevaluated sum of doubles that do not overlap, the smallest first
 * (Shewchuk, "Adaptive precision floating-point arithmetic", 1997), times a
 * power of two. Sums and products are exact, so a polynomial of the parameters,
 * its sign and its zeros are; quotients and roots keep four terms, and what is
 * made of them is rounded once, to double-double: u^2 = 2^-106. Nothing
 * overflows; what is 2^-1370 of the largest term of an operation is lost. */
#ifndef EXPANSION_H
#define EXPANSION_H

#include "dd.h"

/* 32 terms of 53 bits reach from 2^600 below 2^-1074. */
enum { EX_TERMS = 40 };

typedef struct {
	int n; /* 0: zero */
	int e;
	double t[EX_TERMS]; /* times 2^e */
} ex;

ex ex_of(double a);
ex ex_dd(dd a);
ex ex_neg(ex a);
ex ex_abs(ex a);
ex ex_add(ex a, ex b);
ex ex_sub(ex a, ex b);
ex ex_mul(ex a, ex b);
ex ex_scale(ex a, double b);    /* a b */
ex ex_shift(ex a, int e);       /* a 2^e */
ex ex_diff(double a, double b); /* a - b */

/* Within 2^-200: four terms. b must not be 0. */
ex ex_quotient(ex a, ex b);
ex ex_sqrt(ex a);

/* a; or 0 where it may be nothing but errors, for a sum of terms each within
 * 2^-195 of itself, whose magnitudes sum to size. */
ex ex_settled(ex a, ex size);

int ex_sign(ex a);        /* -1, 0, 1 */
ex ex_first(ex a, int n); /* the n largest terms */

/* Within EX_BOUND u^2; infinite where beyond the range of doubles. */
#define EX_BOUND 0.51

dd ex_round(ex a);
dd ex_div(ex a, ex b);

#endif
