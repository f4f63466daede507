#include "exact.h"

#include <string.h>

typedef unsigned __int128 wide;

/* Takes zeros off both ends of w[0..n), which stand for 2^(64 e), and keeps what
 * there is room for. */
static ex trimmed(int sign, const uint64_t *w, int n, int e)
{
	ex r;

	while (n > 0 && w[n - 1] == 0)
		n--;
	if (n > EX_WORDS) {
		w += n - EX_WORDS;
		e += n - EX_WORDS;
		n = EX_WORDS;
	}
	while (n > 0 && *w == 0) {
		w++;
		e++;
		n--;
	}
	r.sign = n > 0 ? sign : 0;
	r.n = n;
	r.e = n > 0 ? e : 0;
	memcpy(r.word, w, (size_t)n * sizeof *w);
	return r;
}

/* m 2^e */
static ex whole(int sign, uint64_t m, int e)
{
	int words = e >= 0 ? e / 64 : -((63 - e) / 64), bits = e - 64 * words;
	uint64_t w[2] = { m << bits, bits > 0 ? m >> (64 - bits) : 0 };

	return trimmed(sign, w, 2, words);
}

ex ex_of(double a)
{
	int e;
	double m = frexp(fabs(a), &e);

	return whole(a < 0 ? -1 : 1, (uint64_t)ldexp(m, 53), e - 53);
}

/* The word of 2^(64 at). */
static uint64_t word_at(const ex *a, int at)
{
	return at >= a->e && at < a->e + a->n ? a->word[at - a->e] : 0;
}

static int top(const ex *a)
{
	return a->e + a->n;
}

static int compare_magnitudes(const ex *a, const ex *b)
{
	int low = a->e < b->e ? a->e : b->e;

	if (a->n == 0 || b->n == 0 || top(a) != top(b))
		return a->n == 0    ? -(b->n > 0) :
		    b->n == 0       ? 1 :
		    top(a) > top(b) ? 1 :
				      -1;
	for (int i = top(a) - 1; i >= low; i--)
		if (word_at(a, i) != word_at(b, i))
			return word_at(a, i) > word_at(b, i) ? 1 : -1;
	return 0;
}

/* a + b for b of a's sign; a - b, for |a| >= |b|, otherwise. */
static ex combine(const ex *a, const ex *b)
{
	uint64_t w[EX_WORDS + 1], carry = 0;
	int low = a->e < b->e ? a->e : b->e;
	int high = top(a) > top(b) ? top(a) : top(b);
	bool minus = a->sign != b->sign;

	if (high - low > EX_WORDS)
		low = high - EX_WORDS;
	for (int i = low; i < high; i++) {
		uint64_t x = word_at(a, i), y = word_at(b, i);
		wide s = minus ? (wide)x - y - carry : (wide)x + y + carry;

		w[i - low] = (uint64_t)s;
		carry = (uint64_t)(s >> 64) & 1;
	}
	w[high - low] = minus ? 0 : carry;
	return trimmed(a->sign, w, high - low + 1, low);
}

ex ex_add(ex a, ex b)
{
	if (a.n == 0)
		return b;
	if (b.n == 0)
		return a;
	return compare_magnitudes(&a, &b) >= 0 ? combine(&a, &b) :
						 combine(&b, &a);
}

ex ex_neg(ex a)
{
	a.sign = -a.sign;
	return a;
}

ex ex_abs(ex a)
{
	a.sign = a.n > 0;
	return a;
}

ex ex_sub(ex a, ex b)
{
	b.sign = -b.sign;
	return ex_add(a, b);
}

ex ex_mul(ex a, ex b)
{
	uint64_t w[2 * EX_WORDS];

	memset(w, 0, (size_t)(a.n + b.n) * sizeof *w);
	for (int i = 0; i < a.n; i++) {
		uint64_t carry = 0;

		for (int j = 0; j < b.n; j++) {
			wide p = (wide)a.word[i] * b.word[j] + w[i + j] + carry;

			w[i + j] = (uint64_t)p;
			carry = (uint64_t)(p >> 64);
		}
		w[i + b.n] = carry;
	}
	return trimmed(a.sign * b.sign, w, a.n + b.n, a.e + b.e);
}

ex ex_scale(ex a, double b)
{
	return ex_mul(a, ex_of(b));
}

ex ex_shift(ex a, int e)
{
	return ex_mul(a, whole(1, 1, e));
}

ex ex_dd(dd a)
{
	return ex_add(ex_of(a.hi), ex_of(a.lo));
}

ex ex_diff(double a, double b)
{
	return ex_sub(ex_of(a), ex_of(b));
}

int ex_sign(ex a)
{
	return a.sign;
}

int ex_compare(ex a, ex b)
{
	if (a.sign != b.sign)
		return a.sign < b.sign ? -1 : 1;
	return a.sign * compare_magnitudes(&a, &b);
}

ex ex_first(ex a, int n)
{
	int rest = a.n > n ? a.n - n : 0;

	return trimmed(a.sign, a.word + rest, a.n - rest, a.e + rest);
}

/* One word of the long division of u[0..n] by d[0..n), whose top bit is set:
 * Knuth, The Art of Computer Programming, volume 2, 4.3.1, algorithm D. u
 * becomes the remainder. */
static uint64_t divide_word(uint64_t *u, const uint64_t *d, int n)
{
	wide first = (wide)u[n] << 64 | u[n - 1];
	wide q = u[n] >= d[n - 1] ? UINT64_MAX : first / d[n - 1];
	wide rest = first - q * d[n - 1];
	uint64_t borrow = 0, carry = 0;

	while (n > 1 && rest >> 64 == 0 &&
	    q * d[n - 2] > (rest << 64 | u[n - 2])) {
		q--;
		rest += d[n - 1];
	}
	for (int i = 0; i <= n; i++) {
		wide p = (i < n ? q * d[i] : 0) + carry;
		wide s = (wide)u[i] - (uint64_t)p - borrow;

		carry = (uint64_t)(p >> 64);
		u[i] = (uint64_t)s;
		borrow = (uint64_t)(s >> 64) & 1;
	}
	if (borrow == 0)
		return (uint64_t)q;
	carry = 0;
	for (int i = 0; i <= n; i++) {
		wide s = (wide)u[i] + (i < n ? d[i] : 0) + carry;

		u[i] = (uint64_t)s;
		carry = (uint64_t)(s >> 64);
	}
	return (uint64_t)q - 1;
}

static int leading_zeros(const ex *a)
{
	return __builtin_clzll(a->word[a->n - 1]);
}

/* Words of a quotient; the first can be 1, so that 5 whole ones are sure. */
enum { QUOTIENT = 6 };

/* An exponent that no quotient of numbers that a scene is made of has. */
enum { BEYOND = 1 << 20 };

ex ex_quotient(ex a, ex b)
{
	uint64_t u[EX_WORDS + QUOTIENT + 1], q[QUOTIENT + 1];
	int sign = a.sign * b.sign, n;

	if (b.n == 0)
		return whole(1, 1, BEYOND);
	if (a.n == 0)
		return a;
	/* so that b's top bit is set, as the division wants it */
	a = ex_shift(a, leading_zeros(&b));
	b = ex_shift(b, leading_zeros(&b));
	n = b.n;
	u[n + QUOTIENT] = 0;
	for (int i = 0; i < n + QUOTIENT; i++)
		u[i] = word_at(&a, top(&a) - n - QUOTIENT + i);
	for (int i = QUOTIENT; i >= 0; i--)
		q[i] = divide_word(u + i, b.word, n);
	return trimmed(sign, q, QUOTIENT + 1, top(&a) - QUOTIENT - top(&b));
}

/* Newton's iteration doubles the 50 digits of a double's root until there are
 * more than are kept; what is beyond these rounds a root of few digits to
 * itself. */
ex ex_sqrt(ex a)
{
	int e;

	if (a.n == 0)
		return a;
	e = 32 * (top(&a) - 1);
	ex m = ex_shift(a, -2 * e), r = ex_of(sqrt(ex_double(m)));

	for (int i = 0; i < 3; i++)
		r = ex_shift(ex_add(r, ex_quotient(m, r)), -1);
	r = ex_add(r, whole(1, 1, 64 * (top(&r) - QUOTIENT) - 1));
	return ex_shift(ex_first(r, QUOTIENT), e);
}

ex ex_settled(ex a, ex size)
{
	ex least = ex_shift(size, -190);

	return compare_magnitudes(&a, &least) > 0 ? a : ex_of(0);
}

/* The 64 bits from 2^e on. */
static uint64_t bits_from(const ex *a, int e)
{
	int at = e >= 0 ? e / 64 : -((63 - e) / 64), bits = e - 64 * at;
	uint64_t low = word_at(a, at), high = word_at(a, at + 1);

	return bits == 0 ? low : low >> bits | high << (64 - bits);
}

/* To so many bits, but none below 2^least. */
static double rounded(const ex *a, int bits, int least)
{
	if (a->n == 0)
		return 0;
	int last = 64 * top(a) - leading_zeros(a) - bits;

	if (last < least)
		last = least;
	if (64 * top(a) < last - 64)
		return 0;
	uint64_t m = bits_from(a, last), half = bits_from(a, last - 1) & 1;
	int lowest = 64 * a->e + __builtin_ctzll(a->word[0]);

	m += half & ((m & 1) | (lowest < last - 1));
	return a->sign * ldexp((double)m, last);
}

double ex_double(ex a)
{
	return rounded(&a, 53, -1074);
}

float ex_float(ex a)
{
	return (float)rounded(&a, 24, -149);
}

dd ex_round(ex a)
{
	double hi = ex_double(a);

	if (isinf(hi))
		return (dd){ hi, 0 };
	return (dd){ hi, ex_double(ex_sub(a, ex_of(hi))) };
}

dd ex_div(ex a, ex b)
{
	return ex_round(ex_quotient(a, b));
}
