/* SPDX-License-Identifier: MIT */
/* Tells whether a number that was rounded to double can safely be rounded to float. */
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Returns true if v, the double nearest to an exact value, may round to another float
 * than the exact value. This can happen only if v is midway between two floats. Also
 * returns true, without a test, if 0 < |v| < 2^-126: the range of subnormal floats. */
static inline bool is_midway(double v)
{
	uint64_t bits;

	memcpy(&bits, &v, sizeof bits);
	return ((bits & 0x1fffffff) == 0x10000000) | ((fabs(v) < 0x1p-126) & (v != 0));
}
