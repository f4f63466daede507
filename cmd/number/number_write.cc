// SPDX-License-Identifier: MIT
/* Nanoseconds a number, %.6f coordinates / 17 digits (cmd/bench/number.cc, gcc
 * 12, a Xeon with AVX-512): printf %.17g 328 / 194, charconv 46 / 40, dragonbox
 * without its digits 15 / 10, here 23 / 20, several at a time (vector/) 6; 3
 * decimals: charconv 50, here 15. The library is headers only, and printf does what
 * is rare: no C++ library is loaded, which would double the 0.6 ms of a start. */
#include "number.h"

/* The library's assertions are for its own tests, and cost time. */
#undef NDEBUG
#define NDEBUG

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dragonbox/dragonbox.h>

#include "../../core/exact/wide.h"

/* The most that the shortest text of a double needs. The fast ways write as
 * many to a buffer, and copy from it those that belong to the number. */
enum { DIGITS = 17 };

static const uint64_t power[] = { 1, 10, 100, 1000, 10000, 100000, 1000000,
	10000000, 100000000, 1000000000, 10000000000, 100000000000,
	1000000000000, 10000000000000, 100000000000000, 1000000000000000,
	10000000000000000, 100000000000000000 };

/* The text of 0 to 999: three digits at a time take a seventh less time than
 * two. */
struct triples {
	char text[1000][4];

	constexpr triples() : text()
	{
		for (int i = 0; i < 1000; i++) {
			text[i][0] = char('0' + i / 100);
			text[i][1] = char('0' + i / 10 % 10);
			text[i][2] = char('0' + i % 10);
		}
	}
};

static constexpr triples triple;

/* Writes the first three decimals of p, a number with 54 bits after its point.
 * Returns p times 1000, without the digits before those. */
static inline uint64_t write_three(char *s, uint64_t p)
{
	p = (p & ((1ull << 54) - 1)) * 1000;
	memcpy(s, triple.text[p >> 54], 4);
	return p;
}

/* Of high 2^64 + low, shifted right by k from 1 to 127, the lower word. */
static inline uint64_t shifted(uint64_t high, uint64_t low, int k)
{
	return k < 64 ? high << (64 - k) | low >> k : high >> (k - 64);
}

/* Writes the 17 digits of x < 10^17, and after them zeros for plain() to copy.
 * p is x / 10^15 with 54 bits after the point: computed with the reciprocal
 * 2^113 / 10^15 and rounded up, it is less than 1.2 * 2^-54 too large. The five
 * steps to the last digit multiply that by 10^15, to less than 1. */
static inline void write_digits(char d[64], uint64_t x)
{
	const uint64_t reciprocal = 10384593717069655258u;
	uint64_t high = 0, low = multiply_add(x, reciprocal, 0, &high);
	uint64_t p = shifted(high, low, 59) + 1;

	memcpy(d, triple.text[p >> 54] + 1, 2);
	p = write_three(d + 2, p);
	p = write_three(d + 5, p);
	p = write_three(d + 8, p);
	p = write_three(d + 11, p);
	write_three(d + 14, p);
	memset(d + DIGITS, '0', 64 - DIGITS);
}

/* Writes the n digits at d, with the decimal point after as many of them as
 * point says, at least one. Copies of a constant size are fast; what they write
 * after the text stays within NUMBER_MAX. */
template <int room>
static inline char *plain(char *s, const char *d, int n, int point)
{
	memcpy(s, d, room);
	if (n <= point)
		return s + point;
	s[point] = '.';
	memcpy(s + point + 1, d + point, room);
	return s + n + 1;
}

static char *exponential(char *s, const char *d, int n, int exponent)
{
	int e = abs(exponent);

	*s++ = d[0];
	if (n > 1) {
		*s++ = '.';
		memcpy(s, d + 1, size_t(n - 1));
		s += n - 1;
	}
	*s++ = 'e';
	*s++ = exponent < 0 ? '-' : '+';
	if (e >= 100)
		*s++ = char('0' + e / 100);
	if (e >= 10)
		*s++ = char('0' + e / 10 % 10);
	*s++ = char('0' + e % 10);
	return s;
}

/* Writes 0.ddd * 10^point, with the n digits ddd at d, as JavaScript lays it
 * out, without trailing zeros. */
template <int room>
static inline char *layout(char *s, const char *d, int n, int point)
{
	while (d[n - 1] == '0')
		n--;
	if (0 < point && point <= 21)
		return plain<room>(s, d, n, point);
	if (point <= -6 || point > 0)
		return exponential(s, d, n, point - 1);
	memcpy(s, "0.000000", 8);
	memcpy(s + 2 - point, d, room);
	return s + 2 - point + n;
}

/* Zeros bring the digits to 17, in a loop: how many are needed follows from the
 * branches that dragonbox took just before, so that the processor predicts it
 * well and goes on; a formula would have to wait for dragonbox's result. */
template <class Float>
[[gnu::flatten]] static char *write_shortest(char *s, Float v)
{
	using namespace jkj::dragonbox;
	auto r = to_decimal(v, policy::sign::ignore,
	    policy::trailing_zero::ignore);
	uint64_t digits = r.significand;
	int point = DIGITS + r.exponent;
	char d[64];

	if (sizeof v == sizeof(float)) { /* never more than 9 digits */
		digits *= power[8];
		point -= 8;
	}
	for (; digits < power[DIGITS - 1]; digits *= 10)
		point--;
	write_digits(d, digits);
	return layout<24>(s, d, DIGITS, point);
}

static uint64_t bits_of(double v)
{
	uint64_t bits;

	memcpy(&bits, &v, 8);
	return bits;
}

/* printf writes a point, and not a comma, as nobody calls setlocale. A text of
 * zeros alone loses its minus. */
static char *print_decimals(char *s, double v, int n)
{
	int size = snprintf(s, NUMBER_MAX, "%.*f", n, v);

	if (*s == '-' && !strpbrk(s, "123456789"))
		memmove(s, s + 1, size_t(--size));
	return s + size;
}

/* Multiplies the fraction high 2^-64 + low 2^-128 by 10^n, and returns what comes before
 * its point. */
static inline uint64_t times_ten(uint64_t *high, uint64_t *low, int n)
{
	uint64_t carry = 0;

	*low = multiply_add(*low, power[n], 0, &carry);
	*high = multiply_add(*high, power[n], 0, &carry);
	return carry;
}

/* Writes v rounded to n decimals, ties to even, at d: digits, and a null byte. Returns
 * how many are before the point, at least one; 0 where v is 2^53 or more, or its last
 * bit is below 2^-127 and n too large for it to be 0. The first DIGITS are of the whole
 * part, and all decimals if there is room for them and what rounding carries. */
static inline int find_digits(char d[192], double v, int n)
{
	uint64_t m = (bits_of(v) & ((1ull << 52) - 1)) | 1ull << 52;
	uint64_t high = 0, low = 0, digits = 0;
	int k = 1075 - int(bits_of(v) >> 52), point = DIGITS;
	char t[64];

	if (k < 1 || (k > 127 && n > 22)) /* 2^-75 10^22 < 1/2 */
		return 0;
	if (k <= 127) { /* the fraction is high 2^-64 + low 2^-128 */
		digits = k < 64 ? m >> k : 0;
		high = k <= 64 ? m << (64 - k) : m >> (k - 64);
		low = k <= 64 ? 0 : m << (128 - k);
	}
	if (n < DIGITS - 1 && digits < power[DIGITS - 1 - n]) {
		digits = times_ten(&high, &low, n) + digits * power[n];
		point -= n;
		n = 0;
	}
	write_digits(d, digits);
	d += DIGITS;
	for (int count; n > 0; n -= count, d += count) {
		count = n < DIGITS ? n : DIGITS;
		digits = times_ten(&high, &low, count);
		write_digits(t, digits);
		memcpy(d, t + DIGITS - count, DIGITS);
	}
	*d = '\0';
	if (high >> 63 && (high << 1 | low | (digits & 1)) != 0) {
		while (*--d == '9')
			*d = '0';
		++*d;
	}
	return point;
}

static char *write_decimals(char *s, double v, int n)
{
	char d[192];
	int zeros = 0, point = find_digits(d, std::fabs(v), n);

	if (point == 0)
		return print_decimals(s, v, n);
	while (zeros < point - 1 && d[zeros] == '0')
		zeros++;
	*s = '-';
	s += v < 0 &&
	    (d[zeros] != '0' || strpbrk(d + zeros, "123456789") != nullptr);
	memcpy(s, d + zeros, DIGITS);
	s += point - zeros;
	*s = '.';
	s += n > 0;
	memcpy(s, d + point, 24);
	if (n > 24)
		memcpy(s, d + point, size_t(n));
	return s + n;
}

static char *print_significant(char *s, double v, int n)
{
	char text[128], d[256];
	int exponent = 0;

	snprintf(text, sizeof text, "%.*e", n - 1, v);
	memset(d, '0', sizeof d);
	d[0] = text[0];
	memcpy(d + 1, text + 2, size_t(n - 1));
	const char *p = strchr(text, 'e') + 1;
	bool minus = *p++ == '-';

	while (*p != '\0')
		exponent = 10 * exponent + (*p++ - '0');
	return layout<104>(s, d, n, 1 + (minus ? -exponent : exponent));
}

/* The exponent of ten is guessed from that of two, with 78913 / 2^18 for log10(2): it
 * is right or one too small. If too small, there is a digit too many, and v is rounded
 * anew. If there is that digit because v was rounded up to a power of ten, the result
 * is right as well. */
static char *write_significant(char *s, double v, int n)
{
	char d[192];
	int log2 = int(bits_of(v) >> 52) - 1023, point = 0;
	int decimals = n - 1 - (log2 * 78913 >> 18);

	if (n <= DIGITS && decimals > 0 && v > 1e-20)
		point = find_digits(d, v, decimals);
	if (point == 0)
		return print_significant(s, v, n);
	int zeros = int(strspn(d, "0"));

	if (point + decimals - zeros > n) {
		point = find_digits(d, v, decimals - 1);
		zeros = int(strspn(d, "0"));
	}
	return layout<24>(s, d + zeros, n, point - zeros);
}

template <class Float>
static inline char *write_number(char *s, Float v, struct number_style style)
{
	if (!std::isfinite(v)) {
		memcpy(s, "nan", 3);
		return s + 3;
	}
	if (style.kind == number_style::NUMBER_DECIMALS)
		return write_decimals(s, double(v), style.n);
	if (v == 0) {
		*s = '0';
		return s + 1;
	}
	*s = '-';
	s += v < 0;
	if (style.kind == number_style::NUMBER_DIGITS)
		return write_significant(s, std::fabs(double(v)), style.n);
	return write_shortest(s, v);
}

char *number_write(char *s, double v, struct number_style style)
{
	return write_number(s, v, style);
}

char *number_write_float(char *s, float v, struct number_style style)
{
	return write_number(s, v, style);
}
