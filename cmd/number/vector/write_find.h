/* SPDX-License-Identifier: MIT */
/* The decimal digits of a number, found by operations on doubles (write_body.h
 * says which). From 2^-17 to 2^52, of floats to 2^23, none of them rounds; beyond
 * that, what rounding could change is left to number_write. */
#ifndef WRITE_FIND_H
#define WRITE_FIND_H

#include <math.h>

#include "powers.h"
#include "vector.h"

#define INLINE static inline __attribute__((always_inline))

/* How far apart two sides must be for their comparison to be right where something
 * was rounded: shortest() adds up the errors. */
#define WRITE_MARGIN 0x1p-44

/* The most digits that a whole number below 2^53 has. */
enum { DIGITS = 16 };

/* The most decimals or significant digits that are found here, and the most zeros
 * that may follow them before the point. */
enum { MOST_DIGITS = 15, MOST_ZEROS = 6 };

/* What is written of a number: the DIGITS digits of whole, a 17th, digit, unless
 * that is 0; the point is scale digits before the end of whole. sign is -1 for a
 * minus, 1 for none, 0 for what is not made. */
struct found {
	double whole[TEXTS];
	int32_t digit[TEXTS], scale[TEXTS], sign[TEXTS];
};

/* x = a 10^scale as p + e, and the greatest integer i <= p. hi + lo is the power;
 * where scale >= 0 it is hi, of 47 bits at most (5^20 < 2^47), so that e, what
 * the product's rounding to p has lost, is exact, and x = p + e. */
struct scaled {
	V p, e, i;
};

INLINE struct scaled scaled(V a, V hi, V lo, bool whole_powers)
{
	struct scaled x = { .p = a * hi };

	x.e = FMA(a, hi, -x.p);
	if (!whole_powers)
		x.e = FMA(a, lo, x.e);
	x.i = FLOOR(x.p);
	return x;
}

/* Returns the nearest whole number to x < 2^53, ties to even, where scale >= 0. |e| is
 * at most half a unit of p's last place. Where p < 1/4, p - 1/2, though rounded, is
 * -1/4 at most, far more than e: i, which is 0, is right. From 1/4 up, p - i - 1/2 is
 * exact. The sum *rest, though rounded, has the sign of x - i - 1/2. It is 0 if e = 0
 * and NEAREST breaks the tie. The other tie is p > 2^52, whole, with |e| = 1/2: then p
 * is even already, as x, halfway between two doubles, was rounded to it; and p is what
 * either way gives. */
INLINE V nearest(struct scaled x, V *rest)
{
	*rest = (x.p - x.i - ALL(0.5)) + x.e;
	V i = x.i + ONLY(LESS(ALL(0), *rest), ALL(1));

	return SELECT(EQUAL(*rest, ALL(0)), NEAREST(x.p), i);
}

struct digits {
	V whole, digit;
	M sure;
};

/* The shortest digits that read back as a, and of these the nearest; after
 * Schubfach (R. Giulietti, 2020). Let 2^q be a's last place and 10^-scale the least
 * power of ten above it. Then x = a 10^scale < 2^53, and up, half a unit of that
 * place, is at least 1/20 and less than 1/2. What reads back as a is from x - down
 * to x + up, where down is up, but half of that below a power of two.
 *
 * So one whole number at most is there, and if one is, it is the shortest: any
 * with fewer digits is whole, too, and its zeros are dropped later. Else all there
 * have a 17th digit, and the nearest tenth, no farther than 1/20, is there: only
 * next to a power of two need it not be, and number_write goes on.
 *
 * For scale >= 0 nothing is rounded. x is a multiple of 2^(q + scale), up
 * is half of that multiplied by 5^scale, an odd number, so that no whole number is
 * at x + up or x - down. With q + scale >= -49 (digits_test.t counts) all
 * differences are below 1 and multiples of 2^-51, the tenths below 10 and multiples
 * of 2^-48: they are doubles. A tie of two tenths is 1/4 or 3/4, which NEAREST and
 * number_write take to the even one.
 *
 * Else, in units of 2^-53, the errors are at most, with lo from the table:
 *
 *	1	of hi + lo: POWER_ERROR x
 *	1	of e, less than 2, rounded
 *	2	of p - i + e, less than 4, rounded
 *	1	of its fraction
 *	5	in all, of rest; with 1 more of 1 - rest, and of up 1/2 or less
 *	58	of 10 rest, less than 10: 5 10 and 8
 *
 * so that a comparison is right where its sides are WRITE_MARGIN = 512 units apart.
 * What is nearer, exact ties among it, which are frequent in numbers that large, is
 * left to number_write. */
INLINE struct digits shortest(V a, V two, V scale, V hi, struct scaled x,
    bool single, bool whole_powers)
{
	const V one = ALL(1);
	M exact = LESS(ALL(-0.5), scale);
	M power_of_two = EQUAL(a, two);
	V rest = (x.p - x.i) + x.e, j = FLOOR(rest);
	V up = hi * two * ALL(single ? 0x1p-24 : 0x1p-53);
	V down = up - ONLY(power_of_two, up * ALL(0.5));

	rest = rest - j;
	V to_next = one - rest, tenths = rest * ALL(10);
	V digit = NEAREST(tenths);
	M below = LESS(rest, down), above = LESS(to_next, up);
	M there = below | above;
	V ends = MIN(ABS(rest - down), ABS(to_next - up));
	V margin = MIN(ends, ALL(0.5) - ABS(tenths - digit));
	M sure = there | ~power_of_two;

	if (!whole_powers)
		sure = sure & (exact | LESS(ALL(WRITE_MARGIN), margin));
	return (struct digits){
		.whole = x.i + j + ONLY(above, one),
		.digit = ONLY(~there, digit),
		.sure = sure,
	};
}

/* The exponent of a power of two, less place: in the lowest bits of 2^52. */
INLINE V log2_less(V two, double place)
{
	V biased = (V)(SHR((I)(two), 52) | (I)(ALL(0x1p52)));

	return biased - ALL(0x1p52 + 1023 + place);
}

INLINE V power_of_two_in(V a)
{
	return (V)((I)(a) & (I)(ALL((double)INFINITY)));
}

INLINE void store_found(struct found *f, size_t i, V v, struct digits d,
    V scale)
{
	M minus = LESS(v, ALL(0)) & ~EQUAL(d.whole, ALL(0));

	STORE(f->whole + i, d.whole);
	STORE_INTS(f->digit + i, d.digit);
	STORE_INTS(f->scale + i, scale);
	STORE_INTS(f->sign + i, ONLY(d.sure, SELECT(minus, ALL(-1), ALL(1))));
}

INLINE void find_decimals(struct found *f, size_t i, int n, V v)
{
	V scale = ALL(n), hi, lo, rest;

	power_of_ten(scale, &hi, &lo);
	struct scaled x = scaled(ABS(v), hi, lo, true);
	struct digits d = { nearest(x, &rest), ALL(0), LESS(x.p, ALL(0x1p53)) };

	store_found(f, i, v, d, scale);
}

/* Finds n <= MOST_DIGITS significant digits of numbers from 1e-6 to below 1e15.
 * 78913 / 2^18 times floor(log2 a) gives floor(log10 a), or one less where a is at
 * least the next power of ten. That power is rounded where it is below 1; a number
 * equal to it, taken for either side, gives the same text, as its n digits round to a
 * one and zeros. Where scale < 0 the product is rounded, by less than WRITE_MARGIN
 * (see shortest), and what lies nearer to a tie is left to number_write. */
INLINE void find_significant(struct found *f, size_t i, int n, V v)
{
	const V zero = ALL(0), one = ALL(1);
	V a = ABS(v), hi, lo, rest;
	M in_range = LESS(a, ALL(1e15)) & ~LESS(a, ALL(1e-6));
	V two = power_of_two_in(SELECT(in_range, a, one));
	V log10 = FLOOR(log2_less(two, 0) * ALL(78913 * 0x1p-18));

	power_of_ten(log10 + one, &hi, &lo);
	log10 = log10 + ONLY(~(LESS(a, hi) | ~in_range), one);
	V scale = ALL(n - 1) - log10;
	M exact = LESS(ALL(-0.5), scale);
	M in_table = LESS(ALL(-MOST_ZEROS - 0.5), scale);

	scale = ONLY(in_table, scale);
	power_of_ten(scale, &hi, &lo);
	struct scaled x = scaled(a, hi, lo, false);
	struct digits d = { nearest(x, &rest), zero,
		(in_range & in_table) | EQUAL(a, zero) };

	d.sure = d.sure & (exact | LESS(ALL(WRITE_MARGIN), ABS(rest)));
	store_found(f, i, v, d, scale);
}

/* Finds the shortest digits. Plain text goes from 1e-6 to 1e21; here it is from
 * 2^-17, and of floats to 2^60, as far as the table goes; for a number out of this
 * range two is 1, so that the table is not left. usual says that all are in it and
 * have scale >= 0: then nothing is rounded, and much need not be asked. */
INLINE void find_in_range(struct found *f, size_t i, bool single, bool usual,
    V v)
{
	const V one = ALL(1);
	V a = ABS(v), hi, lo;
	M in_range = LESS(a, ALL(single ? 0x1p60 : 1e21)) &
	    ~LESS(a, ALL(0x1p-17));
	V two = power_of_two_in(usual ? a : SELECT(in_range, a, one));
	V q = log2_less(two, single ? 23 : 52);
	V scale = -one - FLOOR(q * ALL(0.30102999566398120));

	power_of_ten(scale, &hi, &lo);
	struct scaled x = scaled(a, hi, lo, usual);
	struct digits d = shortest(a, two, scale, hi, x, single, usual);

	if (!usual)
		d.sure = d.sure & (in_range | EQUAL(a, ALL(0)));
	if (single) { /* eight digits and the ninth */
		d.whole = FMA(d.whole, ALL(1e8), d.digit * ALL(1e7));
		d.digit = ALL(0);
	}
	store_found(f, i, v, d, scale);
}

/* A loop for what is usual, which every lane must be. */
INLINE void find_shortest(struct found *f, size_t i, bool single, V v)
{
	V a = ABS(v);
	M usual = LESS(a, ALL(single ? 0x1p23 : 0x1p52)) &
	    ~LESS(a, ALL(0x1p-17));

	if (LANES_OF(usual) == (1u << WIDTH) - 1)
		find_in_range(f, i, single, true, v);
	else
		find_in_range(f, i, single, false, v);
}

#endif
