/* SPDX-License-Identifier: MIT */
/* Eight characters in a word, on processors of either byte order. */
#ifndef EIGHT_H
#define EIGHT_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Each with '0' taken away, so that a digit is its value; the first is the lowest
 * byte. */
static inline uint64_t eight_at(const char *s)
{
	uint64_t w;

	memcpy(&w, s, 8);
	if (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__)
		w = __builtin_bswap64(w);
	return w ^ 0x3030303030303030;
}

/* How many of them are digits before another comes. A loop over so few would end at
 * a branch that nobody can predict. 9 + 0x76 has no top bit; what is no digit can
 * carry into the next byte and make that wrong, but the lowest is right. */
static inline size_t leading_digits(uint64_t w)
{
	w = (w | (w + 0x7676767676767676)) & 0x8080808080808080;
	return w == 0 ? 8 : (size_t)__builtin_ctzll(w) / 8;
}

#endif
