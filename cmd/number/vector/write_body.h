/* The texts of TEXTS numbers at a time, in short loops, each over all of them: of a
 * long one the processor could not begin the next turn before this one's results.
 * The digits are found (write_find.h), written to fields of a fixed width, and
 * copied from there with a point among them.
 *
 * A file that includes this defines:
 *
 *	V, WIDTH	a vector of doubles, and how many it holds
 *	I		the same bytes as integers of 64 bits
 *	M		a yes or no for each lane, with & | ~
 *	LOAD, STORE	of a V, from and to any address
 *	STORE_INTS(p, a) a's lanes, which are whole, as int32_t
 *	ALL(a)		a in each lane
 *	FMA(a, b, c)	a b + c, rounded once
 *	FLOOR, NEAREST	to a whole number; NEAREST has ties to even
 *	ABS, MIN	MIN is any number where one is nan
 *	LESS, EQUAL	an M; no where one is nan
 *	CHOOSE(m, a, b)	m ? a : b
 *	ONLY(m, a)	m ? a : 0
 *	UNLESS(m, a)	m ? 0 : a
 *	BITS, DOUBLES	V as I and back
 *	ALL_BITS(a)	a in each lane of an I
 *	SHL, SHR(a, n)	of an I's lanes, zeros shifted in
 *	SHR16(a, n)	of its quarters, 16 bits
 *	MUL32(a, b)	the products of its lanes' lower halves
 *	MUL16, HIGH16	the lower and the upper half of its quarters' products
 *
 * where V and I have + - *, I and M & |, lane by lane, and
 *
 *	struct tens, load_tens, power_of_ten
 *			10^POWER_MIN to 10^POWER_MAX, where they are soon found
 *	store_digits	of the lanes' numbers, eight and eight, to their fields,
 *			as text; and a bit for each that isn't 0
 *	copy_with_point	from a field, a point after the first so many
 *
 * Every operation on doubles is one rounding of IEEE 754 in each lane. */
#include "write_find.h"

/* Where digits stand before they become text: zeros for those before the first
 * (and room for a minus), 16 digits and the 17th, zeros for those after it. */
enum { BEFORE = 8, FIELD = 64 };

struct fields {
	char b[TEXTS][FIELD];
	uint16_t nonzero[TEXTS]; /* a bit for each of the 16 */
	/* where the digits of the text begin, whether a minus stands before
	 * them; how many characters stand before the point; all, 0 for none */
	int8_t first[TEXTS], minus[TEXTS], before[TEXTS], size[TEXTS];
};

/* The digits of x < 10^8, which is the lower half of its lane: four and four, then
 * two and two, then one by one, the first in the lowest byte. A quotient is a
 * product with the reciprocal, rounded up, 2^40/10^4, 2^19/100 and 2^10/10: too
 * large by less than the 1/10^4, 1/100 or 1/10 that could carry it over. What a
 * difference has in the upper half is shifted out. */
INLINE I eight_digits(I x)
{
	I a = SHR(MUL32(x, ALL_BITS(109951163)), 40);

	x = a | SHL(x - MUL32(a, ALL_BITS(10000)), 32);
	a = SHR16(HIGH16(x, ALL_BITS(5243 * 0x0000000100000001)), 3);
	x = a | SHL(x - MUL16(a, ALL_BITS(100 * 0x0000000100000001)), 16);
	a = SHR16(MUL16(x, ALL_BITS(103 * 0x0001000100010001)), 10);
	return a | SHL(x - MUL16(a, ALL_BITS(10 * 0x0001000100010001)), 8);
}

/* The quotient by 10^8 is right below 2^53: 1e-8 is 2.1e-25 more than 10^-8, so
 * that the product is less than 1.9e-9 too large, where it would take 1e-8 to reach
 * the next whole number; half a unit of its last place, below 2^27, is 7.5e-9. */
INLINE void write_digits(struct fields *to, const struct found *f)
{
	const V lowest_bits = ALL(0x1p52);

	for (size_t i = 0; i < TEXTS; i += WIDTH) {
		V whole = LOAD(f->whole + i);
		V high = FLOOR(whole * ALL(1e-8));
		V low = FMA(high, ALL(-1e8), whole);

		store_digits(to->b[i] + BEFORE, FIELD, to->nonzero + i,
		    eight_digits(BITS(high + lowest_bits)),
		    eight_digits(BITS(low + lowest_bits)));
	}
}

/* The highest bit that is set in x < 2^24, -127 for none: compilers know how to do
 * this for a vector. */
INLINE int highest_bit(int x)
{
	float f = (float)x;
	int32_t bits;

	memcpy(&bits, &f, sizeof bits);
	return (bits >> 23) - 127;
}

/* A text begins with its first digit, or with a zero before the point. Without a
 * point it ends there, or else with its last digit, which is not 0 unless zeros are
 * kept. */
INLINE void lay_out(struct fields *to, const struct found *f, int whole_digits,
    bool keep_zeros)
{
	for (size_t i = 0; i < TEXTS; i++) {
		int digits = to->nonzero[i] | (f->digit[i] != 0) << DIGITS;
		int some = digits | 1 << DIGITS, sign = f->sign[i];
		int first = highest_bit(some & -some), minus = sign < 0;
		int end = keep_zeros ? DIGITS : highest_bit(digits) + 1;
		int point = whole_digits - f->scale[i];
		int begin = first < point - 1 ? first : point - 1;
		int before = point - begin + minus;
		int after = end > point ? end - point + 1 : 0;

		to->first[i] = (int8_t)(BEFORE + begin);
		to->minus[i] = (int8_t)minus;
		to->before[i] = (int8_t)before;
		to->size[i] = (int8_t)((before + after) * (sign != 0));
	}
}

/* The zeros before the digits, a minus among them whether it is used or not; and
 * the 17th with zeros after it. */
INLINE void write_around(struct fields *to, const struct found *f)
{
	const uint64_t zeros = 0x3030303030303030;

	for (size_t i = 0; i < TEXTS; i++) {
		char *digits = to->b[i] + BEFORE;

		memcpy(digits - BEFORE, &zeros, BEFORE);
		memset(digits + DIGITS, '0' + f->digit[i], 1);
		to->b[i][to->first[i] - 1] = '-';
	}
}

INLINE void write_texts(struct number_text *t, const struct fields *from)
{
	for (size_t i = 0; i < TEXTS; i++) {
		copy_with_point(t[i].b,
		    from->b[i] + from->first[i] - from->minus[i],
		    from->before[i]);
		t[i].b[sizeof t[i].b - 1] = (char)from->size[i];
	}
}

/* n is of decimals, whose zeros at the end are kept, or of find_shortest. */
INLINE void write_all(const double *v, size_t count, bool decimals, int n,
    bool single, struct number_text *t)
{
	const struct tens tens = load_tens();
	struct found f;
	struct fields fields;

	memset(fields.b, '0', sizeof fields.b);
	for (; count > 0; count -= TEXTS, v += TEXTS, t += TEXTS) {
		for (size_t i = 0; i < TEXTS; i += WIDTH)
			if (decimals)
				find_decimals(&f, i, n, &tens, LOAD(v + i));
			else
				find_shortest(&f, i, n, single, &tens,
				    LOAD(v + i));
		write_digits(&fields, &f);
		lay_out(&fields, &f, single ? DIGITS / 2 : DIGITS, decimals);
		write_around(&fields, &f);
		write_texts(t, &fields);
	}
}

/* Loops of their own for the shortest and for a limit, double and float. */
static void write_body(const double *v, size_t count, bool single,
    struct number_style style, struct number_text *t)
{
	const int most_decimals = 15, none = POWER_MAX + 1;
	int n = style.kind == NUMBER_SHORTEST ? none : style.n;

	if (style.kind == NUMBER_DIGITS ||
	    (style.kind == NUMBER_DECIMALS && n > most_decimals))
		memset(t, 0, count * sizeof *t);
	else if (style.kind == NUMBER_DECIMALS)
		write_all(v, count, true, n, false, t);
	else if (n > POWER_MAX && single)
		write_all(v, count, false, none, true, t);
	else if (n > POWER_MAX)
		write_all(v, count, false, none, false, t);
	else if (single)
		write_all(v, count, false, n, true, t);
	else
		write_all(v, count, false, n, false, t);
}
