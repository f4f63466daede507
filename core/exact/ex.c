/* SPDX-License-Identifier: MIT */
#include "ex.h"

#include <limits.h>
#include <stdatomic.h>
#include <string.h>

#include "wide.h"

static const ex one = { 1, 1, 0, { 1 } };

static atomic_bool ex_overflowed;

bool ex_has_overflowed(void)
{
	return atomic_exchange(&ex_overflowed, false);
}

/* Sets *r to sign 2^(64 e) times the integer whose n words are w, the lowest first.
 * Strips words of 0 at both ends, and keeps only the EX_WORDS highest words. */
static void ex_set_words(ex *r, int sign, const uint64_t *w, int n, int e)
{
	while (n > 0 && w[n - 1] == 0)
		n--;
	while (n > 0 && *w == 0) {
		w++;
		e++;
		n--;
	}
	if (n > EX_WORDS) {
		w += n - EX_WORDS;
		e += n - EX_WORDS;
		n = EX_WORDS;
		ex_overflowed = true;
	}
	r->sign = n > 0 ? sign : 0;
	r->n = n;
	r->e = n > 0 ? e : 0;
	for (int i = 0; i < n; i++)
		r->word[i] = w[i];
}

/* Returns e such that the word of weight 2^(64 e) contains the bit of weight 2^bit. */
static int ex_word_index(int bit)
{
	return (bit - (bit & 63)) / 64;
}

void ex_set(ex *r, double a)
{
	uint64_t bits, leading = (uint64_t)1 << 52;

	memcpy(&bits, &a, sizeof bits);
	int e = (int)(bits >> 52 & 0x7ff);
	uint64_t m = bits & (leading - 1);

	/* a subnormal number has no leading bit, and its exponent field 0 means 1 */
	m = e > 0 ? m | leading : m;
	e = (e > 0 ? e : 1) - 1075;
	uint64_t w[2] = { m << (e & 63), m >> 1 >> (63 - (e & 63)) };

	ex_set_words(r, bits >> 63 ? -1 : 1, w, 2, ex_word_index(e));
}

ex ex_of(double a)
{
	ex r;

	ex_set(&r, a);
	return r;
}

static uint64_t word_at(const ex *a, int e)
{
	return e >= a->e && e < a->e + a->n ? a->word[e - a->e] : 0;
}

ex ex_power(int e)
{
	return (ex){ 1, 1, ex_word_index(e), { (uint64_t)1 << (e & 63) } };
}

/* Adds the product a b to sum[0..size), a number in two's complement. The product's
 * lowest word goes to sum[at]; if `at` is negative, words below sum[0] are cut off. If
 * its sign is not `sign`, each word q of the shorter factor is multiplied by -w, where
 * w is the longer factor of n words: -q w = q ~w + q - q 2^(64 n). */
static void add_product(uint64_t *sum, int size, int at, const ex *a, const ex *b,
    int sign)
{
	const ex *shorter = a->n < b->n ? a : b, *longer = shorter == a ? b : a;
	const uint64_t flip = a->sign * b->sign == sign ? 0 : UINT64_MAX;

	for (int i = 0; i < shorter->n; i++, at++) {
		uint64_t q = shorter->word[i], carry = q & flip;
		int j = at < 0 ? -at : 0;

		for (; j < longer->n; j++)
			sum[at + j] = wide_multiply_add(q, longer->word[j] ^ flip,
			    sum[at + j], &carry);
		for (carry -= q & flip; carry != 0 && at + j < size; j++) {
			sum[at + j] += carry;
			carry = (sum[at + j] < carry) + flip;
		}
	}
}

/* Sets sum[0..size) to the magnitude of the sum of the n products a[k] b[k], without
 * the words below the index `low`. Returns how many words it has. *sign, which the sum
 * is expected to have, becomes its sign. */
static int add_products(int n, const ex *const a[], const ex *const b[], int low,
    uint64_t *sum, int size, int *sign)
{
	memset(sum, 0, (size_t)size * sizeof *sum);
	for (int k = 0; k < n; k++)
		add_product(sum, size, a[k]->e + b[k]->e - low, a[k], b[k], *sign);
	if (sum[size - 1] >> 63) {
		uint64_t carry = 1;

		*sign = -*sign;
		for (int i = 0; i < size; i++)
			sum[i] = wide_multiply_add(~sum[i], 1, 0, &carry);
	}
	while (size > 0 && sum[size - 1] == 0)
		size--;
	return size;
}

static int least_of(int a, int b)
{
	return a < b ? a : b;
}

/* The words more than two below the lowest that is kept are not added. Of each of fewer
 * than 2^10 rows less than a unit of the next word is left out: together less than
 * 2^-53 of the lowest word that is kept. If terms cancel, so that lower words are to be
 * kept, the sum begins anew with all words. */
void ex_dot(int n, const ex *const a[], const ex *const b[], int least, ex *r)
{
	uint64_t sum[2 * EX_WORDS + 1];
	int low = INT_MAX, high = INT_MIN, sign = 1;

	least = ex_word_index(least);
	for (int k = 0; k < n; k++) {
		int e = a[k]->e + b[k]->e, end = e + a[k]->n + b[k]->n;

		if (a[k]->n == 0 || b[k]->n == 0)
			continue;
		low = e < low ? e : low;
		sign = end + 1 > high ? a[k]->sign * b[k]->sign : sign;
		high = end + 1 > high ? end + 1 : high;
	}
	if (low > high) {
		r->sign = r->n = r->e = 0;
		return;
	}
	if (high - low > 2 * EX_WORDS) {
		low = high - 2 * EX_WORDS;
		if (low > least)
			ex_overflowed = true;
	}
	/* the highest word of a sum in which nothing cancels is at least high - 3 */
	int from = least_of(least, high - 2 - EX_MIN_WORDS) - 2;

	from = from > low ? from : low;
	int size = add_products(n, a, b, from, sum, high - from, &sign);

	if (from > low && least_of(least, from + size - EX_MIN_WORDS) < from + 2) {
		from = low;
		size = add_products(n, a, b, from, sum, high - from, &sign);
	}
	int dropped = least_of(least, from + size - EX_MIN_WORDS) - from;

	dropped = dropped > 0 ? dropped : 0;
	ex_set_words(r, sign, sum + dropped, size - dropped, from + dropped);
}

void ex_truncate(const ex *a, int n, ex *r)
{
	int dropped = a->n > n ? a->n - n : 0;

	ex_set_words(r, a->sign, a->word + dropped, a->n - dropped, a->e + dropped);
}

/* Returns an upper bound of one word q of the long division of u[0..n] by d[0..n):
 * Knuth, The Art of Computer Programming, volume 2, 4.3.1, algorithm D. The top bit of
 * d is set, and u[n] <= d[n - 1]. The quotient of the highest words alone is at most 2
 * too large (theorem B). It is too large if q d[n - 2] exceeds what q leaves. */
static uint64_t bound_word(const uint64_t *u, const uint64_t *d, int n)
{
	if (u[n] >= d[n - 1])
		return UINT64_MAX;
	uint64_t q = wide_divide(u[n], u[n - 1], d[n - 1]), next = 0;

	wide_multiply_add(q, n > 1 ? d[n - 2] : 0, 0, &next);
	return q - (next > u[n - 1] - q * d[n - 1]);
}

/* Lowers q, which is at most a few too large, to one word of the quotient u / d, and
 * leaves the remainder u - q d in u. If `root`, d is twice a root's first words, and q
 * its next one: d[0] becomes q, so that u is reduced by q (2 root + q). While q is too
 * large, the difference is negative. It is computed with -q d = q ~d
 * + q - q 2^(64 n). */
static uint64_t divide_word(uint64_t *u, uint64_t *d, int n, uint64_t q, bool root)
{
	uint64_t carry = q;

	d[0] = root ? q : d[0];
	for (int i = 0; i < n; i++)
		u[i] = wide_multiply_add(q, ~d[i], u[i], &carry);
	for (u[n] += carry - q; u[n] != 0; q--) {
		carry = root ? q : 0;
		d[0] -= root;
		for (int i = 0; i <= n; i++)
			u[i] = wide_multiply_add(u[i], 1, i < n ? d[i] : 0, &carry);
	}
	return q;
}

/* Returns the 64 bits of |a| of which the lowest has weight 2^e. */
static uint64_t bits_from(const ex *a, int e)
{
	int at = ex_word_index(e), bits = e & 63;

	return word_at(a, at) >> bits | word_at(a, at + 1) << 1 << (63 - bits);
}

/* A quotient by 0 is 2^EXPONENT_BY_ZERO, above all other quotients in a scene. */
enum { EXPONENT_BY_ZERO = 1 << 20 };

bool ex_divide(const ex *a, const ex *b, int count, ex *r)
{
	uint64_t u[EX_WORDS + EX_QUOTIENT_WORDS + 1], d[EX_WORDS],
	    q[EX_QUOTIENT_WORDS + 1];
	int n = b->n + count;

	if (b->n == 0 || a->n == 0) {
		*r = b->n == 0 ? ex_power(EXPONENT_BY_ZERO) : *a;
		return a->n == 0;
	}
	/* the power of two that moves b's leading bit to the top bit of d */
	uint64_t factor = (uint64_t)1 << (64 * (b->e + b->n) - ex_exponent(b)),
		 carry = 0;

	for (int i = 0; i < b->n; i++)
		d[i] = wide_multiply_add(b->word[i], factor, 0, &carry);
	for (int i = 0, k = a->n - n; i < n; i++, k++)
		u[i] = wide_multiply_add(k < 0 ? 0 : a->word[k], factor, 0, &carry);
	u[n] = carry;
	for (int i = count; i >= 0; i--)
		q[i] = divide_word(u + i, d, b->n, bound_word(u + i, d, b->n), false);
	uint64_t rest = a->n > n;

	for (int i = 0; i < b->n; i++)
		rest |= u[i];
	q[0] |= rest != 0;
	ex_set_words(r, a->sign * b->sign, q, count + 1,
	    (a->e + a->n) - count - (b->e + b->n));
	return rest == 0;
}

/* Returns an upper bound of the root of the first two words, high >= 2^60 and low, by a
 * step of Newton's iteration from a root of 50 bits. */
static uint64_t bound_root(uint64_t high, uint64_t low)
{
	uint64_t r = (uint64_t)(sqrt((double)high) * 0x1p32);

	return r / 2 + wide_divide(high, low, r) / 2 + 2;
}

/* The long division by twice the root itself, of which each word becomes a word of the
 * divisor. u is a times 2^shift, whose root has `count` words, the highest from 2^62 to
 * 2^63: so twice the root has its top bit set. */
bool ex_sqrt(const ex *a, int count, ex *r)
{
	uint64_t u[2 * EX_QUOTIENT_WORDS], d[EX_QUOTIENT_WORDS] = { 0 },
					   root[EX_QUOTIENT_WORDS + 1], carry = 0;
	int shift = 128 * count - 2 - ex_exponent(a);

	shift -= shift & 1;
	for (int i = 0; i < 2 * count; i++)
		u[i] = bits_from(a, 64 * i - shift);
	for (int i = count - 1, n = 1; i >= 0; i--, n++) {
		uint64_t *at = u + 2 * i;
		uint64_t q = n == 1 ? bound_root(at[1], at[0]) :
				      bound_word(at, d + i, n);

		root[i] = carry = divide_word(at, d + i, n, q, true);
		for (int k = i; carry != 0; k++) {
			d[k] += carry;
			carry = d[k] < carry;
		}
	}
	uint64_t rest = 64 * a->e + __builtin_ctzll(a->word[0]) < -shift;

	for (int i = 0; i < count; i++)
		rest |= u[i];
	for (int i = 0; i < count; i++)
		root[i] = wide_multiply_add(root[i], (uint64_t)1 << (-(shift / 2) & 63),
		    0, &carry);
	root[count] = carry;
	ex_set_words(r, a->sign, root, count + 1, ex_word_index(-(shift / 2)));
	return rest == 0;
}

/* Returns the weight, as a power of 2, of the last bit to which a is rounded. */
static int last_bit(const ex *a, bool single)
{
	int last = ex_exponent(a) - (single ? 24 : 53), least = single ? -149 : -1074;

	return last < least ? least : last;
}

bool ex_is_near_midpoint(const ex *a, bool single)
{
	/* the bits below the last one: near a midpoint they are nearly 2^63 */
	uint64_t rest = bits_from(a, last_bit(a, single) - 64);

	return rest - ((uint64_t)31 << 58) <= (uint64_t)1 << 59;
}

double ex_nearest(const ex *a, bool single)
{
	if (a->n == 0)
		return 0;
	int last = last_bit(a, single);
	uint64_t m = bits_from(a, last), tie = bits_from(a, last - 1) & 1;
	int lowest = 64 * a->e + __builtin_ctzll(a->word[0]);

	m += tie & ((m & 1) | (lowest < last - 1));
	double r = a->sign * ldexp((double)m, last) + 0.0; /* -0 becomes 0 */

	return single ? (double)(float)r : r;
}

dd ex_round(const ex *a)
{
	dd r = { ex_nearest(a, false), 0 };
	ex rest = ex_of(-r.hi);

	if (isinf(r.hi))
		return r;
	ex_dot(2, (const ex *[]){ a, &rest }, (const ex *[]){ &one, &one }, INT_MIN,
	    &rest);
	r.lo = ex_nearest(&rest, false);
	return r;
}
