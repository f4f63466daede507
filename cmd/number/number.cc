// SPDX-License-Identifier: MIT
/* fast_float reads numbers, Dragonbox finds the shortest digits; where there is no
 * header of theirs, or PLAIN_NUMBERS is defined, the C++ library does so. Other digits
 * come from 128 bits of the number's fraction or, if those are too few, from printf. */
#include "number.h"

/* NDEBUG removes the assertions of both libraries. */
#undef NDEBUG
#define NDEBUG

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#if !defined PLAIN_NUMBERS && __has_include(<dragonbox/dragonbox.h>)
#include <dragonbox/dragonbox.h>
#define WRITES_BY_DRAGONBOX 1
#endif
#if !defined PLAIN_NUMBERS && __has_include(<fast_float/fast_float.h>)
#include <fast_float/fast_float.h>
#define READS_BY_FAST_FLOAT 1
#endif

#include "../../core/exact/wide.h"

#if !READS_BY_FAST_FLOAT
static bool is_digit(const char *s, const char *end)
{
	return s < end && '0' <= *s && *s <= '9';
}

/* Reads a word, such as nan, by strtod. */
static const char *read_word(const char *s, const char *end, double *v)
{
	char text[sizeof "-infinity"] = "", *last;
	size_t n = size_t(end - s);

	memcpy(text, s, n < sizeof text - 1 ? n : sizeof text - 1);
	text[strcspn(text, "(")] = '\0'; /* nan is read, and nan(...) is not */
	*v = strtod(text, &last);
	return last == text ? NULL : s + (last - text);
}

/* Reads an exponent, such as e-7, if there is one. No more digits of it are kept than
 * are compared with the number of bytes of a text. */
static const char *read_exponent(const char *s, const char *end, long long *exponent)
{
	const char *digit = s + 1;
	bool minus = false;
	long long e = 0;

	if (s == end || (*s != 'e' && *s != 'E'))
		return s;
	if (digit < end && (*digit == '-' || *digit == '+'))
		minus = *digit++ == '-';
	if (!is_digit(digit, end))
		return s;
	for (; is_digit(digit, end); digit++)
		if (e < 1000000000000000)
			e = e * 10 + (*digit - '0');
	*exponent += minus ? -e : e;
	return digit;
}

/* Reads a number of any length by strtod, to which it gives an integer and an exponent,
 * so that neither the locale nor what follows matters. No middle of two doubles has
 * more than 768 digits, so that of the digits after 800 only counts whether one is not
 * 0. */
static const char *read_by_strtod(const char *s, const char *end, double *v)
{
	char text[832], *first = text, *last = text + 800;
	bool any = false, point = false, more = false;
	long long exponent = -1;

	if (s < end && *s == '-')
		*first++ = '-';
	const char *digit = s + (first - text);

	if (digit < end && (*digit | 32) >= 'a')
		return read_word(s, end, v);
	char *to = first;

	for (; is_digit(digit, end) || (digit < end && *digit == '.' && !point);
	     digit++) {
		if (*digit == '.') {
			point = true;
			continue;
		}
		any = true;
		exponent -= point;
		if (to < last && (to > first || *digit != '0')) {
			*to++ = *digit;
		} else if (to == last) {
			exponent++;
			more |= *digit != '0';
		}
	}
	if (!any)
		return NULL;
	digit = read_exponent(digit, end, &exponent);
	exponent = exponent < -2000 ? -2000 : exponent > 2000 ? 2000 : exponent;
	snprintf(to, 32, "%ce%d", more ? '1' : '0', int(exponent));
	*v = strtod(text, NULL);
	return digit;
}

/* Where the C++ library has std::from_chars for doubles, it reads what is in range: of
 * other numbers it does not say whether they are too large or too small. A
 * PLAIN_NUMBERS of 2 hides it. */
static const char *read_plain(const char *s, const char *end, double *v)
{
#if __cpp_lib_to_chars >= 201611L && PLAIN_NUMBERS < 2
	std::from_chars_result r = std::from_chars(s, end, *v);

	if (r.ec != std::errc::result_out_of_range)
		return r.ec == std::errc::invalid_argument ? NULL : r.ptr;
#endif
	return read_by_strtod(s, end, v);
}
#endif

const char *number_read(const char *s, const char *end, double *v)
{
	bool plus = s != end && *s == '+';

	s += plus;
	if (s == end || (plus && *s == '-'))
		return NULL;
#if READS_BY_FAST_FLOAT
	fast_float::from_chars_result r = fast_float::from_chars(s, end, *v);
	const char *after = r.ec == std::errc::invalid_argument ? NULL : r.ptr;
#else
	const char *after = read_plain(s, end, v);
#endif
	/* some also read what follows nan in nan(...) */
	return after && std::isnan(*v) ? s + (*s == '-') + 3 : after;
}

/* The most digits that the shortest text of a double needs. */
enum { DOUBLE_DIGITS = 17 };

static const uint64_t ten_to[] = { 1, 10, 100, 1000, 10000, 100000, 1000000, 10000000,
	100000000, 1000000000, 10000000000, 100000000000, 1000000000000, 10000000000000,
	100000000000000, 1000000000000000, 10000000000000000, 100000000000000000 };

/* The texts 000 to 999. */
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

/* Writes three decimals of p (54 fractional bits). Returns 1000 times its fraction. */
static inline uint64_t write_three(char *s, uint64_t p)
{
	p = (p & ((1ull << 54) - 1)) * 1000;
	memcpy(s, triple.text[p >> 54], 4);
	return p;
}

/* Returns the lower 64 bits of high 2^64 + low shifted right by 1 <= k <= 127. */
static inline uint64_t shift_right(uint64_t high, uint64_t low, int k)
{
	return k < 64 ? high << (64 - k) | low >> k : high >> (k - 64);
}

/* Writes the 17 digits of x < 10^17, and zeros after them, which put_with_point may
 * copy. p is x / 10^15, with 54 fractional bits. The product with 2^113 / 10^15, which
 * is rounded up, makes p less than 1.2 * 2^-54 too large. Five multiplications by 1000
 * make this error 10^15 times as large: below 0.07, so that no digit changes. */
static inline void write_17_digits(char d[64], uint64_t x)
{
	const uint64_t reciprocal = 10384593717069655258u;
	uint64_t high = 0, low = wide_multiply_add(x, reciprocal, 0, &high);
	uint64_t p = shift_right(high, low, 59) + 1;

	memcpy(d, triple.text[p >> 54] + 1, 2);
	p = write_three(d + 2, p);
	p = write_three(d + 5, p);
	p = write_three(d + 8, p);
	p = write_three(d + 11, p);
	write_three(d + 14, p);
	memset(d + DOUBLE_DIGITS, '0', 64 - DOUBLE_DIGITS);
}

/* Writes the n digits at d with the point after `point` of them, if more follow. Copies
 * of a constant size, room, are fast; NUMBER_MAX includes them. */
template <int room>
static inline char *put_with_point(char *s, const char *d, int n, int point)
{
	memcpy(s, d, room);
	if (n <= point)
		return s + point;
	s[point] = '.';
	memcpy(s + point + 1, d + point, room);
	return s + n + 1;
}

/* Writes an exponent, such as e-7 or e+21. Returns the end of the text. */
static char *put_exponent(char *s, int exponent)
{
	int e = abs(exponent), zeros = (e < 100) + (e < 10);

	*s++ = 'e';
	*s++ = exponent < 0 ? '-' : '+';
	memcpy(s, triple.text[e] + zeros, size_t(3 - zeros));
	return s + 3 - zeros;
}

/* Writes 0.ddd * 10^point, whose n digits ddd are at d, without zeros at the end. */
template <int room>
static inline char *put_digits(char *s, const char *d, int n, int point)
{
	while (d[n - 1] == '0')
		n--;
	if (0 < point && point <= 21)
		return put_with_point<room>(s, d, n, point);
	if (point <= -6 || point > 0)
		return put_exponent(put_with_point<room>(s, d, n, 1), point - 1);
	memcpy(s, "0.000000", 8);
	memcpy(s + 2 - point, d, room);
	return s + 2 - point + n;
}

#if WRITES_BY_DRAGONBOX
/* Writes the shortest text of |v|. A loop multiplies the digits by 10 until there are
 * 17: the processor predicts its turns; a formula would wait for Dragonbox. */
template <class Float> [[gnu::flatten]] static char *write_shortest(char *s, Float v)
{
	using namespace jkj::dragonbox;
	auto r = to_decimal(v, policy::sign::ignore, policy::trailing_zero::ignore);
	uint64_t digits = r.significand;
	int point = DOUBLE_DIGITS + r.exponent;
	char d[64];

	if (sizeof v == sizeof(float)) { /* a float has at most 9 digits */
		digits *= ten_to[8];
		point -= 8;
	}
	for (; digits < ten_to[DOUBLE_DIGITS - 1]; digits *= 10)
		point--;
	write_17_digits(d, digits);
	return put_digits<24>(s, d, DOUBLE_DIGITS, point);
}
#else
/* Writes the shortest text of |v|. std::to_chars writes d.ddde+dd, or de+dd if there
 * is one digit, with two or three digits of the exponent. */
template <class Float> static char *write_shortest(char *s, Float v)
{
	char text[32], d[64];
	const char *end = std::to_chars(text, text + sizeof text, std::fabs(v),
	    std::chars_format::scientific)
			      .ptr;
	const char *e = end[-4] == 'e' ? end - 4 : end - 5;
	int exponent = 0, n = 1;

	for (const char *digit = e + 2; digit < end; digit++)
		exponent = exponent * 10 + (*digit - '0');
	memset(d, '0', sizeof d);
	d[0] = text[0];
	if (text[1] == '.') {
		n = int(e - text) - 1;
		memcpy(d + 1, text + 2, size_t(n - 1));
	}
	return put_digits<24>(s, d, n, 1 + (e[1] == '-' ? -exponent : exponent));
}
#endif

static uint64_t bits_of(double v)
{
	uint64_t bits;

	memcpy(&bits, &v, 8);
	return bits;
}

/* Writes v with n decimals by printf, without a minus if all digits are 0. */
static char *print_decimals(char *s, double v, int n)
{
	int size = snprintf(s, NUMBER_MAX, "%.*f", n, v);

	if (*s == '-' && !strpbrk(s, "123456789"))
		memmove(s, s + 1, size_t(--size));
	return s + size;
}

/* Multiplies the fraction high 2^-64 + low 2^-128 by 10^n. Returns the integer part of
 * the product, and stores its fraction in high and low. */
static inline uint64_t times_ten_to(uint64_t *high, uint64_t *low, int n)
{
	uint64_t carry = 0;

	*low = wide_multiply_add(*low, ten_to[n], 0, &carry);
	*high = wide_multiply_add(*high, ten_to[n], 0, &carry);
	return carry;
}

/* Writes to d the digits of v rounded to n decimals, ties to even, and a null byte.
 * Returns the number of digits before the point, or 0 if v >= 2^53, or has bits below
 * 2^-127 and n > 22. The first digit is always 0, so that rounding up can carry into
 * it; DOUBLE_DIGITS digits include the integer part and, if they fit, the decimals. */
static inline int find_digits(char d[192], double v, int n)
{
	uint64_t m = (bits_of(v) & ((1ull << 52) - 1)) | 1ull << 52;
	uint64_t high = 0, low = 0, digits = 0;
	int k = 1075 - int(bits_of(v) >> 52), point = DOUBLE_DIGITS;
	char t[64];

	if (k < 1 || (k > 127 && n > 22)) /* 22 decimals of v < 2^-75 are 0 */
		return 0;
	if (k <= 127) { /* the fraction is high 2^-64 + low 2^-128 */
		digits = k < 64 ? m >> k : 0;
		high = k <= 64 ? m << (64 - k) : m >> (k - 64);
		low = k <= 64 ? 0 : m << (128 - k);
	}
	if (n < DOUBLE_DIGITS - 1 && digits < ten_to[DOUBLE_DIGITS - 1 - n]) {
		digits = times_ten_to(&high, &low, n) + digits * ten_to[n];
		point -= n;
		n = 0;
	}
	write_17_digits(d, digits);
	d += DOUBLE_DIGITS;
	for (int count; n > 0; n -= count, d += count) {
		count = n < DOUBLE_DIGITS ? n : DOUBLE_DIGITS;
		digits = times_ten_to(&high, &low, count);
		write_17_digits(t, digits);
		memcpy(d, t + DOUBLE_DIGITS - count, DOUBLE_DIGITS);
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
	s += v < 0 && (d[zeros] != '0' || strpbrk(d + zeros, "123456789") != nullptr);
	point -= zeros;
	return n <= 24 ? put_with_point<24>(s, d + zeros, point + n, point) :
			 put_with_point<104>(s, d + zeros, point + n, point);
}

static char *print_significant(char *s, double v, int n)
{
	char d[128];

	snprintf(d, sizeof d, "%.*e", n - 1, v);
	int exponent = atoi(strchr(d, 'e') + 1);

	d[1] = d[0]; /* d[1] was the point */
	memset(d + 1 + n, '0', sizeof d - 1 - size_t(n));
	return put_digits<104>(s, d + 1, n, 1 + exponent);
}

/* Writes n significant digits of v > 0. The exponent of ten, log2 v times 78913 / 2^18,
 * is right or one too small. Then, and if v is rounded up to a power of ten,
 * find_digits gives a digit too many, and is called again with one decimal less. */
static char *write_significant(char *s, double v, int n)
{
	char d[192];
	int log2 = int(bits_of(v) >> 52) - 1023, point = 0;
	int decimals = n - 1 - (log2 * 78913 >> 18);

	if (n <= DOUBLE_DIGITS && decimals > 0 && v > 1e-20)
		point = find_digits(d, v, decimals);
	if (point == 0)
		return print_significant(s, v, n);
	int zeros = int(strspn(d, "0"));

	if (point + decimals - zeros > n) {
		point = find_digits(d, v, decimals - 1);
		zeros = int(strspn(d, "0"));
	}
	return put_digits<24>(s, d + zeros, n, point - zeros);
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
