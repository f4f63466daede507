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

/* The digits of a batch of numbers. whole has WHOLE_DIGITS digits, or the upper half of
 * them if `lower` has the others; the point stands `scale` digits before their end.
 * digit is the 17th, which is not written if it is 0. sign is -1, 1 for no minus, and 0
 * if number_write has to make the text. */
struct batch_digits {
	double whole[NUMBER_BATCH], lower[NUMBER_BATCH];
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

/* Returns floor(log10 a) where in_range, which is from 1e-6 to below 1e15.
 * FLOOR(78913 / 2^18 floor(log2 a)) is that or one less; a comparison of a with the
 * next power of ten corrects this. A power below 1 is rounded, but a number equal to
 * this double gives the same text with either log10: its n <= MOST_DIGITS digits
 * round to a one and zeros. */
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

/* A comparison in find_parts is right in spite of roundings if its
 * sides differ by more. */
#define PARTS_MARGIN 0x1p-27

/* Finds the integers of numbers below 1e15, and the first WHOLE_DIGITS decimals in two
 * halves. Of these `scale` are rounded, and zeros follow: n decimals if `decimals` is
 * set, else as many as make n significant digits. So numbers from 1/10 on can have 17
 * decimals; rest->digit is the last. The double nearest to 1/10 is above it, so that
 * floor_log10 is right there, too.
 *
 * The fraction times 10^upper has a whole part, which makes the upper digits, and
 * leaves r for the lower ones. As these are one or more, their parity breaks ties. A
 * number from 1/10 on is a multiple of 2^-56, and r one of 2^-48: both products are
 * exact. The r of a smaller number has an error of up to 2^-54, and r times 10^8 one
 * below PARTS_MARGIN. */
INLINE void find_parts(struct batch_digits *whole, struct batch_digits *rest, size_t i,
    int n, bool decimals, V v)
{
	const V eight = ALL(8), one = ALL(1);
	V a = ABS(v), top = FLOOR(a), scale = ALL(n), hi, end, lo, half, pad;
	M in_range = LESS(a, ALL(1e15)) & ~LESS(a, ALL(0.1));

	if (!decimals)
		scale = ALL(n - 1) - floor_log10(a, in_range);
	V upper = MIN(scale - one, eight), lower = scale - upper;

	power_of_ten(upper, &hi, &lo);
	struct product x = multiply_exactly(a - top, hi, lo, true);
	V r = (x.p - x.i) + x.e, j = FLOOR(r);

	power_of_ten(lower, &end, &lo);
	struct product y = multiply_exactly(r - j, end, lo, true);
	V low = round_ties_even(y, &half), high = x.i + j;
	M carry = EQUAL(low, end), sure = in_range | EQUAL(a, ALL(0));

	if (decimals)
		sure = LESS(a, ALL(1e15)) & (sure | LESS(ALL(PARTS_MARGIN), ABS(half)));
	low = ONLY(~carry, low);
	high = high + ONLY(carry, one);
	carry = EQUAL(high, hi);
	high = ONLY(~carry, high);
	top = top + ONLY(carry, one);
	M minus = LESS(v, ALL(0)) & ~EQUAL(top + high + low, ALL(0));
	/* the ninth lower digit; 0.1 is too large by less than 2^-56,
	 * so FLOOR is right */
	M nine = LESS(eight, lower), few = LESS(upper, eight);
	V tens = FLOOR(low * ALL(0.1));

	STORE_INTS(rest->digit + i, ONLY(nine, low - tens * ALL(10)));
	/* of up to eight decimals all are in the upper half */
	power_of_ten(ALL(7) - upper, &pad, &lo);
	STORE(rest->whole + i, SELECT(few, (high * end + low) * pad, high));
	power_of_ten(eight - MIN(lower, eight), &pad, &lo);
	STORE(rest->lower + i, ONLY(~few, SELECT(nine, tens, low * pad)));
	STORE(whole->whole + i, top);
	STORE_INTS(whole->sign + i, ONLY(sure, SELECT(minus, ALL(-1), one)));
}
