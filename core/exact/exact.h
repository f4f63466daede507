/* SPDX-License-Identifier: MIT */
/* Exact arithmetic for the few numbers that a scene is made of, and for the few
 * points that double-double cannot decide: integers times a power of two. Sums
 * and products are exact, so a polynomial of the parameters, its sign and its
 * zeros are; quotients and roots are within EX_ERROR; what is made of them is
 * rounded once.
 *
 * Integers and not sums of doubles that do not overlap, as these need a range of
 * exponents and a rounding mode to be exact in, several times the time, and a
 * proof that their terms are few. */
#ifndef EXACT_H
#define EXACT_H

#include <stdbool.h>
#include <stdint.h>

#include "dd.h"

/* A number of a document, or of a point, is a multiple of 2^-1074 below 2^499. A sum
 * of products of four of them, as the map of three matrices and its image of a point
 * are, or of a matrix's determinant, spans 4 * 1573 bits and few more of carries: 99
 * words, and two where its ends lie within words. Sums of products of more can span
 * more. What has no room is cut off, and ex_has_lost says so: scenes that make such a
 * map are refused (core/scene/scene.c), and maps that leave too little room for points
 * (core/points/transform.c). */
enum { EX_WORDS = 110 };

/* sign times the sum of word[i] 2^(64 (e + i)); neither end is 0. */
typedef struct {
	int sign, n, e;
	uint64_t word[EX_WORDS];
} ex;

ex ex_of(double a);
ex ex_neg(ex a);
ex ex_add(ex a, ex b);
ex ex_sub(ex a, ex b);
ex ex_mul(ex a, ex b);
ex ex_shift(ex a, int e); /* a 2^e */

/* Relative. What has five words or less is exact. A quotient by 0 is beyond the
 * range of doubles. The first of its words can be as small as 1. */
#define EX_ERROR 0x1p-703
enum { EX_QUOTIENT = 12 };

ex ex_quotient(ex a, ex b);
ex ex_sqrt(ex a);

int ex_compare(ex a, ex b); /* the sign of a - b */
ex ex_first(ex a, int n);   /* the n first words, toward 0 */

/* Whether a number had no room since the last call, in any thread. */
bool ex_has_lost(void);

/* So many words are left in any case of a number whose words below 2^(64 least) are
 * not wanted. */
enum { EX_KEPT = 7 };

/* The nearest double or float, ties to even, also among the subnormal ones;
 * infinite beyond. */
double ex_double(ex a);

/* The word that has the bit 2^e. */
int ex_word_of(int e);

/* What every point needs, without copies: a double; a sum of products, without the
 * words below 2^(64 least); a quotient of so many words or one more, whose
 * last bit is 1 where something remains, so that it is rounded as the exact one (it
 * says whether none does); the nearest double or float. */
void ex_set(ex *, double a);
void ex_dot(int n, const ex *const a[], const ex *const b[], int least, ex *);
bool ex_divide(const ex *a, const ex *b, int words, ex *);
double ex_nearest(const ex *, bool single);

/* The nearest double, and the double nearest to what that leaves: within
 * EX_BOUND u^2 while that is no less than 2^-1022. */
#define EX_BOUND 0.5

dd ex_round(ex a);

#endif
