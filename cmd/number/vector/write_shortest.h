/* SPDX-License-Identifier: MIT */
/* Finds shortest digits, without rounding from 2^-17 to 2^52 (floats: to 2^23). */
#pragma once

#include "write_find.h"

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
 * If scale < 0, the errors are at most, in units of 2^-53: 1 of hi + lo (powers.h)
 * times a, POWER_ERROR x; 1 of e < 2, 2 of p - i + e < 4, and 1 of its fraction,
 * rounded. So rest has 5; to_next has 1 more, and up has 1/2; tenths < 10 has 58: 10
 * times 5, and 8 as it is rounded. A comparison is right if its sides differ by
 * WRITE_MARGIN, 512 units; if not, as in exact ties, which are frequent,
 * number_write makes the text. */
INLINE struct digits shortest_digits(V a, V top, V scale, V hi, struct product x,
    bool single, bool whole_powers)
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

/* Finds the shortest digits of 0 and of numbers from 2^-17 to 1e21 (floats: to 2^60),
 * whose scales are in the table; from 1e21 on texts have an exponent. Others are
 * computed as if they were 1; number_write makes their texts. `exact` says that no
 * number is outside and no scale is negative. */
INLINE void find_in_range(struct batch_digits *f, size_t i, bool single, bool exact,
    V v)
{
	const V one = ALL(1);
	V a = ABS(v), hi, lo;
	M in_range = LESS(a, ALL(single ? 0x1p60 : 1e21)) & ~LESS(a, ALL(0x1p-17));
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

/* If all numbers of v are from 2^-17 to 2^52 (floats: to 2^23), no operation rounds. */
INLINE void find_shortest(struct batch_digits *f, size_t i, bool single, V v)
{
	V a = ABS(v);
	M exact = LESS(a, ALL(single ? 0x1p23 : 0x1p52)) & ~LESS(a, ALL(0x1p-17));

	if (MASK_BITS(exact) == (1u << WIDTH) - 1)
		find_in_range(f, i, single, true, v);
	else
		find_in_range(f, i, single, false, v);
}
