/* SPDX-License-Identifier: MIT */
/* Reads plain numbers (loops.h) on one kind of processor. A file that includes this one
 * has the vectors of doubles that core/points/kernel/copy.h describes, and vectors of
 * integers, lanes, that write_body.h describes, and defines:
 *
 *	IN_SET(set, s)	a mask of 64 bytes; bit i is set if s[i] is in the set
 *	join_digits(rows, half, &high, &low)	reads the first (half 0) or last 16
 *			digits of WIDTH rows: 8 digits make high, the next 8 low
 *	MATCH(row, c)	a mask; bit i is set if row[i] is c
 *	LARGER(a, b)	at each place the larger byte of the rows a and b
 *	ANY_TOP_BIT(x)	whether one of 32 bytes has its top bit set
 *
 * A row holds the 32 bytes before the end of a number, for ROW_NUMBERS numbers side by
 * side. A file may define these in place of the definitions in read_rows.h:
 *
 *	ROW_NUMBERS	numbers in a row; needs the types row and row_mask
 *	ROW_BEFORE(end, n) a row: the 32 bytes from end[i] - n on for its number i
 *	LAST_KEYS(n)	a vector of keys for LAST_BYTES, for counts n <= 32
 *	LAST_BYTES(keys) a mask of the last n bytes of each number in a row
 *	PICK(m, a, b), KEEP(m, a)	m ? a : b, and m ? a : 0, for each byte
 *	ANY_ABOVE_9(row) whether a byte of the row is above 9
 *	LEADING_ZEROS(x) the number of leading zero bits, in integers of 32 bits
 *
 * A number has the same bits for any WIDTH: the same operations of IEEE 754 make it. */
#include "read_rows.h"

static inline unsigned different_lanes(V a, V b)
{
	return MASK_BITS(EQUAL(a, b)) ^ ((1u << WIDTH) - 1);
}

/* Returns u < 2^52 as doubles. The bits of u and of 2^52 make the double 2^52 + u. */
static inline V double_of(lanes u)
{
	return (V)(u | 0x4330000000000000) - ALL(0x1p52);
}

/* An integer hi + lo in each lane. Bit i of `bad` is set if lane i is not read. */
struct integer {
	V hi, lo;
	unsigned bad;
};

/* Returns the integers of WIDTH rows, of up to 15 digits. They are below 2^53, so that
 * the product and the sum are exact. */
static inline struct integer short_integer(const struct digit_rows *r, size_t i)
{
	lanes high, low;

	join_digits(r->digits[i], 1, &high, &low);
	return (struct integer){
		.hi = double_of(high) * ALL(1e8) + double_of(low),
		.lo = ALL(0),
	};
}

/* Returns the integers of WIDTH rows, of up to 22 digits; more digits make a lane bad.
 * top is the first six of 22 digits times 10^16. To top are added a, eight digits times
 * 10^8, and b, the last eight digits. top and the sums, s and m.hi, are below 2^74, and
 * rounded: each rounding loses an integer of at most 2^20. m.lo, the sum of the losses,
 * is exact. */
static inline struct integer long_integer(const struct digit_rows *r, size_t i)
{
	struct integer m;
	lanes high, low;

	join_digits(r->digits[i], 0, &high, &low);
	V more = (V)((high > 0) | (low > 999999));

	m.bad = different_lanes(more, ALL(0)); /* all bits set make a nan */
	V first = double_of(low), top = first * ALL(1e16);

	join_digits(r->digits[i], 1, &high, &low);
	V a = double_of(high) * ALL(1e8), b = double_of(low), s = top + a;

	m.hi = s + b;
	m.lo = FMA(first, ALL(1e16), -top) + (a - (s - top)) + (b - (m.hi - s));
	return m;
}

/* Returns m / p rounded to nearest, and adds to m->bad the lanes where this is not
 * certain. q is m->hi / p rounded; the remainder m->hi - q p is exact, as always when
 * nothing underflows. So m / p is q + c for c = (m->hi - q p + m->lo) / p. The computed
 * c has two roundings, an error below 2.01 * 2^-53 |c|; off is 2^-50 c. If q + (c +
 * off) and q + (c - off) are the same double, m / p rounds to it; if not, as midway
 * between doubles, the lane is bad. If all m->lo are 0, q is m / p rounded. */
static inline V divide_rounded(struct integer *m, V p)
{
	V q = m->hi / p;

	if (different_lanes(m->lo, ALL(0)) == 0)
		return q;
	V c = (FMA(-q, p, m->hi) + m->lo) / p, off = c * ALL(0x1p-50);
	V first = q + (c - off), second = q + (c + off);

	m->bad |= different_lanes(first, second);
	return (V)((lanes)first | ((lanes)p & 1ull << 63)); /* restores -0 */
}

static inline unsigned nondigit_lanes(const struct digit_rows *r, size_t i)
{
	unsigned bad = 0;

	for (size_t k = 0; k < WIDTH; k++)
		for (size_t b = 0; b < 32; b++)
			if (r->digits[i + k][b] > 9)
				bad |= 1u << k;
	return bad;
}

/* Reads the group of numbers from i on. Returns a mask of numbers that are not read. */
static inline uint64_t read_group(const struct digit_rows *r, size_t i,
    struct group_needs needs, double *v)
{
	uint64_t bad = 0;

	for (size_t k = i; k < i + PLAIN_GROUP; k += WIDTH) {
		struct integer m = needs.long_integers ? long_integer(r, k) :
							 short_integer(r, k);
		V q = divide_rounded(&m, LOAD(r->divisor + k));

		STORE(v + k, q);
		m.bad |= different_lanes(q, q);
		m.bad |= needs.digit_test ? nondigit_lanes(r, k) : 0;
		bad |= (uint64_t)m.bad << k;
	}
	return bad;
}

/* Reads n plain numbers and, if exponent is not NULL, multiplies number i by
 * 10^exponent[i]. Returns a mask of the numbers that are not read. The exponent changes
 * the divisor; number i is not read if the new divisor is not +-1, 10, ... or 10^22. */
static inline uint64_t read_plain(const struct plain_places *at, size_t n,
    const int8_t *exponent, double v[PLAIN_BATCH])
{
	struct group_needs needs[PLAIN_BATCH / PLAIN_GROUP];
	struct digit_rows r;
	uint64_t bad = 0;

	set_rows(&r, needs, (n + PLAIN_GROUP - 1) / PLAIN_GROUP * PLAIN_GROUP, at);
	for (size_t i = 0; exponent != NULL && i < n; i++) {
		double p = divisors[abs(exponent[i])], d = r.divisor[i];

		d = exponent[i] < 0 ? d * p : d / p;
		r.divisor[i] = fabs(d) >= 1 && fabs(d) <= 1e22 ? d : BAD;
	}
	for (size_t i = 0; i < n; i += PLAIN_GROUP)
		bad |= read_group(&r, i, needs[i / PLAIN_GROUP], v);
	return n < PLAIN_BATCH ? bad & ((1ull << n) - 1) : bad;
}

/* Returns whether the last five of the `size` characters before `end` are a digit, e or
 * E, a sign, and two digits that make at most 22. Sets *exponent. */
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

/* Reads the numbers of the mask `bad` that have an exponent or, if `all` is set, all of
 * its numbers. Returns `bad` without the bits of the numbers that are read. */
static uint64_t read_stripped(const struct plain_places *at, uint64_t bad, bool all,
    double v[PLAIN_BATCH])
{
	struct plain_places places;
	int8_t exponent[PLAIN_BATCH];
	uint8_t index[PLAIN_BATCH];
	double w[PLAIN_BATCH];
	size_t n = 0;

	for (uint64_t rest = bad; rest != 0; rest &= rest - 1) {
		int i = __builtin_ctzll(rest);
		bool found = get_exponent(at->end[i], at->size[i], &exponent[n]);

		if (!found && !all)
			continue;
		if (!found)
			exponent[n] = 0;
		places.end[n] = at->end[i] - 4 * found;
		places.size[n] = (uint8_t)(at->size[i] - 4 * found);
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

/* Looks for exponents at once if the first number has one, as others
 * then have one, too. */
static uint64_t loops_read(const struct plain_places *at, size_t n,
    double v[PLAIN_BATCH])
{
	int8_t exponent;

	if (n > 0 && get_exponent(at->end[0], at->size[0], &exponent))
		return read_stripped(at, ~0ull >> (PLAIN_BATCH - n), true, v);
	uint64_t bad = read_plain(at, n, NULL, v);

	return bad == 0 ? 0 : read_stripped(at, bad, false, v);
}

/* Writes base + i to `at` for each bit i that is set in `bits`, and returns the end of
 * these numbers. Up to seven other numbers follow; the next call overwrites them. */
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

/* Returns a mask of the 64 bytes at s that are in the set, without spaces that follow
 * two others in the mask. */
static inline uint64_t find_64(const struct byte_set *set, const char *s)
{
	uint64_t found = IN_SET(set, s), spaces = 0;

	if ((found & found << 1 & found << 2) == 0)
		return found;
	for (size_t k = 0; k < 64; k += sizeof(row)) {
		row x;

		memcpy(&x, s + k, sizeof x);
		spaces |= (uint64_t)MATCH(x, ' ') << k;
	}
	return found & ~(spaces & spaces << 1 & spaces << 2);
}

static size_t loops_find(const struct byte_set *set, const char *text, size_t size,
    uint16_t *at)
{
	uint16_t *end = at;
	char rest[64] = { 0 };
	size_t i = 0;

	for (; size - i >= 64; i += 64)
		end = put_places(find_64(set, text + i), i, end);
	memcpy(rest, text + i, size - i);
	end = put_places(find_64(set, rest) & ((1ull << (size - i)) - 1), i, end);
	return (size_t)(end - at);
}
