/* SPDX-License-Identifier: MIT */
/* Exact arithmetic on integers times a power of two. It computes the maps of a scene,
 * and the few points that double-double cannot round with certainty. Sums and products
 * are exact. A polynomial of the parameters is therefore exact, as are its sign and
 * its zeros. Quotients and roots are within EX_ERROR.
 *
 * The other representation, a sum of doubles that do not overlap, would need a wider
 * range of exponents, a fixed rounding mode, several times the time, and a proof that
 * its terms are few. */
#ifndef EXACT_H
#define EXACT_H

#include <stdbool.h>
#include <stdint.h>

#include "dd.h"

/* A number of a document or of a point is a multiple of 2^-1074 below 2^499. A sum of
 * products of four such numbers spans 4 * 1573 bits, and a few bits more for carries:
 * 99 words, and two more if its ends lie within words. Such sums are the determinant of
 * a matrix, and the image of a point by a product of three matrices. Sums of longer
 * products can span more: their lowest words are cut off, and ex_has_overflowed returns
 * true. Scenes with such a map are refused (core/scene/scene.c), and so are maps that
 * leave too few words for points (core/points/transform.c). */
enum { EX_WORDS = 110 };

/* sign times the sum of word[i] 2^(64 (e + i)) over the n words; the first and the last
 * word are not 0. The number 0 has sign, n and e 0. */
typedef struct {
	int sign, n, e;
	uint64_t word[EX_WORDS];
} ex;

ex ex_of(double a);
ex ex_power(int e); /* 2^e */

/* The bound of the relative error of quotients and roots. A quotient keeps EX_QUOTIENT
 * words, of which the highest can be as small as 1. A result of five words or fewer is
 * exact. A quotient by 0 is beyond the range of doubles. */
#define EX_ERROR 0x1p-703
enum { EX_QUOTIENT = 12 };

ex ex_sqrt(ex a);
ex ex_truncate(ex a, int n); /* the n highest words */

/* Returns the least e with |a| < 2^e, or -EX_RANGE, below all others, if a is 0. */
enum { EX_RANGE = 1 << 24 };

static inline int ex_size(const ex *a)
{
	return a->n == 0 ?
	    -EX_RANGE :
	    64 * (a->e + a->n) - __builtin_clzll(a->word[a->n - 1]);
}

/* Returns whether, since the last call, a number in any thread has had more than
 * EX_WORDS words. */
bool ex_has_overflowed(void);

/* The functions below take pointers because they are called for each point. */
void ex_set(ex *, double a);

/* Computes the sum of n products a[k] b[k]. Drops words below 2^least, but keeps
 * at least EX_MIN_WORDS words. */
enum { EX_MIN_WORDS = 7 };

void ex_dot(int n, const ex *const a[], const ex *const b[], int least, ex *);

/* Computes a / b. The quotient has words or words + 1 words. Returns whether it is
 * exact; if not, its last bit is set, so that it rounds as the exact quotient does. */
bool ex_divide(const ex *a, const ex *b, int words, ex *);

/* Returns the nearest double or, if single, the nearest float. Ties go to even, also of
 * subnormal numbers. A number beyond the range gives infinity, 0 gives +0. */
double ex_nearest(const ex *, bool single);

/* Returns the nearest double and the double nearest to the remainder. The error of
 * their sum is at most EX_BOUND u^2 |a|, u = 2^-53, if that is at least 2^-1022. */
#define EX_BOUND 0.5

dd ex_round(const ex *);

#endif
