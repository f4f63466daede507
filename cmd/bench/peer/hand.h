/* SPDX-License-Identifier: MIT */
// Reads and writes numbers by hand, eight digits at a time in a word of 64 bits.
// dragonbox finds the shortest digits, which are written to their final place.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

// The assertions of the library cost time.
#undef NDEBUG
#define NDEBUG
#include <dragonbox/dragonbox.h>
#include <fast_float/fast_float.h>

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
    "the first digit is the lowest byte");

// The longest text of a double in its shortest digits has 24 bytes; a separator
// follows.
enum { HAND_MAX = 25 };

static const uint64_t hand_powers[] = { 1, 10, 100, 1000, 10000, 100000, 1000000,
	10000000, 100000000, 1000000000, 10000000000, 100000000000, 1000000000000,
	10000000000000, 100000000000000, 1000000000000000, 10000000000000000,
	100000000000000000 };

static const uint64_t hand_zeros = 0x3030303030303030;

static inline uint64_t hand_load(const char *from)
{
	uint64_t word;

	memcpy(&word, from, sizeof word);
	return word;
}

static inline void hand_store(char *to, uint64_t word)
{
	memcpy(to, &word, sizeof word);
}

// Returns how many of eight characters are digits, up to the first that is not.
static inline unsigned hand_count(uint64_t word)
{
	word ^= hand_zeros;
	word = (word | (word + 0x7676767676767676)) & 0x8080808080808080;
	return word == 0 ? 8 : unsigned(__builtin_ctzll(word)) / 8;
}

// Returns the value of the first n of eight characters, which are 1 to 7 digits.
static inline uint64_t hand_value(uint64_t word, unsigned n)
{
	word = (word ^ hand_zeros) << (64 - 8 * n);
	word = word * 10 + (word >> 8);
	word = (word & 0x000000ff000000ff) * 0x000f424000000064 +
	    ((word >> 16) & 0x000000ff000000ff) * 0x0000271000000001;
	return word >> 32;
}

// Reads the number at s. Eight bytes after end can be read, and the first of them is
// not a digit. Returns the end of the number, or nullptr if s has no number.
template <class T>
static inline const char *hand_read(const char *s, const char *end, T *value)
{
	const bool negative = *s == '-';
	const char *next = s + negative;
	uint64_t word = hand_load(next), digits = 0;
	unsigned whole = hand_count(word), decimals = 0;

	if (whole > 0 && whole < 8) {
		digits = hand_value(word, whole);
		next += whole;
		if (*next == '.') {
			word = hand_load(++next);
			decimals = hand_count(word);
			if (decimals > 0 && decimals < 8)
				digits = digits * hand_powers[decimals] +
				    hand_value(word, decimals);
			next += decimals;
		}
		if (decimals < 8 && (*next | 0x20) != 'e') {
			double v = double(digits) / double(hand_powers[decimals]);

			*value = T(negative ? -v : v);
			return next;
		}
	}
	auto r = fast_float::from_chars(s, end, *value);
	return r.ec == std::errc() ? r.ptr : nullptr;
}

// Returns the eight digits, with leading zeros, of a number below 1e8.
static inline uint64_t hand_text(uint32_t number)
{
	uint64_t fours = number / 10000 | uint64_t(number % 10000) << 32;
	uint64_t hundreds = ((fours * 10486) >> 20) & 0x0000007f0000007f;
	uint64_t twos = hundreds | (fours - hundreds * 100) << 16;
	uint64_t tens = ((twos * 103) >> 10) & 0x000f000f000f000f;

	return (tens | (twos - tens * 10) << 8) + hand_zeros;
}

// Returns how many of eight digits remain without the zeros at the end. At least one of
// the digits is not 0.
static inline int hand_length(uint64_t text)
{
	return 8 - __builtin_clzll(text ^ hand_zeros) / 8;
}

// Writes the shortest number that is read as value, into HAND_MAX bytes. Returns
// its end.
template <class T> static inline char *hand_write(char *to, T value)
{
	if (value == 0 || !std::isfinite(value))
		return std::to_chars(to, to + HAND_MAX, value).ptr;
	const auto decimal = jkj::dragonbox::to_decimal(value,
	    jkj::dragonbox::policy::trailing_zero::ignore);
	uint64_t digits = decimal.significand;
	int whole = 17 + decimal.exponent; // digits before the point

	// Writes 17 digits as one, eight and eight. The branches on the number of
	// digits let the processor predict this number, and not wait for it.
	if (sizeof value == sizeof(float)) {
		digits *= hand_powers[8];
		whole -= 8;
	}
	for (; digits < hand_powers[16]; digits *= 10)
		whole--;
	if (whole < -3 || whole > 7)
		return std::to_chars(to, to + HAND_MAX, value).ptr;
	*to = '-';
	to += decimal.is_negative;

	const uint64_t rest = digits % hand_powers[16];
	const uint64_t first = digits / hand_powers[16] + '0';
	const uint64_t middle = hand_text(uint32_t(rest / hand_powers[8]));
	const uint64_t last = hand_text(uint32_t(rest % hand_powers[8]));
	const int n = last != hand_zeros ? hand_length(last) + 9 :
	    middle != hand_zeros         ? hand_length(middle) + 1 :
					   1;

	if (whole <= 0) {
		memcpy(to, "0.000000", 8);
		to += 2 - whole;
		*to = char(first);
		hand_store(to + 1, middle);
		hand_store(to + 9, last);
		return to + n;
	}
	// Writes all digits one byte late, and then the first eight bytes again, with
	// the point.
	const uint64_t head = first | middle << 8;
	const uint64_t before = (uint64_t(1) << 8 * whole) - 1;

	hand_store(to + 2, middle);
	hand_store(to + 10, last);
	hand_store(to,
	    (head & before) | uint64_t('.') << 8 * whole | (head << 8 & ~before << 8));
	return to + (n > whole ? n + 1 : whole);
}
