// SPDX-License-Identifier: MIT
/* Nanoseconds a number, %.6f coordinates / 17 digits (cmd/bench/number.cc, gcc
 * 12, a Xeon with AVX-512): strtod 72 / 95, charconv 18 / 21, fast_float 15 / 18,
 * here 12 / 21. The library is headers only: no C++ library is loaded, which would
 * double the 0.6 ms of a start. */
#include "number.h"
#include "eight.h"

/* The library's assertions are for its own tests, and cost time. */
#undef NDEBUG
#define NDEBUG

#include <cmath>
#include <cstdint>
#include <cstring>

#include <fast_float/fast_float.h>

static const uint64_t power[8] = { 1, 10, 100, 1000, 10000, 100000, 1000000,
	10000000 };

/* Powers of ten with either sign: to look the sign up is faster than a branch,
 * which the processor would have to guess. */
static const double signed_power[2][8] = {
	{ 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7 },
	{ -1e0, -1e1, -1e2, -1e3, -1e4, -1e5, -1e6, -1e7 },
};

/* The first n < 8 of eight loaded digits as a number: pairs, then fours, then
 * all, in three multiplications. */
static uint64_t first_digits(uint64_t w, size_t n)
{
	const uint64_t pairs = 0x000000ff000000ff;

	w = w << 8 << (56 - 8 * n);
	w = w * 10 + (w >> 8);
	return uint32_t(((w & pairs) * (100 + (1000000ull << 32)) +
			    ((w >> 16) & pairs) * (1 + (10000ull << 32))) >>
	    32);
}

/* Reads [-] up to 7 digits [. up to 7 digits] where 17 characters are there to
 * look at, or returns NULL. All digits together are an integer below 10^14, so
 * that it and the power of ten are exact doubles, and their quotient is
 * correctly rounded. */
static inline const char *read_short(const char *s, double *v)
{
	size_t minus = *s == '-', whole, decimals = 0;
	uint64_t w, fraction = 0;

	s += minus;
	w = eight_at(s);
	whole = leading_digits(w);
	if (whole == 8)
		return NULL;
	s += whole;
	if (*s == '.') {
		fraction = eight_at(++s);
		decimals = leading_digits(fraction);
		if (decimals == 8)
			return NULL;
		s += decimals;
	}
	if (whole + decimals == 0 || (*s | 0x20) == 'e')
		return NULL;
	w = first_digits(w, whole) * power[decimals] +
	    first_digits(fraction, decimals);
	*v = double(int64_t(w)) / signed_power[minus][decimals];
	return s;
}

static const char *read_any(const char *s, const char *end, double *v)
{
	bool plus = s != end && *s == '+';

	s += plus;
	if (s == end || (plus && *s == '-'))
		return NULL;
	fast_float::from_chars_result r = fast_float::from_chars(s, end, *v);
	if (r.ec == std::errc::invalid_argument)
		return NULL;
	/* The library would go on to take in the (...) of a nan(...). */
	return std::isnan(*v) ? s + (*s == '-') + 3 : r.ptr;
}

const char *number_read(const char *s, const char *end, double *v)
{
	if (end - s >= 17)
		if (const char *p = read_short(s, v))
			return p;
	return read_any(s, end, v);
}
