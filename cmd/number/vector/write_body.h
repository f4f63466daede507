/* The texts of 64 numbers at a time, in short loops, each over all of them: a
 * long one would not fit the processor's window of instructions, and the next
 * turn would wait for this one's results. A file that includes this defines:
 *
 *	V, WIDTH	a vector of doubles, and how many it holds
 *	I		the same bytes as unsigned integers of 64 bits
 *	M		a yes or no for each lane, with & | ~
 *	LOAD, STORE	of a V, from and to any address
 *	STORE_INTS(p, a) the lanes of a, whole numbers, as int32_t
 *	ALL(a)		a in each lane
 *	FMA(a, b, c)	a b + c, rounded once
 *	FLOOR, NEAREST	a whole number; NEAREST with ties to even
 *	ABS, MIN
 *	LESS, EQUAL	an M; LESS is false where one is nan
 *	CHOOSE(m, a, b)	m ? a : b
 *	ONLY(m, a)	m ? a : 0
 *	BITS, DOUBLES	V to I and back
 *	ALL_BITS(a)	a in each lane of an I
 *	SHL, SHR(a, n)	of an I's lanes
 *	MUL32(a, b)	the products of the lower halves of an I's lanes
 *	MUL16(a, b)	the lower halves of products of 16 bits
 *	HIGH16(a, b)	the upper halves
 *
 * V and I have + - * & |, lane by lane; and these functions:
 *
 *	struct tens, load_tens, power_of_ten
 *	store_digits, copy_with_point
 *
 * Every operation on doubles is one rounding of IEEE 754 in each lane. */
#include "vector.h"

#define INLINE static inline __attribute__((always_inline))

/* What is written of a number v is the integer whole, of up to 16 digits,
 * and after it a 17th, digit, unless that is 0; the point is after the first
 * point of them. */
struct found {
	double whole[TEXTS];
	int32_t digit[TEXTS], point[TEXTS];
	int32_t minus[TEXTS], made[TEXTS]; /* 1 or 0 */
};

/* Where digits stand before they become text: zeros for those before the first
 * (and room for a minus), the 16 and the 17th, zeros for those after. */
enum { BEFORE = 8, DIGITS = 16, FIELD = 64 };

struct fields {
	char b[TEXTS][FIELD];
	uint16_t nonzero[TEXTS]; /* a bit for each of the 16 */
	/* the text's first character in its field, minus or digit; how many
	 * characters stand before its point; and its length, 0 for none */
	int8_t start[TEXTS], before[TEXTS], size[TEXTS];
};

/* x = v 10^scale as p + e, and the greatest integer i <= p. */
struct scaled {
	V p, e, i;
};

INLINE struct scaled scaled(V v, V hi, V lo)
{
	struct scaled x = { .p = v * hi };

	x.e = FMA(v, lo, FMA(v, hi, -x.p));
	x.i = FLOOR(x.p);
	return x;
}

/* The nearest integer to x, ties to even, exactly where 10^scale is a double and
 * x < 2^53: then x = p + e, |e| is at most half a unit of p, and p - i - 1/2 is
 * exact. Its sum with e, though rounded, has the sign of x - i - 1/2. That is 0
 * where e = 0 and NEAREST breaks the tie; or where p > 2^52 is an integer and
 * e = 1/2: then p is even, as the product x was rounded to it. */
INLINE V nearest(struct scaled x)
{
	V rest = (x.p - x.i - ALL(0.5)) + x.e;
	V i = x.i + ONLY(LESS(ALL(0), rest), ALL(1));

	return CHOOSE(EQUAL(rest, ALL(0)), NEAREST(x.p), i);
}

/* An exponent of two as a double: in the lower bits of 2^52. */
INLINE V exponent(V a)
{
	V biased = DOUBLES(SHR(BITS(a), 52) | BITS(ALL(0x1p52)));

	return biased - ALL(0x1p52 + 1023);
}

INLINE V and_bits(V a, uint64_t mask)
{
	return DOUBLES(BITS(a) & ALL_BITS(mask));
}

INLINE void search(struct found *f, size_t i, struct number_style style,
    bool single, const struct tens *tens, V v)
{
	const bool decimals = style.kind == NUMBER_DECIMALS;
	const bool within = style.kind == NUMBER_WITHIN;
	const V one = ALL(1), n = ALL(style.n);
	V a = ABS(v);
	M zero = EQUAL(a, ALL(0)), made, near = EQUAL(a, a);
	V scale = n, digit = ALL(0), two = one, hi, lo;

	if (!decimals) {
		V low = ALL(within && style.n <= 6 ? 0 : 1e-6);
		M range = ~LESS(a, low) & LESS(a, ALL(single ? 0x1p57 : 1e21));

		two = and_bits(CHOOSE(range, a, one), 0x7ffull << 52);
		V q = exponent(two) - ALL(single ? 23 : 52);
		scale = -one - FLOOR(q * ALL(0.30102999566398120));
		made = range | zero;
		if (within) {
			near = ~LESS(scale, n);
			scale = MIN(scale, n);
		}
	}
	power_of_ten(tens, scale, &hi, &lo);
	struct scaled x = scaled(a, hi, lo);
	V whole = x.i;
	if (decimals) {
		whole = nearest(x);
		made = LESS(x.p, ALL(0x1p53));
	} else {
		V rest = (x.p - x.i) + x.e;
		V j = FLOOR(rest);
		V up = hi * two * ALL(single ? 0x1p-24 : 0x1p-53);
		V down = up - ONLY(EQUAL(a, two), up * ALL(0.5));

		whole = x.i + j;
		rest = rest - j;
		V g = one - rest, tenths = rest * ALL(10), d = NEAREST(tenths);
		M below = LESS(rest, down), above = LESS(g, up);
		V margin = MIN(MIN(ABS(rest - down), ABS(g - up)),
		    ALL(0.5) - ABS(tenths - d));
		M exact = LESS(ABS(scale - ALL(10)), ALL(10.5));
		M sure = (exact | ~LESS(margin, ALL(WRITE_MARGIN))) &
		    (below | above | ~EQUAL(a, two));
		whole = whole + ONLY(above, one);
		digit = ONLY(~(below | above), d);
		if (within) {
			whole = CHOOSE(near, nearest(x), whole);
			digit = ONLY(~near, digit);
			sure = sure | near;
		}
		made = made & sure;
	}
	M minus = LESS(v, ALL(0)) & ~EQUAL(whole, ALL(0));
	V point = ALL(DIGITS) - scale;
	if (single && !decimals) {
		whole = FMA(whole, ALL(1e8), digit * ALL(1e7));
		digit = ALL(0);
		point = point - ALL(8);
	}
	STORE(f->whole + i, whole);
	STORE_INTS(f->digit + i, digit);
	STORE_INTS(f->point + i, point);
	STORE_INTS(f->minus + i, ONLY(minus, one));
	STORE_INTS(f->made + i, ONLY(made, one));
}

/* The eight digits of x < 10^8, the low half of its lane, the first in the lowest
 * byte. */
INLINE I eight_digits(I x)
{
	I a = SHR(MUL32(x, ALL_BITS(109951163)), 40);
	x = a | SHL(x - MUL32(a, ALL_BITS(10000)), 32);
	a = SHR16(HIGH16(x, ALL_BITS(0x0000147b0000147b)), 3);
	x = a | SHL(x - MUL16(a, ALL_BITS(0x0000006400000064)), 16);
	a = SHR16(MUL16(x, ALL_BITS(0x0067006700670067)), 10);
	return a | SHL(x - MUL16(a, ALL_BITS(0x000a000a000a000a)), 8);
}

INLINE void write_digits(struct fields *to, const struct found *f)
{
	const V magic = ALL(0x1p52);

	for (size_t i = 0; i < TEXTS; i += WIDTH) {
		V whole = LOAD(f->whole + i);
		V high = FLOOR(whole * ALL(1e-8));
		V low = FMA(high, ALL(-1e8), whole);

		store_digits(to->b[i] + BEFORE, to->nonzero + i,
		    eight_digits(BITS(high + magic)),
		    eight_digits(BITS(low + magic)));
	}
}

/* The greatest e with 2^e <= x, for 0 < x < 2^24; negative for 0. */
INLINE int log2_of(int x)
{
	float f = (float)x;
	int32_t bits;

	memcpy(&bits, &f, sizeof bits);
	return (bits >> 23) - 127;
}

INLINE void lay_out(struct fields *to, const struct found *f, bool strip)
{
	for (size_t i = 0; i < TEXTS; i++) {
		int z = to->nonzero[i] | (f->digit[i] != 0) << DIGITS;
		int some = z | 1 << DIGITS, point = f->point[i];
		int first = log2_of(some & -some);
		int end = strip ? log2_of(z) + 1 : DIGITS;
		int begin = first < point - 1 ? first : point - 1;
		int before = point - begin + f->minus[i];
		int after = end > point ? end - point + 1 : 0;

		to->start[i] = (int8_t)(BEFORE + begin - f->minus[i]);
		to->before[i] = (int8_t)before;
		to->size[i] = (int8_t)((before + after) * f->made[i]);
	}
}

INLINE void write_around(struct fields *to, const struct found *f)
{
	for (size_t i = 0; i < TEXTS; i++) {
		const uint64_t zeros = 0x3030303030303030;
		uint64_t last = zeros + (uint64_t)f->digit[i];

		memcpy(to->b[i], &zeros, 8);
		memcpy(to->b[i] + BEFORE + DIGITS, &last, 8);
		to->b[i][to->start[i] + f->minus[i] - 1] = '-';
	}
}

INLINE void write_texts(struct number_text *t, const struct fields *from)
{
	for (size_t i = 0; i < TEXTS; i++) {
		copy_with_point(t[i].b, from->b[i] + from->start[i],
		    from->before[i]);
		t[i].b[sizeof t[i].b - 1] = from->size[i];
	}
}

INLINE void texts_of(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t)
{
	const struct tens tens = load_tens();
	struct found f;
	struct fields fields;

	memset(fields.b, '0', sizeof fields.b);
	for (; n > 0; n -= TEXTS, v += TEXTS, t += TEXTS) {
		for (size_t i = 0; i < TEXTS; i += WIDTH)
			search(&f, i, style, single, &tens, LOAD(v + i));
		write_digits(&fields, &f);
		lay_out(&fields, &f, style.kind != NUMBER_DECIMALS);
		write_around(&fields, &f);
		write_texts(t, &fields);
	}
}

/* Each kind is a copy of its own. */
static void texts(const double *v, size_t n, bool single,
    struct number_style style, struct number_text *t)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	struct number_style within = { NUMBER_WITHIN, style.n };
	struct number_style decimals = { NUMBER_DECIMALS, style.n };

	if (within.n > POWER_MAX)
		within.n = POWER_MAX + 1;
	if (style.kind == NUMBER_SHORTEST && !single)
		texts_of(v, n, false, shortest, t);
	else if (style.kind == NUMBER_SHORTEST)
		texts_of(v, n, true, shortest, t);
	else if (style.kind == NUMBER_WITHIN && !single)
		texts_of(v, n, false, within, t);
	else if (style.kind == NUMBER_WITHIN)
		texts_of(v, n, true, within, t);
	else if (style.kind == NUMBER_DECIMALS && style.n <= 15)
		texts_of(v, n, false, decimals, t);
	else
		memset(t, 0, n * sizeof *t);
}
