/* Exact arithmetic for the few numbers that a scene is made of. An expansion
 * is an unevaluated sum of doubles that do not overlap, the smallest first
 * (Shewchuk, "Adaptive precision floating-point arithmetic", 1997), times a
 * power of two. Sums and products are exact, so a polynomial of the parameters,
 * its sign and its zeros are; a quotient or a root is rounded once, to
 * double-double, and is within 1.1 u^2 = 1.1 * 2^-106. Nothing overflows; what
 * is 2^-1370 of the largest term of an operation is lost. */
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
ex ex_add(ex a, ex b);
ex ex_sub(ex a, ex b);
ex ex_mul(ex a, ex b);
ex ex_scale(ex a, double b); /* a b */
ex ex_shift(ex a, int e); /* a 2^e */
ex ex_diff(double a, double b); /* a - b */
ex ex_sqrt(ex a); /* three terms, within 2^-150 */

int ex_sign(ex a); /* -1, 0, 1 */
ex ex_first(ex a, int n); /* the n largest terms */

ex ex_quotient(ex a, ex b); /* two terms, within 1.1 u^2; b must not be 0 */

/* Infinite where the result is beyond the range of doubles. */
dd ex_round(ex a); /* within u^2 */
dd ex_div(ex a, ex b); /* the quotient, rounded no further */

#endif
