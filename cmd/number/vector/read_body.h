/* SPDX-License-Identifier: MIT */
/* The reader of plain numbers for one kind of processor. A file that includes
 * this has the vectors of doubles of core/points/kernel/copy.h, and defines:
 *
 *	READER		the name of its struct plain_reader
 *	IN_SET(set, s)	bit i: whether s[i] is in the set, of 64 bytes
 *	EIGHTS(rows, high, low)
 *			of 16 digits in each of WIDTH rows, 32 bytes apart, the
 *			integers that the first and the last eight are, in lanes
 *			of 64 bits
 *
 *	DOTS(row)	bit i: whether row[i] is a point, of 32 bytes
 *	LARGER(a, b)	of rows, byte by byte
 *	ANY_TOP_BIT(row)	whether the top bit of any byte is set
 *
 * and may define, where read_rows.h has it by other operations,
 *
 *	LAST(n)		a mask of the last n <= 32 bytes of a row
 *	PICK(m, a, b)	m ? a : b
 *	KEEP(m, a)	m ? a : 0
 *	LEADING_ZEROS(x)	of integers of 32 bits
 *
 * All else is arithmetic of the compiler's vectors. Whatever the width, every
 * lane goes through the same operations of IEEE 754. */
#include "read_rows.h"

typedef uint64_t U __attribute__((vector_size(WIDTH * 8)));
typedef int64_t I __attribute__((vector_size(WIDTH * 8)));
typedef double D __attribute__((vector_size(WIDTH * 8)));

/* Bit i: whether a and b differ in lane i, as nan does. */
static inline unsigned different(D a, D b)
{
	return LANES_OF(EQUAL(a, b)) ^ ((1u << WIDTH) - 1);
}

/* Integers below 2^52 as doubles: with the bits of 2^52 before them they are
 * 2^52 too large. */
static inline D double_of(U u)
{
	D d = (D)(u | 0x4330000000000000);

	return d - 0x1p52;
}

/* An integer, hi + lo, and what of it cannot be known. */
struct integer {
	D hi, lo;
	unsigned bad;
};

/* Of up to 15 digits, as many as doubles hold: exact, and so is the product. */
static inline struct integer short_integer(const struct rows *r, size_t i)
{
	U first, rest;

	EIGHTS(r->digits[i] + 16, first, rest);
	D high = double_of(first) * 1e8;

	return (struct integer){ .hi = high + double_of(rest) };
}

/* Of up to 19 digits; with more, the integer is bad. Three digits times 10^16
 * are a multiple of 2^16 below 2^64: exact. The sums lose integers of at most
 * 2^10 each, as what is below 2^64 is rounded to multiples of 2^11; these two
 * are exactly added. */
static inline struct integer long_integer(const struct rows *r, size_t i)
{
	struct integer m = { 0 };
	U first, rest;

	EIGHTS(r->digits[i], first, rest);
	I more = ((I)first > 0) | ((I)rest > 999);

	m.bad = different((D)more, (D){ 0 }); /* all bits set are a nan */
	D top = double_of(rest) * 1e16;

	EIGHTS(r->digits[i] + 16, first, rest);
	D a = double_of(first) * 1e8, b = double_of(rest);
	D s = top + a;

	m.hi = s + b;
	m.lo = (a - (s - top)) + (b - (m.hi - s));
	return m;
}

/* m / p. The quotient q of hi and p is rounded, and exact the remainder hi - q p,
 * as always when division is rounded to nearest and nothing underflows. So m / p
 * is q + c for c = (hi - q p + lo) / p, which costs two roundings: an error below
 * 2.01 * 2^-53 |c|. The two ends below are farther off, 2^-50 |c| less 2^-53 |c|
 * for their own rounding. As rounding is monotone, m / p is rounded to the same
 * double as q + either end if that is one double; else, as when it lies midway,
 * the number is bad. Where lo is 0, hi / p is Clinger's exact case. */
static inline D divide(struct integer *m, D p)
{
	D q = m->hi / p;

	if (different(m->lo, (D){ 0 }) == 0)
		return q;
	D c = (FMA(-q, p, m->hi) + m->lo) / p, off = c * 0x1p-50;
	D one = q + (c - off), other = q + (c + off);

	m->bad |= different(one, other);
	return (D)((U)one | ((U)p & 1ull << 63)); /* -0 + 0 is 0 */
}

/* Which of the rows from i on have a byte above 9. */
static inline unsigned not_digits(const struct rows *r, size_t i)
{
	unsigned bad = 0;

	for (size_t k = 0; k < WIDTH; k++)
		for (size_t b = 0; b < 32; b++)
			if (r->digits[i + k][b] > 9)
				bad |= 1u << k;
	return bad;
}

/* The numbers from i on; returns which of them are bad. */
static inline uint64_t read_group(const struct rows *r, size_t i,
    struct look look, double *v)
{
	uint64_t bad = 0;

	for (size_t k = 0; k < PLAIN_GROUP; k += WIDTH) {
		struct integer m = look.many ? long_integer(r, i + k) :
					       short_integer(r, i + k);
		D p, q;

		memcpy(&p, r->scale + i + k, sizeof p);
		q = divide(&m, p);
		memcpy(v + i + k, &q, sizeof q);
		m.bad |= different(q, q);
		m.bad |= look.others ? not_digits(r, i + k) : 0;
		bad |= (uint64_t)m.bad << k;
	}
	return bad << i;
}

/* All rows are set before the first is read: a vector of what has just been stored
 * in parts would have to be waited for. */
static uint64_t READ(const struct plain_places *at, size_t n,
    double v[PLAIN_BATCH])
{
	struct rows r;
	struct look look[PLAIN_BATCH / PLAIN_GROUP];
	uint64_t bad = 0;

	set_rows(&r, look, (n + PLAIN_GROUP - 1) / PLAIN_GROUP * PLAIN_GROUP,
	    at);
	for (size_t i = 0; i < n; i += PLAIN_GROUP)
		bad |= read_group(&r, i, look[i / PLAIN_GROUP], v);
	return n < PLAIN_BATCH ? bad & ((1ull << n) - 1) : bad;
}

/* Eight at a time: what is beyond the last is overwritten. */
static inline uint16_t *put_places(uint64_t bits, size_t base, uint16_t *at)
{
	size_t n = (size_t)__builtin_popcountll(bits);

	for (size_t i = 0; i < n; i += 8)
		for (size_t k = 0; k < 8; k++) {
			int lowest = __builtin_ctzll(bits | 1ull << 63);

			at[i + k] = (uint16_t)(base + (size_t)lowest);
			bits &= bits - 1;
		}
	return at + n;
}

static size_t FIND(const struct byte_set *set, const char *text, size_t size,
    uint16_t *at)
{
	uint16_t *end = at;
	char rest[64] = { 0 };
	size_t i = 0;

	for (; size - i >= 64; i += 64)
		end = put_places(IN_SET(set, text + i), i, end);
	memcpy(rest, text + i, size - i);
	end = put_places(IN_SET(set, rest) & ((1ull << (size - i)) - 1), i,
	    end);
	return (size_t)(end - at);
}

const struct plain_reader READER = { FIND, READ };
