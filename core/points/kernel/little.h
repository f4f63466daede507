/* SPDX-License-Identifier: MIT */
/* Numbers as files of points have them, little-endian, at any address. */
#ifndef LITTLE_H
#define LITTLE_H

#include <stdint.h>
#include <string.h>

static inline uint64_t little_64(uint64_t bits)
{
	return __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ?
	    bits :
	    __builtin_bswap64(bits);
}

static inline uint32_t little_32(uint32_t bits)
{
	return __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ?
	    bits :
	    __builtin_bswap32(bits);
}

static inline double little_double(const char *p)
{
	uint64_t bits;
	double v;

	memcpy(&bits, p, sizeof bits);
	bits = little_64(bits);
	memcpy(&v, &bits, sizeof v);
	return v;
}

static inline float little_float(const char *p)
{
	uint32_t bits;
	float v;

	memcpy(&bits, p, sizeof bits);
	bits = little_32(bits);
	memcpy(&v, &bits, sizeof v);
	return v;
}

static inline void put_little_double(char *p, double v)
{
	uint64_t bits;

	memcpy(&bits, &v, sizeof bits);
	bits = little_64(bits);
	memcpy(p, &bits, sizeof bits);
}

static inline void put_little_float(char *p, float v)
{
	uint32_t bits;

	memcpy(&bits, &v, sizeof bits);
	bits = little_32(bits);
	memcpy(p, &bits, sizeof bits);
}

#endif
