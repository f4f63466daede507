/* SPDX-License-Identifier: MIT */
/* Reads and writes numbers of binary files: little-endian, at any address. */
#pragma once

#include <stdbool.h>
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

/* little_get returns the double or float at p. little_put writes v as one, -0 as 0. */
static inline double little_get(const char *p, bool is_double)
{
	double v;
	float single;

	little_copy(is_double ? (void *)&v : &single, p, is_double ? 8 : 4);
	return is_double ? v : (double)single;
}

static inline void little_put(char *p, bool is_double, double v)
{
	float single = (float)v + 0.0f;

	v += 0.0;
	little_copy(p, is_double ? (void *)&v : &single, is_double ? 8 : 4);
}
