/* SPDX-License-Identifier: MIT */
#include "exact.h"

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

/* Sets *r to sign w[0..n) 2^(64 e) without zeros at either end. Only the EX_WORDS
 * highest words are kept. */
static void ex_put(ex *r, int sign, const uint64_t *w, int n, int e)
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

/* Returns e such that the word of weight 2^(64 e) has the bit of weight 2^bit. */
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

	/* a subnormal number has no leading bit; its exponent is that of the least
	 * normal number */
	m = e > 0 ? m | leading : m;
	e = (e > 0 ? e : 1) - 1075;
	uint64_t w[2] = { m << (e & 63), m >> 1 >> (63 - (e & 63)) };

	ex_put(r, bits >> 63 ? -1 : 1, w, 2, ex_word_index(e));
}

ex ex_of(double a)
{
	ex r;

	ex_set(&r, a);
	return r;
}

/* Returns the word of weight 2^(64 at). */
static uint64_t word_at(const ex *a, int at)
{
	return at >= a->e && at < a->e + a->n ? a->word[at - a->e] : 0;
}

ex ex_power(int e)
{
	return (ex){ 1, 1, ex_word_index(e), { (uint64_t)1 << (e & 63) } };
}

/* Adds a b to sum, a number of size words in two's complement. The lowest word of a b
 * belongs to sum[at]; words that belong before sum[0] are cut off. A negative product
 * is added as -q w = q ~w + q - q 2^(64 n), for each word q of one factor and the n
 * words w of the other. */
static void add_product(uint64_t *sum, int size, int at, const ex *a,
    const ex *b)
{
	const ex *few = a->n < b->n ? a : b, *many = few == a ? b : a;
	const uint64_t flip = a->sign == b->sign ? 0 : UINT64_MAX;

	for (int i = 0; i < few->n; i++, at++) {
		uint64_t q = few->word[i], carry = q & flip;
		int j = at < 0 ? -at : 0;

		for (; j < many->n; j++)
			sum[at + j] = multiply_add(q, many->word[j] ^ flip,
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
	for (int i = 0; i < high - low; i++)
		sum[i] = 0;
	for (int k = 0; k < n; k++)
		if (a[k]->n > 0 && b[k]->n > 0)
			add_product(sum, high - low, a[k]->e + b[k]->e - low,
			    a[k], b[k]);
	bool minus = sum[high - low - 1] >> 63;
	uint64_t carry = minus;

	for (int i = 0; i < high - low && minus; i++)
		sum[i] = multiply_add(~sum[i], 1, 0, &carry);
	while (high > low && sum[high - low - 1] == 0)
		high--;
	int rest = high - low - EX_MIN_WORDS;

	rest = rest < 0 || least <= low ? 0 :
	    least - low < rest          ? least - low :
					  rest;
	ex_put(r, minus ? -1 : 1, sum + rest, high - low - rest, low + rest);
}

ex ex_truncate(ex a, int n)
{
	int rest = a.n > n ? a.n - n : 0;
	ex r;

	ex_put(&r, a.sign, a.word + rest, a.n - rest, a.e + rest);
	return r;
}

/* Returns one word of the long division of u[0..n] by d[0..n), and leaves the remainder
 * in u: Knuth, The Art of Computer Programming, volume 2, 4.3.1, algorithm D. The top
 * bit of d is set, and u[n] <= d[n - 1]. The quotient of the highest words is at most 2
 * too large (theorem B there); while it is too large, u is negative. q d is subtracted
 * by -q d = q ~d + q - q 2^(64 n). */
static uint64_t divide_word(uint64_t *u, const uint64_t *d, int n)
{
	uint64_t q = UINT64_MAX;

	if (u[n] < d[n - 1])
		q = divide_two(u[n], u[n - 1], d[n - 1]);
	uint64_t carry = q;

	for (int i = 0; i < n; i++)
		u[i] = multiply_add(q, ~d[i], u[i], &carry);
	for (u[n] += carry - q; u[n] != 0; q--) {
		carry = 0;
		for (int i = 0; i <= n; i++)
			u[i] = multiply_add(u[i], 1, i < n ? d[i] : 0, &carry);
	}
	return q;
}

/* Returns the 64 bits of |a| from 2^e upwards. */
static uint64_t bits_from(const ex *a, int e)
{
	int at = ex_word_index(e), bits = e & 63;

	return word_at(a, at) >> bits | word_at(a, at + 1) << 1 << (63 - bits);
}

/* The exponent of a quotient by 0, above the exponents of all quotients in a scene. */
enum { BEYOND = 1 << 20 };

bool ex_divide(const ex *a, const ex *b, int words, ex *r)
{
	uint64_t u[EX_WORDS + EX_QUOTIENT + 1], d[EX_WORDS], q[EX_QUOTIENT + 1];
	int n = b->n + words;

	if (b->n == 0 || a->n == 0) {
		*r = b->n == 0 ? ex_power(BEYOND) : *a;
		return a->n == 0;
	}
	/* the factor that sets the top bit of d */
	uint64_t by = (uint64_t)1 << (64 * (b->e + b->n) - ex_size(b)),
		 carry = 0;

	for (int i = 0; i < b->n; i++)
		d[i] = multiply_add(b->word[i], by, 0, &carry);
	for (int i = 0, k = a->n - n; i < n; i++, k++)
		u[i] = multiply_add(k < 0 ? 0 : a->word[k], by, 0, &carry);
	u[n] = carry;
	for (int i = words; i >= 0; i--)
		q[i] = divide_word(u + i, d, b->n);
	uint64_t rest = a->n > n;

	for (int i = 0; i < b->n; i++)
		rest |= u[i];
	q[0] |= rest != 0;
	ex_put(r, a->sign * b->sign, q, words + 1,
	    (a->e + a->n) - words - (b->e + b->n));
	return rest == 0;
}

/* Newton's iteration begins with the root of a double, which has 50 correct bits. Each
 * step doubles the correct bits, so the quotients of the steps need 2, 4, 8, and at
 * last EX_QUOTIENT words. The result is rounded to EX_QUOTIENT words; so short roots
 * are exact. */
ex ex_sqrt(ex a)
{
	int up = a.e + a.n - 1;

	if (a.n == 0)
		return a;
	a.e -= up;
	ex q, r = ex_of(sqrt(ex_nearest(&a, false)));
	const ex *const pair[] = { &r, &q };

	for (int words = 2; words < 2 * EX_QUOTIENT; words *= 2) {
		ex_divide(&a, &r, words < EX_QUOTIENT ? words : EX_QUOTIENT,
		    &q);
		ex_dot(2, pair, (const ex *[]){ &half, &half }, INT_MIN, &r);
	}
	q = ex_power(64 * (r.e + r.n - EX_QUOTIENT) - 1);
	ex_dot(2, pair, (const ex *[]){ &one, &one }, INT_MIN, &r);
	r = ex_truncate(r, EX_QUOTIENT);
	q = ex_power(32 * up);
	ex_dot(1, pair, pair + 1, INT_MIN, &r);
	return r;
}

double ex_nearest(const ex *a, bool single)
{
	int last = ex_size(a) - (single ? 24 : 53),
	    least = single ? -149 : -1074;

	if (a->n == 0)
		return 0;
	last = last < least ? least : last;
	uint64_t m = bits_from(a, last), tie = bits_from(a, last - 1) & 1;
	int lowest = 64 * a->e + __builtin_ctzll(a->word[0]);

	m += tie & ((m & 1) | (lowest < last - 1));
	double r = a->sign * ldexp((double)m, last) + 0.0; /* -0 is 0 */

	return single ? (double)(float)r : r;
}

dd ex_round(const ex *a)
{
	dd r = { ex_nearest(a, false), 0 };
	ex rest = ex_of(-r.hi);

	if (isinf(r.hi))
		return r;
	ex_dot(2, (const ex *[]){ a, &rest }, (const ex *[]){ &one, &one },
	    INT_MIN, &rest);
	r.lo = ex_nearest(&rest, false);
	return r;
}
