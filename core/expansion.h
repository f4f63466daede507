/* Exact arithmetic for the few numbers that a scene is made of. An expansion
 * is an unevaluated sum of doubles that do not overlap, the smallest first
 * (Shewchuk, "Adaptive precision floating-point arithmetic", 1997). Sums and
 * products are exact, so a polynomial of the parameters, its sign and its
 * zeros are; a quotient or a root is rounded once, to double-double, and is
 * within 1.1 u^2 = 1.1 * 2^-106. Callers scale by powers of two so that the
 * largest term of a result lies below 2^500; what falls below 2^-1074 then,
 * is lost. */
#ifndef EXPANSION_H
#define EXPANSION_H

#include "dd.h"

/* 32 terms of 53 bits reach from 2^500 below 2^-1074. */
enum { EX_TERMS = 40 };

typedef struct {
	int n;
	double t[EX_TERMS];
} ex;

ex ex_of(double a);
ex ex_dd(dd a);
ex ex_add(ex a, ex b);
ex ex_sub(ex a, ex b);
ex ex_mul(ex a, ex b);
ex ex_scale(ex a, double b); /* a b */
ex ex_diff(double a, double b); /* a - b */
ex ex_sqrt(ex a); /* three terms, within 2^-150 */

ex ex_first(ex a, int n); /* the n largest terms */
dd ex_round(ex a); /* within u^2 */
dd ex_div(ex a, ex b); /* within 1.1 u^2; b must not be 0 */

#endif
