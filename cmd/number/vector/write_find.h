/* SPDX-License-Identifier: MIT */
/* Finds a given number of decimals or of significant digits by the operations on
 * doubles that write_body.h lists. If rounding could change the digits of a number,
 * number_write makes its text. */
#pragma once

#include <math.h>

#include "loops.h"
#include "powers.h"

#define INLINE static inline __attribute__((always_inline))

/* A comparison is right in spite of roundings if its sides differ by more than
 * WRITE_MARGIN; write_shortest.h adds up the errors. */
#define WRITE_MARGIN 0x1p-44

/* The most digits that a whole number below 2^53 has. */
enum { WHOLE_DIGITS = 16 };

/* A style may ask these loops for at most MOST_DIGITS decimals or significant digits.
 * They write at most MOST_ZEROS zeros between digits and the point. */
enum { MOST_DIGITS = 15, MOST_ZEROS = 6 };

/* More decimals than LEAST_PARTS - 1, and more digits than MOST_DIGITS, are found by
 * find_parts. It serves up to WHOLE_DIGITS decimals and one digit more. */
enum { LEAST_PARTS = 13 };

/* The digits of a batch of numbers. whole has WHOLE_DIGITS digits; the point stands
 * `scale` digits before their end. digit is the 17th, which is not written if it is 0.
 * sign is -1, 1 for no minus, and 0 if number_write has to make the text. */
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

/* As in struct batch_digits. If sure is false, number_write has to make the text. */
struct digits {
	V whole, digit;
	M sure;
};

/* Returns log2 of a power of two, less `place`: a shift moves its biased exponent. */
INLINE V log2_of_power(V power, double place)
{
	V biased = (V)((lanes)power >> 52 | (lanes)ALL(0x1p52));

	return biased - ALL(0x1p52 + 1023 + place);
}

INLINE V power_of_two_up_to(V a)
{
	return (V)((lanes)a & (lanes)ALL((double)INFINITY));
}

INLINE void store_lanes(struct batch_digits *f, size_t i, V v, struct digits d, V scale)
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
	struct digits d = { round_ties_even(x, &rest), ALL(0), LESS(x.p, ALL(0x1p53)) };

	store_lanes(f, i, v, d, scale);
}

/* Returns floor(log10 a) where in_range, which is from 1e-6 to below 1e15. FLOOR(78913 /
 * 2^18 floor(log2 a)) is that or one less; a comparison of a with the next power of ten
 * corrects this. A power below 1 is rounded, but a number equal to this double gives the
 * same text with either log10: its n <= MOST_DIGITS digits round to a one and zeros. */
INLINE V floor_log10(V a, M in_range)
{
	V top = power_of_two_up_to(SELECT(in_range, a, ALL(1))), hi, lo;
	V log10 = FLOOR(log2_of_power(top, 0) * ALL(78913 * 0x1p-18));

	power_of_ten(log10 + ALL(1), &hi, &lo);
	return log10 + ONLY(~(LESS(a, hi) | ~in_range), ALL(1));
}

/* Finds n <= MOST_DIGITS significant digits of numbers from 1e-6 to below 1e15. If
 * scale < 0, the product is rounded, by less than WRITE_MARGIN (write_shortest.h);
 * number_write makes the text if x is no farther than this from a tie. */
INLINE void find_significant(struct batch_digits *f, size_t i, int n, V v)
{
	const V zero = ALL(0);
	V a = ABS(v), hi, lo, rest;
	M in_range = LESS(a, ALL(1e15)) & ~LESS(a, ALL(1e-6));
	V scale = ALL(n - 1) - floor_log10(a, in_range);
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

/* Finds the integers of numbers below 1e15, and the first WHOLE_DIGITS decimals, of which
 * scale are rounded, and zeros follow: n decimals if `decimals` is set, else as many as
 * make n significant digits. The product of a fraction and 10^scale has to be below 2^53,
 * so that round_ties_even serves; with the zeros it is a multiple of 2^(WHOLE_DIGITS -
 * scale) below 2^54, a double. A power of ten below 1 is met with scale = WHOLE_DIGITS
 * alone, if it is 1/10, which rounds up to the double: floor_log10 is right. */
INLINE void find_parts(struct batch_digits *whole, struct batch_digits *rest, size_t i,
    int n, bool decimals, V v)
{
	V a = ABS(v), top = FLOOR(a), scale = ALL(n), hi, lo, half;
	M in_range = LESS(a, ALL(1e15)) & ~LESS(a, ALL(0.1));

	if (!decimals)
		scale = ALL(n - 1) - floor_log10(a, in_range);
	M in_table = LESS(scale, ALL(WHOLE_DIGITS + 1));

	scale = ONLY(in_table, scale);
	power_of_ten(scale, &hi, &lo);
	struct product x = multiply_exactly(a - top, hi, lo, true);
	V r = round_ties_even(x, &half);
	M carry = EQUAL(r, hi), sure = in_range & in_table;

	if (decimals)
		sure = LESS(a, ALL(1e15));
	top = top + ONLY(carry, ALL(1));
	r = ONLY(~carry, r);
	power_of_ten(ALL(WHOLE_DIGITS) - scale, &hi, &lo);
	sure = (sure | EQUAL(a, ALL(0))) & LESS(x.p, ALL(0x1p53));
	M minus = LESS(v, ALL(0)) & ~EQUAL(top + r, ALL(0));

	STORE(whole->whole + i, top);
	STORE(rest->whole + i, r * hi);
	STORE_INTS(whole->sign + i, ONLY(sure, SELECT(minus, ALL(-1), ALL(1))));
}
