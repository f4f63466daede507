/* SPDX-License-Identifier: MIT */
/* Eight characters in a word, the first in its lowest byte. */
#ifndef EIGHT_H
#define EIGHT_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Returns the eight characters at s, each less '0', so that a digit becomes its
 * value. */
static inline uint64_t eight_at(const char *s)
{
	uint64_t w;

	memcpy(&w, s, 8);
	if (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__)
		w = __builtin_bswap64(w);
	return w ^ 0x3030303030303030;
}

/* Returns how many of the characters are digits before the first that is none, without
 * a branch for each, which processors could not predict. 9 + 0x76 has no top bit;
 * another character's sum can carry into the next byte, but the lowest of them is
 * right. */
static inline size_t leading_digits(uint64_t w)
{
	w = (w | (w + 0x7676767676767676)) & 0x8080808080808080;
	return w == 0 ? 8 : (size_t)__builtin_ctzll(w) / 8;
}

#endif
