/* SPDX-License-Identifier: MIT */
/* Finds the decimal digits of numbers by the operations on doubles that write_body.h
 * lists. The shortest digits of numbers from 2^-17 to 2^52 (floats: to 2^23) are found
 * without rounding. If rounding could change the digits of a number, number_write makes
 * its text. */
#ifndef WRITE_FIND_H
#define WRITE_FIND_H

#include <math.h>

#include "loops.h"
#include "powers.h"

#define INLINE static inline __attribute__((always_inline))

/* A comparison is right in spite of roundings if its sides differ by more than
 * WRITE_MARGIN; the comment on shortest_digits() adds up the errors. */
#define WRITE_MARGIN 0x1p-44

/* The most digits that a whole number below 2^53 has. */
enum { WHOLE_DIGITS = 16 };

/* A style may ask these loops for at most MOST_DIGITS decimals or significant digits.
 * They write at most MOST_ZEROS zeros between digits and the point. */
enum { MOST_DIGITS = 15, MOST_ZEROS = 6 };

/* The digits of a batch of numbers. whole has WHOLE_DIGITS digits; the point stands
 * `scale` digits before their end. digit is the 17th, which is not written if it is 0.
 * sign is
 * -1 for a minus, 1 for no minus, and 0 if number_write has to make the text. */
struct batch_digits {
	double whole[NUMBER_BATCH];
	int32_t digit[NUMBER_BATCH], scale[NUMBER_BATCH], sign[NUMBER_BATCH];
};

/* The product x = a 10^scale as p + e, and i, the greatest integer up to p. hi + lo is
 * 10^scale. If scale >= 0, hi is 10^scale, of 47 bits at most (5^20 < 2^47). Then e,
 * the error of the rounding to p, is exact, and x = p + e. */
struct product {
	V p, e, i;
};

INLINE struct product multiply_exactly(V a, V hi, V lo, bool whole_powers)
{
	struct product x = { .p = a * hi };

	x.e = FMA(a, hi, -x.p);
	if (!whole_powers)
		x.e = FMA(a, lo, x.e);
	x.i = FLOOR(x.p);
	return x;
}

/* Returns the nearest whole number to x < 2^53, ties to even, if scale >= 0, where x is
 * p + e. Sets *rest to x - i - 1/2, rounded, with the sign of the exact value:
 * - |e| is at most half a unit of p's last place.
 * - If p < 1/4, i is 0 and p - 1/2 is at most -1/4: e can't change its sign.
 * - If p >= 1/4, p - i - 1/2 is exact, so that only the sum with e is rounded.
 * In a tie with e = 0, *rest is 0, and NEAREST(p) breaks the tie. In any other tie |e|
 * is 1/2, and p > 2^52 is whole: x is halfway between two doubles and was rounded to
 * the even one, p. Both branches return this p, as *rest is 0 or -1. */
INLINE V round_ties_even(struct product x, V *rest)
{
	*rest = (x.p - x.i - ALL(0.5)) + x.e;
	V i = x.i + ONLY(LESS(ALL(0), *rest), ALL(1));

	return SELECT(EQUAL(*rest, ALL(0)), NEAREST(x.p), i);
}

/* The digits of a vector of numbers, as in struct batch_digits. If sure is false,
 * number_write has to make the text. */
struct digits {
	V whole, digit;
	M sure;
};

/* Returns the shortest digits that read back as a, and of these the nearest; after
 * Schubfach (R. Giulietti, 2020). top is the greatest power of two that is at most a.
 * Let 2^q be a's last place, and 10^-scale the least power of ten above 2^q. Then x =
 * a 10^scale < 2^53, and up = 2^q/2 10^scale is at least 1/20 and less than 1/2. The
 * numbers that read back as a are, times 10^scale, those from x - down to x + up, where
 * down is up, or half of up if a is a power of two.
 *
 * This interval contains at most one whole number, which is the shortest: a number with
 * fewer digits is whole, too, and its zeros at the end are dropped later. If there is
 * no whole number, the result is the multiple of 1/10 nearest to x, which is in the
 * interval as it is no farther than 1/20 from x. But if a is a power of two, the
 * multiple may be outside, and number_write makes the text.
 *
 * If scale >= 0, nothing is rounded. x is a multiple of 2^(q + scale), and up is half
 * of 2^(q + scale) times the odd number 5^scale, so that no whole number is at x + up
 * or x - down. As q + scale >= -49 (digits_test.t counts), all differences are
 * multiples of 2^-51 below 1, and tenths is a multiple of 2^-48 below 10: all are
 * doubles. If two digits are equally near, at 1/4 or 3/4, NEAREST takes the even one.
 *
 * If scale < 0, the errors are at most, in units of 2^-53:
 *
 *	1	of hi + lo (powers.h) times a: POWER_ERROR x
 *	1	of e, less than 2, rounded
 *	2	of p - i + e, less than 4, rounded
 *	1	of rest, the fraction of this sum, rounded
 *	5	of rest in all; to_next has 1 more, and up has 1/2
 *	58	of tenths, less than 10: 10 times 5, and 8 as it is rounded
 *
 * so that a comparison is right if its sides differ by WRITE_MARGIN, 512 units. If
 * they differ by less, number_write makes the text: for example in exact ties, which
 * are frequent if scale < 0. */
INLINE struct digits shortest_digits(V a, V top, V scale, V hi,
    struct product x, bool single, bool whole_powers)
{
	const V one = ALL(1);
	M exact = LESS(ALL(-0.5), scale);
	M power_of_two = EQUAL(a, top);
	V rest = (x.p - x.i) + x.e, j = FLOOR(rest);
	V up = hi * top * ALL(single ? 0x1p-24 : 0x1p-53);
	V down = up - ONLY(power_of_two, up * ALL(0.5));

	rest = rest - j;
	V to_next = one - rest, tenths = rest * ALL(10);
	V digit = NEAREST(tenths);
	M below = LESS(rest, down), above = LESS(to_next, up);
	M has_whole = below | above;
	V ends = MIN(ABS(rest - down), ABS(to_next - up));
	V margin = MIN(ends, ALL(0.5) - ABS(tenths - digit));
	M sure = has_whole | ~power_of_two;

	if (!whole_powers)
		sure = sure & (exact | LESS(ALL(WRITE_MARGIN), margin));
	return (struct digits){
		.whole = x.i + j + ONLY(above, one),
		.digit = ONLY(~has_whole, digit),
		.sure = sure,
	};
}

/* Returns log2 of a power of two, minus `place`. The shift moves its biased exponent to
 * the lowest bits of the double 2^52. */
INLINE V log2_of_power(V power, double place)
{
	V biased = (V)(SHR((I)(power), 52) | (I)(ALL(0x1p52)));

	return biased - ALL(0x1p52 + 1023 + place);
}

INLINE V power_of_two_up_to(V a)
{
	return (V)((I)(a) & (I)(ALL((double)INFINITY)));
}

INLINE void store_lanes(struct batch_digits *f, size_t i, V v, struct digits d,
    V scale)
{
	M minus = LESS(v, ALL(0)) & ~EQUAL(d.whole, ALL(0));

	STORE(f->whole + i, d.whole);
	STORE_INTS(f->digit + i, d.digit);
	STORE_INTS(f->scale + i, scale);
	STORE_INTS(f->sign + i, ONLY(d.sure, SELECT(minus, ALL(-1), ALL(1))));
}

INLINE void find_decimals(struct batch_digits *f, size_t i, int n, V v)
{
	V scale = ALL(n), hi, lo, rest;

	power_of_ten(scale, &hi, &lo);
	struct product x = multiply_exactly(ABS(v), hi, lo, true);
	struct digits d = { round_ties_even(x, &rest), ALL(0),
		LESS(x.p, ALL(0x1p53)) };

	store_lanes(f, i, v, d, scale);
}

/* Finds n <= MOST_DIGITS significant digits of numbers from 1e-6 to below 1e15.
 * FLOOR(78913 / 2^18 floor(log2 a)) is floor(log10 a) or one less; a comparison of a
 * with the next power of ten corrects this. A power below 1 is rounded, but a number
 * equal to this double gives the same text with either log10: its n digits round to a
 * one and zeros. If scale < 0, the product is rounded, by less than WRITE_MARGIN (see
 * shortest); number_write makes the text if x is no farther than this from a tie. */
INLINE void find_significant(struct batch_digits *f, size_t i, int n, V v)
{
	const V zero = ALL(0), one = ALL(1);
	V a = ABS(v), hi, lo, rest;
	M in_range = LESS(a, ALL(1e15)) & ~LESS(a, ALL(1e-6));
	V top = power_of_two_up_to(SELECT(in_range, a, one));
	V log10 = FLOOR(log2_of_power(top, 0) * ALL(78913 * 0x1p-18));

	power_of_ten(log10 + one, &hi, &lo);
	log10 = log10 + ONLY(~(LESS(a, hi) | ~in_range), one);
	V scale = ALL(n - 1) - log10;
	M exact = LESS(ALL(-0.5), scale);
	M in_table = LESS(ALL(-MOST_ZEROS - 0.5), scale);

	scale = ONLY(in_table, scale);
	power_of_ten(scale, &hi, &lo);
	struct product x = multiply_exactly(a, hi, lo, false);
	struct digits d = { round_ties_even(x, &rest), zero,
		(in_range & in_table) | EQUAL(a, zero) };

	d.sure = d.sure & (exact | LESS(ALL(WRITE_MARGIN), ABS(rest)));
	store_lanes(f, i, v, d, scale);
}

/* Finds the shortest digits of 0 and of numbers from 2^-17 to 1e21 (floats: to 2^60).
 * Doubles below 2^-17 have a scale above POWER_MAX; floats get the same limit. Floats
 * from 2^60 on have a scale below POWER_MIN. From 1e21 on texts have an exponent.
 * Numbers outside these limits are computed as if they were 1, so that their scale is
 * in the table; number_write makes their texts. find_shortest sets exact only if no
 * number is outside and no scale is negative. */
INLINE void find_in_range(struct batch_digits *f, size_t i, bool single,
    bool exact, V v)
{
	const V one = ALL(1);
	V a = ABS(v), hi, lo;
	M in_range = LESS(a, ALL(single ? 0x1p60 : 1e21)) &
	    ~LESS(a, ALL(0x1p-17));
	V top = power_of_two_up_to(exact ? a : SELECT(in_range, a, one));
	V q = log2_of_power(top, single ? 23 : 52);
	V scale = -one - FLOOR(q * ALL(0.30102999566398120));

	power_of_ten(scale, &hi, &lo);
	struct product x = multiply_exactly(a, hi, lo, exact);
	struct digits d = shortest_digits(a, top, scale, hi, x, single, exact);

	if (!exact)
		d.sure = d.sure & (in_range | EQUAL(a, ALL(0)));
	if (single) { /* whole has eight digits, and digit is the ninth */
		d.whole = FMA(d.whole, ALL(1e8), d.digit * ALL(1e7));
		d.digit = ALL(0);
	}
	store_lanes(f, i, v, d, scale);
}

/* Finds the shortest digits. If all numbers of v are from 2^-17 to 2^52 (floats: to
 * 2^23), no operation rounds, and find_in_range is shorter with exact = true. */
INLINE void find_shortest(struct batch_digits *f, size_t i, bool single, V v)
{
	V a = ABS(v);
	M exact = LESS(a, ALL(single ? 0x1p23 : 0x1p52)) &
	    ~LESS(a, ALL(0x1p-17));

	if (MASK_BITS(exact) == (1u << WIDTH) - 1)
		find_in_range(f, i, single, true, v);
	else
		find_in_range(f, i, single, false, v);
}

#endif
