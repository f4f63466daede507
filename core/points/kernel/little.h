/* SPDX-License-Identifier: MIT */
/* Numbers as files of points have them, little-endian, at any address. */
#ifndef LITTLE_H
#define LITTLE_H

#include <stddef.h>
#include <string.h>

/* Copies a number from this processor's byte order to little-endian, or back. */
static inline void little_copy(void *to, const void *from, size_t size)
{
	if (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
		memcpy(to, from, size);
	else
		for (size_t i = 0; i < size; i++)
			((char *)to)[i] = ((const char *)from)[size - 1 - i];
}

static inline double little_double(const char *p)
{
	double v;

	little_copy(&v, p, sizeof v);
	return v;
}

static inline float little_float(const char *p)
{
	float v;

	little_copy(&v, p, sizeof v);
	return v;
}

static inline void put_little_double(char *p, double v)
{
	little_copy(p, &v, sizeof v);
}

static inline void put_little_float(char *p, float v)
{
	little_copy(p, &v, sizeof v);
}

#endif
