/* SPDX-License-Identifier: MIT */
/* Exact arithmetic on integers times powers of two. It computes the maps of a scene,
 * and the few points that the kernels cannot round with certainty. Sums and products
 * are exact, and therefore polynomials in the scene's parameters are, too. Quotients
 * and roots have a relative error of at most EX_ERROR. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "dd.h"

/* A number of a scene or of a point is a multiple of 2^-1074 below 2^499. Determinants
 * of matrices, and images by products of three, are sums of products of four such
 * numbers. These span 4 * 1573 bits and some for carries: 99 words, or 101 if the ends
 * lie within words. A longer sum loses its lowest words, and ex_has_overflowed returns
 * true: scene.c refuses such scenes, and transform.c maps that leave too few words. */
enum { EX_WORDS = 110 };

/* An ex is sign times the sum of word[i] 2^(64 (e + i)) over i < n. word[0] and
 * word[n - 1] are not 0. The number 0 has sign, n and e 0. */
typedef struct {
	int sign, n, e;
	uint64_t word[EX_WORDS];
} ex;

ex ex_of(double a);
ex ex_power(int e); /* 2^e */

/* The bound of the relative error of quotients and roots. These keep EX_QUOTIENT_WORDS
 * words or one more; the highest can be as small as 1. They are exact if five words can
 * hold the exact result. A quotient by 0 is a number beyond the range of doubles. */
#define EX_ERROR 0x1p-703
enum { EX_QUOTIENT_WORDS = 12 };

void ex_truncate(const ex *a, int n, ex *); /* the n highest words of a */

enum { EX_RANGE = 1 << 24 }; /* exponents are between -EX_RANGE and EX_RANGE */

/* Returns the least e with |a| < 2^e, or -EX_RANGE if a is 0. */
static inline int ex_exponent(const ex *a)
{
	return a->n == 0 ? -EX_RANGE :
			   64 * (a->e + a->n) - __builtin_clzll(a->word[a->n - 1]);
}

/* Returns whether, since the last call, a number of any thread exceeded EX_WORDS. */
bool ex_has_overflowed(void);

void ex_set(ex *, double a);

enum { EX_MIN_WORDS = 6 };

/* Computes the sum of the n products a[k] b[k]. Drops words of weight below 2^least,
 * but keeps the EX_MIN_WORDS highest words. */
void ex_dot(int n, const ex *const a[], const ex *const b[], int least, ex *);

/* Computes the highest `count` or `count` + 1 words of a / b. Returns whether they are
 * exact; if not, sets their last bit, so that they round as the exact quotient does. */
bool ex_divide(const ex *a, const ex *b, int count, ex *);

/* Computes `count` words, or one more, of the root of a number > 0. Returns whether
 * they are exact. */
bool ex_sqrt(const ex *, int count, ex *);

/* Returns the double nearest to a number or, if single, the nearest float. Ties go to
 * even, also between subnormal numbers. A number beyond the range becomes infinite. */
double ex_nearest(const ex *, bool single);

/* Returns whether a number lies within 2^-6 units of the last place of the midpoint of
 * two doubles or, if single, floats. If not, an error below 2^-6 such units does not
 * change the double or float nearest to it. */
bool ex_is_near_midpoint(const ex *, bool single);

#define EX_ROUND_BOUND 0.5

/* Returns the double hi nearest to a number a, and the double lo nearest to a - hi. If
 * EX_ROUND_BOUND u^2 |a| (u = 2^-53) is a normal double, it bounds hi + lo's error. */
dd ex_round(const ex *);
