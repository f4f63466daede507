/* SPDX-License-Identifier: MIT */
#include "ex.h"

#include <limits.h>
#include <stdatomic.h>
#include <string.h>

#include "wide.h"

static const ex one = { 1, 1, 0, { 1 } };
static const ex half = { 1, 1, -1, { (uint64_t)1 << 63 } };

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
 * the product is negative, each word q of the shorter factor is multiplied by -w, where
 * w is the longer factor of n words: -q w = q ~w + q - q 2^(64 n). */
static void add_product(uint64_t *sum, int size, int at, const ex *a, const ex *b)
{
	const ex *shorter = a->n < b->n ? a : b, *longer = shorter == a ? b : a;
	const uint64_t flip = a->sign == b->sign ? 0 : UINT64_MAX;

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

void ex_dot(int n, const ex *const a[], const ex *const b[], int least, ex *r)
{
	uint64_t sum[2 * EX_WORDS + 1];
	int low = INT_MAX, high = INT_MIN;

	least = ex_word_index(least);
	for (int k = 0; k < n; k++) {
		int e = a[k]->e + b[k]->e, end = e + a[k]->n + b[k]->n;

		if (a[k]->n == 0 || b[k]->n == 0)
			continue;
		low = e < low ? e : low;
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
	memset(sum, 0, (size_t)(high - low) * sizeof *sum);
	for (int k = 0; k < n; k++)
		add_product(sum, high - low, a[k]->e + b[k]->e - low, a[k], b[k]);
	bool minus = sum[high - low - 1] >> 63;
	uint64_t carry = minus;

	for (int i = 0; i < high - low && minus; i++)
		sum[i] = wide_multiply_add(~sum[i], 1, 0, &carry);
	while (high > low && sum[high - low - 1] == 0)
		high--;
	int lowest = least < high - EX_MIN_WORDS ? least : high - EX_MIN_WORDS;

	lowest = lowest > low ? lowest : low;
	ex_set_words(r, minus ? -1 : 1, sum + (lowest - low), high - lowest, lowest);
}

void ex_truncate(const ex *a, int n, ex *r)
{
	int dropped = a->n > n ? a->n - n : 0;

	ex_set_words(r, a->sign, a->word + dropped, a->n - dropped, a->e + dropped);
}

/* Returns one word q of the long division of u[0..n] by d[0..n), and leaves the
 * remainder u - q d in u: Knuth, The Art of Computer Programming, volume 2, 4.3.1,
 * algorithm D. The top bit of d is set, and u[n] <= d[n - 1]. The first q, a quotient
 * of the highest words alone, is at most 2 too large (theorem B). While q is too large,
 * u - q d is negative. The difference is computed with -q d = q ~d + q - q 2^(64 n). */
static uint64_t divide_word(uint64_t *u, const uint64_t *d, int n)
{
	uint64_t q = UINT64_MAX;

	if (u[n] < d[n - 1])
		q = wide_divide(u[n], u[n - 1], d[n - 1]);
	uint64_t carry = q;

	for (int i = 0; i < n; i++)
		u[i] = wide_multiply_add(q, ~d[i], u[i], &carry);
	for (u[n] += carry - q; u[n] != 0; q--) {
		carry = 0;
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
		q[i] = divide_word(u + i, d, b->n);
	uint64_t rest = a->n > n;

	for (int i = 0; i < b->n; i++)
		rest |= u[i];
	q[0] |= rest != 0;
	ex_set_words(r, a->sign * b->sign, q, count + 1,
	    (a->e + a->n) - count - (b->e + b->n));
	return rest == 0;
}

/* Newton's iteration begins at the root of the nearest double, with 50 correct bits.
 * Each step doubles their number, so that its quotient needs 2, 4, 8, and then
 * EX_QUOTIENT_WORDS words, to which the result is rounded: roots of few words are
 * exact. */
ex ex_sqrt(const ex *square)
{
	ex a = *square;
	int top = a.e + a.n - 1;

	if (a.n == 0)
		return a;
	a.e -= top;
	ex q, r = ex_of(sqrt(ex_nearest(&a, false)));
	const ex *const pair[] = { &r, &q };

	for (int words = 2; words < 2 * EX_QUOTIENT_WORDS; words *= 2) {
		ex_divide(&a, &r, words < EX_QUOTIENT_WORDS ? words : EX_QUOTIENT_WORDS,
		    &q);
		ex_dot(2, pair, (const ex *[]){ &half, &half }, INT_MIN, &r);
	}
	q = ex_power(64 * (r.e + r.n - EX_QUOTIENT_WORDS) - 1);
	ex_dot(2, pair, (const ex *[]){ &one, &one }, INT_MIN, &r);
	ex_truncate(&r, EX_QUOTIENT_WORDS, &r);
	q = ex_power(32 * top);
	ex_dot(1, pair, pair + 1, INT_MIN, &r);
	return r;
}

double ex_nearest(const ex *a, bool single)
{
	int last = ex_exponent(a) - (single ? 24 : 53), least = single ? -149 : -1074;

	if (a->n == 0)
		return 0;
	last = last < least ? least : last;
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
