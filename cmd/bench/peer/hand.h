/* SPDX-License-Identifier: MIT */
// Reads and writes numbers by hand: reads eight digits at a time in a word of 64 bits,
// finds the shortest digits of a double by one product, as Schubfach's heirs yy and
// zmij do, and writes 16 digits at a time, with SSE4.1 where the processor has it.
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
#ifdef __SSE4_1__
#include <smmintrin.h>
#endif

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

// The digits of a number, digits * 10^exponent.
struct hand_decimal {
	uint64_t digits;
	int exponent;
};

template <class T> static inline hand_decimal hand_dragonbox(T value)
{
	const auto decimal = jkj::dragonbox::to_decimal(value,
	    jkj::dragonbox::policy::sign::ignore,
	    jkj::dragonbox::policy::trailing_zero::ignore);

	return { decimal.significand, decimal.exponent };
}

static inline hand_decimal hand_shortest(float value)
{
	return hand_dragonbox(value);
}

// The double is c 2^q. With k = floor(log10(2^q)), doubles next to each other are from
// 1 to 10 apart in units of 10^k. So some whole number of these units is read as the
// double, and at most one multiple of ten is, which is then the shortest. One product
// of 64 and 128 bits finds c 2^q / 10^k within 2^-60; what is nearer than that to a
// decision is left to dragonbox, as are powers of two, below which doubles are nearer.
static inline hand_decimal hand_shortest(double value)
{
	using cache =
	    jkj::dragonbox::detail::cache_holder<jkj::dragonbox::ieee754_binary64>;
	const uint64_t one = uint64_t(1) << 60;
	uint64_t bits;

	memcpy(&bits, &value, sizeof bits);
	const int biased = int(bits >> 52 & 0x7ff);
	const uint64_t low = bits & ((uint64_t(1) << 52) - 1);
	// cppcheck-suppress shiftNegativeLHS; all compilers here round down
	const int q = biased - 1075, k = (q * 315653) >> 20;

	if (low == 0 || biased == 0 || -k < cache::min_k || -k > cache::max_k)
		return hand_dragonbox(value);
	const auto power = cache::cache[-k - cache::min_k];
	const int shift = q + ((-k * 1741647) >> 19); // 0 to 3
	const uint64_t c = (low | uint64_t(1) << 52) << (shift + 1);
	const unsigned __int128 product = (unsigned __int128)c * power.high() +
	    uint64_t((unsigned __int128)c * power.low() >> 64);
	const uint64_t whole = uint64_t(product >> 64), part = uint64_t(product);
	const uint64_t digit = whole % 10;

	// the distance from the multiple of ten below, and half the distance of doubles
	const uint64_t above = digit << 60 | part >> 4;
	const uint64_t half = power.high() >> (4 - shift);
	const uint64_t sum = above + half;

	if (__builtin_expect(above - half + 4 < 8 || sum - 10 * one + 4 < 8 ||
		    part + 64 - (uint64_t(1) << 63) < 128,
		0))
		return hand_dragonbox(value);
	const uint64_t nearest = whole + (part >> 63);
	const uint64_t tens = whole - digit + (sum > 10 * one ? 10 : 0);

	return { above < half || sum > 10 * one ? tens : nearest, k };
}

// The texts of the upper and lower eight of 16 digits, and their length without the
// zeros at the end.
struct hand_sixteen {
	uint64_t upper, lower;
	int length;
};

#ifdef __SSE4_1__
// Divides by 10000, by 100 and by 10, in all lanes at a time.
static inline hand_sixteen hand_texts(uint64_t number)
{
	const __m128i eights = _mm_set_epi64x(int64_t(number % 100000000),
	    int64_t(number / 100000000));
	const __m128i ten_thousands = _mm_srli_epi64(_mm_mul_epu32(eights,
							 _mm_set1_epi64x(109951163)),
	    40);
	const __m128i fours = _mm_or_si128(ten_thousands,
	    _mm_slli_epi64(_mm_sub_epi64(eights,
			       _mm_mul_epu32(ten_thousands, _mm_set1_epi64x(10000))),
		32));
	const __m128i hundreds = _mm_srli_epi16(_mm_mulhi_epu16(fours,
						    _mm_set1_epi16(5243)),
	    3);
	const __m128i twos = _mm_or_si128(hundreds,
	    _mm_slli_epi32(_mm_sub_epi16(fours,
			       _mm_mullo_epi16(hundreds, _mm_set1_epi16(100))),
		16));
	const __m128i tens = _mm_mulhi_epu16(twos, _mm_set1_epi16(6554));
	const __m128i ones = _mm_or_si128(tens,
	    _mm_slli_epi16(_mm_sub_epi16(twos,
			       _mm_mullo_epi16(tens, _mm_set1_epi16(10))),
		8));
	const unsigned digits = unsigned(
	    _mm_movemask_epi8(_mm_cmpgt_epi8(ones, _mm_setzero_si128())));
	const __m128i text = _mm_or_si128(ones, _mm_set1_epi8('0'));

	return { uint64_t(_mm_cvtsi128_si64(text)),
		uint64_t(_mm_extract_epi64(text, 1)), 32 - __builtin_clz(digits) };
}
#else
static inline hand_sixteen hand_texts(uint64_t number)
{
	const uint64_t upper = hand_text(uint32_t(number / 100000000));
	const uint64_t lower = hand_text(uint32_t(number % 100000000));

	return { upper, lower,
		lower != hand_zeros ? hand_length(lower) + 8 : hand_length(upper) };
}
#endif

// Writes the shortest number that is read as value, into HAND_MAX bytes. Returns
// its end.
template <class T> static inline char *hand_write(char *to, T value)
{
	if (value == 0 || !std::isfinite(value))
		return std::to_chars(to, to + HAND_MAX, value).ptr;
	hand_decimal decimal = hand_shortest(value);
	uint64_t digits = decimal.digits;
	int whole = 17 + decimal.exponent; // digits before the point

	// Writes 17 digits as one and 16.
	if (sizeof value == sizeof(float)) {
		digits *= hand_powers[8];
		whole -= 8;
	}
	// The first step has no branch that the processor could mispredict.
	const bool short_by_one = digits < hand_powers[16];

	digits += short_by_one ? 9 * digits : 0;
	whole -= short_by_one;
	for (; __builtin_expect(digits < hand_powers[16], 0); digits *= 10)
		whole--;
	if (whole < -3 || whole > 7)
		return std::to_chars(to, to + HAND_MAX, value).ptr;
	*to = '-';
	to += std::signbit(value);

	const uint64_t first = digits / hand_powers[16] + '0';
	const uint64_t rest = digits % hand_powers[16];
	const hand_sixteen text = rest != 0 ? hand_texts(rest) :
					      hand_sixteen{ hand_zeros, hand_zeros, 0 };
	const int n = 1 + text.length;

	if (whole <= 0) {
		memcpy(to, "0.000000", 8);
		to += 2 - whole;
		*to = char(first);
		hand_store(to + 1, text.upper);
		hand_store(to + 9, text.lower);
		return to + n;
	}
	// Writes all digits one byte late, and then the first eight bytes again, with
	// the point.
	const uint64_t head = first | text.upper << 8;
	const uint64_t before = (uint64_t(1) << 8 * whole) - 1;

	hand_store(to + 2, text.upper);
	hand_store(to + 10, text.lower);
	hand_store(to,
	    (head & before) | uint64_t('.') << 8 * whole | (head << 8 & ~before << 8));
	return to + (n > whole ? n + 1 : whole);
}
