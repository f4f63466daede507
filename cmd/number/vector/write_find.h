/* The decimal digits of a number, found by operations on doubles (write_body.h
 * says which). Nothing is rounded below 2^53, or 2^24 for floats, down to 1e-6;
 * beyond that what rounding could change is left to number_write. */
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

/* What is written of a number: the DIGITS digits of whole, a 17th, digit, unless
 * that is 0, and a point after the first point of them. 1 or 0 says whether there
 * is a minus, and whether it is made at all. */
struct found {
	double whole[TEXTS];
	int32_t digit[TEXTS], point[TEXTS], minus[TEXTS], made[TEXTS];
};

/* x = a 10^scale as p + e, and the greatest integer i <= p. hi + lo is the power;
 * where scale >= 0 it is hi, of 49 bits at most (5^21 < 2^49), so that e, what
 * the product's rounding to p has lost, is exact, and x = p + e. */
struct scaled {
	V p, e, i;
};

INLINE struct scaled scaled(V a, V hi, V lo)
{
	struct scaled x = { .p = a * hi };

	x.e = FMA(a, lo, FMA(a, hi, -x.p));
	x.i = FLOOR(x.p);
	return x;
}

/* The nearest whole number to x < 2^53, ties to even, where scale >= 0. p - i - 1/2
 * is exact, and |e| at most half a unit of p's last place. The sum, though rounded,
 * has the sign of x - i - 1/2. It is 0 if e = 0 and NEAREST breaks the tie, or if
 * p > 2^52 is whole and e = 1/2: then p is even already, as x, halfway between two
 * doubles, was rounded to it. */
INLINE V nearest(struct scaled x)
{
	V rest = (x.p - x.i - ALL(0.5)) + x.e;
	V i = x.i + ONLY(LESS(ALL(0), rest), ALL(1));

	return CHOOSE(EQUAL(rest, ALL(0)), NEAREST(x.p), i);
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
 * For scale from 0 to 20 nothing is rounded. x is a multiple of 2^(q + scale), up
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
    bool single)
{
	const V one = ALL(1);
	M exact = LESS(ABS(scale - ALL(10)), ALL(10.5));
	M power_of_two = EQUAL(a, two);
	V rest = (x.p - x.i) + x.e, j = FLOOR(rest);
	V up = hi * two * ALL(single ? 0x1p-24 : 0x1p-53);
	V down = up - ONLY(power_of_two, up * ALL(0.5));

	rest = rest - j;
	V to_next = one - rest, tenths = rest * ALL(10);
	V digit = NEAREST(tenths);
	M below = LESS(rest, down), above = LESS(to_next, up);
	V ends = MIN(ABS(rest - down), ABS(to_next - up));
	V margin = MIN(ends, ALL(0.5) - ABS(tenths - digit));

	return (struct digits){
		.whole = x.i + j + ONLY(above, one),
		.digit = ONLY(~(below | above), digit),
		.sure = (exact | ~LESS(margin, ALL(WRITE_MARGIN))) &
		    (below | above | ~power_of_two),
	};
}

/* The exponent of a power of two. */
INLINE V log2_exact(V two)
{
	V biased = DOUBLES(SHR(BITS(two), 52) | BITS(ALL(0x1p52)));

	return biased - ALL(0x1p52 + 1023);
}

INLINE V power_of_two_in(V a)
{
	return DOUBLES(BITS(a) & BITS(ALL((double)INFINITY)));
}

INLINE void store_found(struct found *f, size_t i, V v, struct digits d,
    V point)
{
	M minus = LESS(v, ALL(0)) & ~EQUAL(d.whole, ALL(0));

	STORE(f->whole + i, d.whole);
	STORE_INTS(f->digit + i, d.digit);
	STORE_INTS(f->point + i, point);
	STORE_INTS(f->minus + i, ONLY(minus, ALL(1)));
	STORE_INTS(f->made + i, ONLY(d.sure, ALL(1)));
}

INLINE void find_decimals(struct found *f, size_t i, int n,
    const struct tens *tens, V v)
{
	V scale = ALL(n), hi, lo;

	power_of_ten(tens, scale, &hi, &lo);
	struct scaled x = scaled(ABS(v), hi, lo);
	struct digits d = { nearest(x), ALL(0), LESS(x.p, ALL(0x1p53)) };

	store_found(f, i, v, d, ALL(DIGITS) - scale);
}

/* The shortest; or, if n <= POWER_MAX, that with at most n decimals. Where n is
 * greater than scale, the shortest has no more. Else 10^-n is more than the last
 * place, and one number of n decimals at most reads back as a: if one does, it is
 * the nearest to a, and the shortest, but for zeros at its end; so the nearest it
 * is in any case.
 *
 * Plain text goes from 1e-6, or for up to six decimals from 0, to 1e21; but here of
 * floats to 2^57, as the table begins with 10^-10. For what is not in this range
 * two is 1, so that the table is not left. */
INLINE void find_shortest(struct found *f, size_t i, int n, bool single,
    const struct tens *tens, V v)
{
	const bool limited = n <= POWER_MAX;
	const V one = ALL(1), low = ALL(n <= 6 ? 0 : 1e-6);
	V a = ABS(v), hi, lo;
	M in_range = LESS(a, ALL(single ? 0x1p57 : 1e21)) & ~LESS(a, low);
	V two = power_of_two_in(CHOOSE(in_range, a, one));
	V q = log2_exact(two) - ALL(single ? 23 : 52);
	V scale = -one - FLOOR(q * ALL(0.30102999566398120));
	M by_n = ~LESS(scale, ALL(n));

	if (limited)
		scale = MIN(scale, ALL(n));
	power_of_ten(tens, scale, &hi, &lo);
	struct scaled x = scaled(a, hi, lo);
	struct digits d = shortest(a, two, scale, hi, x, single);

	if (limited) {
		d.whole = CHOOSE(by_n, nearest(x), d.whole);
		d.digit = ONLY(~by_n, d.digit);
		d.sure = d.sure | by_n;
	}
	d.sure = d.sure & (in_range | EQUAL(a, ALL(0)));
	if (single) { /* eight digits and the ninth */
		d.whole = FMA(d.whole, ALL(1e8), d.digit * ALL(1e7));
		d.digit = ALL(0);
		scale = scale + ALL(8);
	}
	store_found(f, i, v, d, ALL(DIGITS) - scale);
}

#endif
