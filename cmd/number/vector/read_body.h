/* The reader of plain numbers for one kind of processor. A file that includes
 * this defines:
 *
 *	READER		the name of its struct plain_reader
 *	LANES		how many doubles a vector D of them holds
 *	IN_SET(set, s)	bit i: whether s[i] is in the set, of 64 bytes
 *	DOTS(row)	bit i: whether row[i] is a point, of 32 bytes
 *	EIGHTS(rows, high, low)
 *			of LANES rows of 16 digits each, the integers that the
 *			first and the last eight are, in lanes of 64 bits
 *	ANY_TOP_BIT(row)	whether the top bit of any byte is set
 *	NEGATED_FMA(a, b, c)	c - a b, rounded once
 *	DIFFERENT(a, b)	bit i: whether a and b differ in lane i, as nan does
 *
 * All else is arithmetic of the compiler's vectors. Whatever the width, every
 * lane goes through the same operations of IEEE 754. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "../plain.h"

typedef uint8_t row __attribute__((vector_size(32)));
typedef uint64_t U __attribute__((vector_size(LANES * 8)));
typedef int64_t I __attribute__((vector_size(LANES * 8)));
typedef double D __attribute__((vector_size(LANES * 8)));

/* Digits, right-aligned, the last 16 of them in low, and what the number that they
 * make is divided by. */
struct rows {
	uint8_t low[PLAIN_BATCH][16], high[PLAIN_BATCH][16];
	double scale[PLAIN_BATCH];
};

static inline row row_at(const void *p)
{
	row r;

	memcpy(&r, p, sizeof r);
	return r;
}

#define EIGHT 255, 255, 255, 255, 255, 255, 255, 255
static const uint8_t window[64] = { [32] = EIGHT, EIGHT, EIGHT, EIGHT };

/* The last n <= 32 bytes set. */
static inline row last(size_t n)
{
	return row_at(window + n);
}

/* By sign and decimals. Powers up to 10^22 are doubles. With more decimals, or
 * without digits, a number is not for this reader; 32 stands for no point. */
enum { NO_POINT = 32, UNREAD = 23 };
#define NO (double)NAN
static const double power[2][NO_POINT + 1] = {
	{ 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12,
	    1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22, NO, NO,
	    NO, NO, NO, NO, NO, NO, NO, 1e0 },
	{ -1e0, -1e1, -1e2, -1e3, -1e4, -1e5, -1e6, -1e7, -1e8, -1e9, -1e10,
	    -1e11, -1e12, -1e13, -1e14, -1e15, -1e16, -1e17, -1e18, -1e19,
	    -1e20, -1e21, -1e22, NO, NO, NO, NO, NO, NO, NO, NO, NO, -1e0 },
};

/* Loads what stands before end twice, one byte apart: the decimals of the first
 * and the whole digits of the second are side by side, without the point. What
 * is no digit shows as a byte above 9. Returns the digits. */
static inline row set_row(struct rows *r, size_t i, const char *end, size_t n,
    size_t *digits)
{
	row x = row_at(end - 32), before = row_at(end - 33);
	uint64_t dots = DOTS(x) & (uint32_t)(0xffffffff00000000 >> n);
	size_t decimals = (size_t)__builtin_clzll(dots << 32 | 0x80000000);
	size_t minus = end[-(ptrdiff_t)n] == '-';
	row fraction = last(decimals);

	*digits = n - minus - (dots != 0);
	x = ((x & fraction) | (before & ~fraction)) - '0';
	x &= last(*digits);
	memcpy(r->high[i], &x, 16);
	memcpy(r->low[i], (const uint8_t *)&x + 16, 16);
	r->scale[i] = power[minus][*digits == 0 ? UNREAD : decimals];
	return x;
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

/* Of up to 15 digits. The product of an integer below 10^8 and 10^8 is below 2^54 and
 * a multiple of 2^8: exact. It is 0 or larger than the rest, so that lo is
 * exactly what the sum lost. */
static inline struct integer short_integer(const struct rows *r, size_t i)
{
	struct integer m = { 0 };
	U first, rest;

	EIGHTS(r->low[i], first, rest);
	D a = double_of(first) * 1e8, b = double_of(rest);

	m.hi = a + b;
	m.lo = b - (m.hi - a);
	return m;
}

/* Of up to 19 digits; with more, the integer is bad. Three digits times 10^16
 * are a multiple of 2^16 below 2^64: exact. The sums lose integers of at most
 * 2^10 each, as what is below 2^64 is rounded to multiples of 2^11; these two
 * are exactly added. */
static inline struct integer long_integer(const struct rows *r, size_t i)
{
	struct integer m = { 0 };
	U first, rest;

	EIGHTS(r->high[i], first, rest);
	I more = ((I)first > 0) | ((I)rest > 999);

	m.bad = DIFFERENT((D)more, (D){ 0 }); /* all bits set are a nan */
	D top = double_of(rest) * 1e16;

	EIGHTS(r->low[i], first, rest);
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

	if (DIFFERENT(m->lo, (D){ 0 }) == 0)
		return q;
	D c = (NEGATED_FMA(q, p, m->hi) + m->lo) / p, off = c * 0x1p-50;
	D one = q + (c - off), other = q + (c + off);

	m->bad |= DIFFERENT(one, other);
	return (D)((U)one | ((U)p & 1ull << 63)); /* -0 + 0 is 0 */
}

/* Which of the rows from i on have a byte above 9. */
static inline unsigned not_digits(const struct rows *r, size_t i)
{
	unsigned bad = 0;

	for (size_t k = 0; k < LANES; k++)
		for (size_t b = 0; b < 16; b++)
			if (r->low[i + k][b] > 9 || r->high[i + k][b] > 9)
				bad |= 1u << k;
	return bad;
}

/* Numbers in one go: a whole number of vectors. */
enum { GROUP = 8 };

/* Of the numbers of a group. */
struct look {
	bool others;   /* some of their digits are none */
	size_t digits; /* their counts, or'ed */
};

static inline struct look set_group(struct rows *r, size_t i, size_t n,
    const struct plain_places *at)
{
	struct look look = { false, 0 };
	row odd = { 0 };

	for (size_t end = i + GROUP; i < end; i++) {
		size_t k = i < n ? i : n - 1, digits;
		row x = set_row(r, i, at->end[k], at->size[k], &digits);

		odd |= x | (x + (128 - 10));
		look.digits |= digits;
	}
	look.others = ANY_TOP_BIT(odd);
	return look;
}

/* The numbers from i on; returns which of them are bad. */
static inline uint64_t read_group(const struct rows *r, size_t i,
    struct look look, double *v)
{
	uint64_t bad = 0;

	for (size_t k = 0; k < GROUP; k += LANES) {
		struct integer m = look.digits < 16 ? short_integer(r, i + k) :
						      long_integer(r, i + k);
		D p, q;

		memcpy(&p, r->scale + i + k, sizeof p);
		q = divide(&m, p);
		memcpy(v + i + k, &q, sizeof q);
		m.bad |= DIFFERENT(q, q);
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
	struct look look[PLAIN_BATCH / GROUP];
	uint64_t bad = 0;

	for (size_t i = 0; i < n; i += GROUP)
		look[i / GROUP] = set_group(&r, i, n, at);
	for (size_t i = 0; i < n; i += GROUP)
		bad |= read_group(&r, i, look[i / GROUP], v);
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
