/* SPDX-License-Identifier: MIT */
/* Makes the texts of NUMBER_BATCH numbers at a time, by short loops over all of them,
 * whose turns the processor overlaps. write_find.h and write_shortest.h
 * find the digits. They have a fixed place; number_text_put copies them
 * with a point between them.
 *
 * A file that includes this file has the vectors of doubles that
 * core/points/kernel/copy.h describes, and defines:
 *
 *	LOOPS		the name of its struct number_loops
 *	lanes, quarters	vectors of integers of 64 and 16 bits, as large as a V
 *	STORE_INTS(p, a) stores whole numbers, the lanes of a V, as int32_t
 *	FLOOR, NEAREST	round to a whole number, NEAREST with ties to even
 *	REGISTER	the constraint of asm for a register of a vector
 *	MUL32(a, n)	the products of the lower halves of lanes and n
 *	HIGH16(a, n)	the upper halves of the products of quarters and n
 *	power_of_ten(scale, &hi, &lo)	looks 10^scale up in powers.h as hi + lo
 *	BYTES_LOW, BYTES_HIGH(a)
 *			the bytes of the lanes 0, 2, ... or of 1, 3, ..., each in
 *			the upper half of a quarter whose lower half is 0
 *	store_digits(to, step, nonzero, a, b)
 *			stores a, the digits of the numbers 0, 2, ..., and b, the digits
 *			of 1, 3, ..., to texts that are step bytes apart; sets bit i of
 *			nonzero[k] if digit i of number k is not 0
 *
 * In each lane every operation on doubles rounds once, by IEEE 754. */
#include "write_shortest.h"

/* The number of zeros that are stored before the WHOLE_DIGITS digits of a text. */
enum { ZEROS_BEFORE = 8 };

/* Hides a constant factor from gcc, which would make up to five operations of it. */
INLINE quarters opaque(uint16_t n)
{
	quarters c = (quarters){ 0 } + n;

	__asm__("" : "+" REGISTER(c));
	return c;
}

/* split_8, split_4 and split_2 halve numbers of 8, 4 and 2 digits. A quotient by 10^4,
 * 100 or 10 is a product with 2^40/10^4, 2^19/100 or 2^16/10 rounded up. The product is
 * less than 1/10^4, 1/100 or 1/10 too large: its whole part is right.
 *
 * Returns x < 10^8, the lower half of each lane, as two numbers of four digits, a and x
 * - 10^4 a, in two quarters. Lanes are doubles 2^52 + x; x << 16 drops the 2^52. */
INLINE lanes split_8(lanes x)
{
	lanes a = MUL32(x, 109951163) >> 40;

	return (x << 16) - MUL32(a, (10000 << 16) - 1);
}

/* Returns four digits in each quarter as two numbers of two, in the quarter's bytes. */
INLINE quarters split_4(quarters x)
{
	quarters a = HIGH16(x, 5243) >> 3;

	return a | (x - a * opaque(100)) << 8;
}

/* Returns two digits in the upper byte of each quarter as one digit in each byte. */
INLINE quarters split_2(quarters x)
{
	quarters a = HIGH16(x, 6554) >> 8;

	return x - a * opaque((10 << 8) - 1);
}

/* Writes the WHOLE_DIGITS digits of f->whole < 10^16 at place `at` or, if `halves` is
 * set, those of f->whole and f->lower. FLOOR gives the right quotient by 10^8: The
 * double 1e-8 is 2.1e-25 more than 10^-8, so that the product is less than 2.1e-9 too
 * large. Rounding adds at most 7.5e-9, half a unit in the last place below 2^27. Only
 * an error of 1e-8 could reach the next whole number. */
INLINE void write_digits(struct number_text *t, size_t at, uint16_t *nonzero,
    const struct batch_digits *f, bool halves)
{
	const V lowest_bits = ALL(0x1p52);

	for (size_t i = 0; i < NUMBER_BATCH; i += WIDTH) {
		V whole = LOAD(f->whole + i);
		V high = halves ? whole : FLOOR(whole * ALL(1e-8));
		V low = halves ? LOAD(f->lower + i) : FMA(high, ALL(-1e8), whole);
		quarters x = split_4((quarters)(split_8((lanes)(high + lowest_bits)) |
		    split_8((lanes)(low + lowest_bits)) << 32));

		store_digits(t[i].chars + at, sizeof *t, nonzero + i,
		    split_2(BYTES_LOW(x)), split_2(BYTES_HIGH(x)));
	}
}

/* Returns the index of the highest bit that is set in x < 2^24, or -127 if x is 0, by
 * operations that compilers can vectorize. */
INLINE int highest_bit(int x)
{
	float f = (float)x;
	int32_t bits;

	memcpy(&bits, &f, sizeof bits);
	return (bits >> 23) - 127;
}

/* A text begins with its first digit that is not 0, or the 0 before the point. It ends
 * with its last digit, not 0 unless keep_zeros is set, or before a point without
 * decimals, which stands f->scale digits before the end of digits_of_whole digits. */
INLINE void lay_out(uint32_t *layout, const uint16_t *nonzero,
    const struct batch_digits *f, int digits_of_whole, bool keep_zeros)
{
	for (size_t i = 0; i < NUMBER_BATCH; i++) {
		int digits = nonzero[i] | (f->digit[i] != 0) << WHOLE_DIGITS;
		int some = digits | 1 << WHOLE_DIGITS, sign = f->sign[i];
		int first = highest_bit(some & -some), minus = sign < 0;
		int end = keep_zeros ? WHOLE_DIGITS : highest_bit(digits) + 1;
		int point = digits_of_whole - f->scale[i];
		int begin = first < point - 1 ? first : point - 1;
		int before = point - begin;
		int size = before + (end > point ? end - point + 1 : 0);
		int all = (ZEROS_BEFORE + begin) | minus << 8 | before << 16 |
		    size << 24;

		layout[i] = (uint32_t)(sign != 0 ? all : 0);
	}
}

/* Writes the zeros before the digits, the 17th digit, zeros after it, which texts need
 * without keep_zeros alone, and the layout. Six zeros on each side are enough. */
INLINE void write_zeros(struct number_text *t, const uint32_t *layout,
    const struct batch_digits *f, bool keep_zeros)
{
	const uint64_t zeros = 0x3030303030303030;

	for (size_t i = 0; i < NUMBER_BATCH; i++) {
		char *digits = t[i].chars + ZEROS_BEFORE;

		memcpy(digits - ZEROS_BEFORE, &zeros, sizeof zeros);
		if (!keep_zeros) {
			memcpy(digits + WHOLE_DIGITS, &zeros, sizeof zeros);
			digits[WHOLE_DIGITS] = (char)('0' + f->digit[i]);
		}
		t[i].layout = layout[i];
	}
}

/* Makes the texts of count numbers. The kind NUMBER_DECIMALS keeps zeros at the end. */
INLINE void write_all(const double *v, size_t count, enum number_kind kind, int n,
    bool single, struct number_text *t)
{
	const bool decimals = kind == NUMBER_DECIMALS;
	const bool float_shortest = single && kind == NUMBER_SHORTEST;
	struct batch_digits f;
	uint16_t nonzero[NUMBER_BATCH];
	uint32_t layout[NUMBER_BATCH];

	for (size_t k = 0; k < count; k += NUMBER_BATCH, t += NUMBER_BATCH) {
		for (size_t i = 0; i < NUMBER_BATCH; i += WIDTH)
			if (decimals)
				find_decimals(&f, i, n, LOAD(v + k + i));
			else if (kind == NUMBER_DIGITS)
				find_significant(&f, i, n, LOAD(v + k + i));
			else
				find_shortest(&f, i, single, LOAD(v + k + i));
		write_digits(t, ZEROS_BEFORE, nonzero, &f, false);
		lay_out(layout, nonzero, &f,
		    float_shortest ? WHOLE_DIGITS / 2 : WHOLE_DIGITS, decimals);
		write_zeros(t, layout, &f, decimals);
	}
}

/* Makes the texts of count numbers with integers and decimals apart. `decimals` is the
 * number of decimals, or 0 if there are n digits without zeros at their end. */
INLINE void write_parts(const double *v, size_t count, int n, int decimals,
    struct number_text *t)
{
	struct batch_digits whole, rest;
	uint16_t digits[2][NUMBER_BATCH];

	for (size_t k = 0; k < count; k += NUMBER_BATCH, t += NUMBER_BATCH) {
		for (size_t i = 0; i < NUMBER_BATCH; i += WIDTH)
			find_parts(&whole, &rest, i, n, decimals > 0, LOAD(v + k + i));
		write_digits(t, 0, digits[0], &whole, false);
		write_digits(t, WHOLE_DIGITS, digits[1], &rest, true);
		for (size_t i = 0; i < NUMBER_BATCH; i++) {
			int some = digits[0][i] | 1 << (WHOLE_DIGITS - 1);
			int first = highest_bit(some & -some);
			int before = WHOLE_DIGITS - first, sign = whole.sign[i];
			int last = digits[1][i] | (rest.digit[i] != 0) << WHOLE_DIGITS;
			int after = decimals > 0 ? decimals : highest_bit(last) + 1;
			int size = before + (after > 0 ? after + 1 : 0);
			int all = first | (sign < 0) << 8 | before << 16 | size << 24;

			t[i].chars[2 * WHOLE_DIGITS] = (char)('0' + rest.digit[i]);
			t[i].layout = (uint32_t)(sign != 0 ? all : 0);
		}
	}
}

/* Makes the texts by write_all or write_parts, with kind and single as constants for
 * the compiler. */
static void loops_write(const double *v, size_t count, bool single,
    struct number_style style, struct number_text *t)
{
	if (style.kind == NUMBER_SHORTEST && single)
		write_all(v, count, NUMBER_SHORTEST, 0, true, t);
	else if (style.kind == NUMBER_SHORTEST)
		write_all(v, count, NUMBER_SHORTEST, 0, false, t);
	else if (style.n > WHOLE_DIGITS + (style.kind == NUMBER_DIGITS))
		memset(t, 0, count * sizeof *t);
	else if (style.kind == NUMBER_DECIMALS && style.n >= LEAST_PARTS)
		write_parts(v, count, style.n, style.n, t);
	else if (style.n > MOST_DIGITS)
		write_parts(v, count, style.n, 0, t);
	else if (style.kind == NUMBER_DECIMALS)
		write_all(v, count, NUMBER_DECIMALS, style.n, false, t);
	else
		write_all(v, count, NUMBER_DIGITS, style.n, false, t);
}

const struct number_loops LOOPS = { loops_find, loops_read, loops_write };
