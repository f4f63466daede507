/* SPDX-License-Identifier: MIT */
/* The reader of plain numbers for one kind of processor. A file that includes this
 * has the vectors of doubles of core/points/kernel/copy.h, the integers I that
 * write_body.h describes, and defines:
 *
 *	IN_SET(set, s)	bit i: s[i] is in the set, of 64 bytes
 *	join_digits(rows, half, &high, &low)
 *			sets high to the integers that the first eight digits make
 *			of half 0 or 1 of WIDTH rows, low to those of the last eight
 *	WHERE(row, c)	bit i: row[i] is c
 *	LARGER(a, b)	the larger one of each two bytes of rows
 *	ANY_TOP_BIT(x)	the top bit of some byte of 32 is set
 *
 * A row holds the 32 bytes before the end of a number, for ROW_NUMBERS numbers side by
 * side. A file may define, in the place of the operations of read_rows.h,
 *
 *	ROW_NUMBERS, row, row_mask, ROW_BEFORE(end, n)
 *			the bytes from end[i] - n on
 *	LAST_KEYS(n)	a key for LAST_BYTES from each of a vector of counts up to 32
 *	LAST_BYTES(keys)	a mask of the last bytes of a row: as many as the count
 *	PICK(m, a, b)	m ? a : b
 *	KEEP(m, a)	m ? a : 0
 *	ANY_ABOVE_9(row)	some byte is above 9
 *	LEADING_ZEROS(x)	of integers of 32 bits
 *
 * Whatever the width, every lane goes through the same operations of IEEE 754. */
#include "read_rows.h"

/* Returns bit i if lane i of a and b differs. A nan differs from everything. */
static inline unsigned different_lanes(V a, V b)
{
	return LANES_OF(EQUAL(a, b)) ^ ((1u << WIDTH) - 1);
}

/* Returns integers below 2^52 as doubles. The double with the bits of 2^52 and of the
 * integer is 2^52 larger. */
static inline V double_of(I u)
{
	return (V)(u | ALL_BITS(0x4330000000000000)) - ALL(0x1p52);
}

/* An integer hi + lo in each lane, and a bit for each lane that is not read. */
struct integer {
	V hi, lo;
	unsigned bad;
};

/* Returns integers of up to 15 digits, as many as doubles hold: the product and the
 * sum are exact. */
static inline struct integer short_integer(const struct digit_rows *r, size_t i)
{
	I high, low;

	join_digits(r->digits[i], 1, &high, &low);
	return (struct integer){
		.hi = double_of(high) * ALL(1e8) + double_of(low),
		.lo = ALL(0),
	};
}

/* Returns integers of up to 19 digits; one with more is bad. Three digits times 10^16
 * are a multiple of 2^16 below 2^64: exact. The sums s and hi, below 2^64, are rounded
 * to multiples of 2^11. Each rounding loses an integer of at most 2^10; lo, the sum of
 * these two integers, is exact. */
static inline struct integer long_integer(const struct digit_rows *r, size_t i)
{
	struct integer m;
	I high, low;

	join_digits(r->digits[i], 0, &high, &low);
	V more = (V)((high > ALL_BITS(0)) | (low > ALL_BITS(999)));

	m.bad = different_lanes(more, ALL(0)); /* all bits set are a nan */
	V top = double_of(low) * ALL(1e16);

	join_digits(r->digits[i], 1, &high, &low);
	V a = double_of(high) * ALL(1e8), b = double_of(low), s = top + a;

	m.hi = s + b;
	m.lo = (a - (s - top)) + (b - (m.hi - s));
	return m;
}

/* Returns m / p rounded to nearest, and adds to m->bad the lanes of which this is not
 * sure. The quotient q of hi and p is rounded; the remainder hi - q p is exact, as
 * always when division rounds to nearest and nothing underflows. So m / p is q + c for
 * c = (hi - q p + lo) / p, which costs two roundings: an error below 2.01 * 2^-53 |c|.
 * The sums c + off and c - off are farther from c: 2^-50 |c| less 2^-53 |c| for their
 * own rounding. Rounding is monotone: if q + (c + off) and q + (c - off) are the same
 * double, m / p rounds to it; else, as when m / p lies midway, the number is bad. Where
 * all of lo is 0, q is Clinger's exact case. */
static inline V divide(struct integer *m, V p)
{
	V q = m->hi / p;

	if (different_lanes(m->lo, ALL(0)) == 0)
		return q;
	V c = (FMA(-q, p, m->hi) + m->lo) / p, off = c * ALL(0x1p-50);
	V first = q + (c - off), second = q + (c + off);

	m->bad |= different_lanes(first, second);
	return (V)((I)first | ((I)p & ALL_BITS(1ull << 63))); /* -0 + 0 is 0 */
}

/* Returns bit k if row i + k has a byte above 9. */
static inline unsigned lanes_with_others(const struct digit_rows *r, size_t i)
{
	unsigned bad = 0;

	for (size_t k = 0; k < WIDTH; k++)
		for (size_t b = 0; b < 32; b++)
			if (r->digits[i + k][b] > 9)
				bad |= 1u << k;
	return bad;
}

/* Reads the group of numbers from i on; returns bit k if number k is not read. */
static inline uint64_t read_group(const struct digit_rows *r, size_t i,
    struct group_needs needs, double *v)
{
	uint64_t bad = 0;

	for (size_t k = i; k < i + PLAIN_GROUP; k += WIDTH) {
		struct integer m = needs.long_integers ? long_integer(r, k) :
							 short_integer(r, k);
		V q = divide(&m, LOAD(r->divisor + k));

		STORE(v + k, q);
		m.bad |= different_lanes(q, q);
		m.bad |= needs.digit_test ? lanes_with_others(r, k) : 0;
		bad |= (uint64_t)m.bad << k;
	}
	return bad;
}

/* Reads n plain numbers, and if exponent is not NULL multiplies number i by
 * 10^exponent[i]. Returns bit i if number i is not read. The exponent changes the
 * divisor to another power of ten; if this is no double, the number is not read. */
static inline uint64_t read_plain(const struct plain_places *at, size_t n,
    const int8_t *exponent, double v[PLAIN_BATCH])
{
	struct group_needs needs[PLAIN_BATCH / PLAIN_GROUP];
	struct digit_rows r;
	uint64_t bad = 0;

	set_rows(&r, needs, (n + PLAIN_GROUP - 1) / PLAIN_GROUP * PLAIN_GROUP,
	    at);
	for (size_t i = 0; exponent != NULL && i < n; i++) {
		double p = divisors[abs(exponent[i])], d = r.divisor[i];

		d = exponent[i] < 0 ? d * p : d / p;
		r.divisor[i] = fabs(d) >= 1 && fabs(d) <= 1e22 ? d : NO;
	}
	for (size_t i = 0; i < n; i += PLAIN_GROUP)
		bad |= read_group(&r, i, needs[i / PLAIN_GROUP], v);
	return n < PLAIN_BATCH ? bad & ((1ull << n) - 1) : bad;
}

/* Returns whether the size characters before the end are at least a digit and then an
 * exponent of a sign and two digits, up to 22; sets *exponent. */
static inline bool get_exponent(const char *end, size_t size, int8_t *exponent)
{
	unsigned tens = (unsigned char)end[-2] - '0';
	unsigned ones = (unsigned char)end[-1] - '0';
	int e = (int)(10 * tens + ones);

	*exponent = (int8_t)(end[-3] == '-' ? -e : e);
	return size >= 5 && tens < 10 && ones < 10 && e < POWER_END &&
	    (end[-3] == '-' || end[-3] == '+') && (end[-4] | 32) == 'e' &&
	    end[-5] >= '0' && end[-5] <= '9';
}

/* Reads the numbers of bad, as bits, that have an exponent. Returns the bits of those
 * that are still not read. */
static uint64_t read_exponential(const struct plain_places *at, uint64_t bad,
    double v[PLAIN_BATCH])
{
	struct plain_places places;
	int8_t exponent[PLAIN_BATCH];
	uint8_t index[PLAIN_BATCH];
	double w[PLAIN_BATCH];
	size_t n = 0;

	for (uint64_t rest = bad; rest != 0; rest &= rest - 1) {
		int i = __builtin_ctzll(rest);

		if (!get_exponent(at->end[i], at->size[i], &exponent[n]))
			continue;
		places.end[n] = at->end[i] - 4;
		places.size[n] = (uint8_t)(at->size[i] - 4);
		index[n++] = (uint8_t)i;
	}
	for (size_t k = n; k % PLAIN_GROUP != 0; k++) {
		places.end[k] = places.end[0];
		places.size[k] = places.size[0];
	}
	uint64_t unread = n > 0 ? read_plain(&places, n, exponent, w) : 0;

	for (size_t k = 0; k < n; k++)
		if ((unread >> k & 1) == 0) {
			v[index[k]] = w[k];
			bad &= ~(1ull << index[k]);
		}
	return bad;
}

static uint64_t reader_read(const struct plain_places *at, size_t n,
    double v[PLAIN_BATCH])
{
	uint64_t bad = read_plain(at, n, NULL, v);

	return bad == 0 ? 0 : read_exponential(at, bad, v);
}

/* Writes base plus the place of each bit that is set, eight places at a time. Returns
 * the end of the last; the next call overwrites the places after it. */
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

static size_t reader_find(const struct byte_set *set, const char *text,
    size_t size, uint16_t *at)
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
