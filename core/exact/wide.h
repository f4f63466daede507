/* SPDX-License-Identifier: MIT */
/* Arithmetic on words of 64 bits with carries, also for compilers without integers of
 * 128 bits, such as those for 32-bit processors. */
#pragma once

#include <stdint.h>

/* Returns the low word of a b + c + *carry, and sets *carry to the high word. Two words
 * hold the sum: with B = 2^64 it is at most (B - 1)^2 + 2 (B - 1) = B^2 - 1. With B =
 * 2^32 the same bound holds for p, q and r below. */
static inline uint64_t wide_multiply_add(uint64_t a, uint64_t b, uint64_t c,
    uint64_t *carry)
{
#ifdef __SIZEOF_INT128__
	/* gcc adds c and the carry to both words in fewer instructions than to p */
	unsigned __int128 p = (unsigned __int128)a * b;
	uint64_t low = (uint64_t)p + c, high = (uint64_t)(p >> 64) + (low < c);

	low += *carry;
	*carry = high + (low < *carry);
	return low;
#else
	const uint64_t half = UINT32_MAX;
	uint64_t p = (a & half) * (b & half) + (c & half) + (*carry & half);
	uint64_t q = (a >> 32) * (b & half) + (c >> 32) + (p >> 32);
	uint64_t r = (a & half) * (b >> 32) + (*carry >> 32) + (q & half);

	*carry = (a >> 32) * (b >> 32) + (q >> 32) + (r >> 32);
	return r << 32 | (p & half);
#endif
}

/* Returns the quotient, rounded down, of high 2^64 + low by d > high. */
static inline uint64_t wide_divide(uint64_t high, uint64_t low, uint64_t d)
{
#ifdef __SIZEOF_INT128__
	return (uint64_t)(((unsigned __int128)high << 64 | low) / d);
#else
	for (int i = 0; i < 64; i++) {
		uint64_t top = high >> 63;

		high = high << 1 | low >> 63;
		low <<= 1;
		if (top || high >= d) {
			high -= d;
			low |= 1;
		}
	}
	return low;
#endif
}
