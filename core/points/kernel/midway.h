/* SPDX-License-Identifier: MIT */
/* Tells whether a double, itself a rounded result, may be rounded again to a float. */
#ifndef MIDWAY_H
#define MIDWAY_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Returns true if rounding v to a float may give another float than rounding the exact
 * value whose nearest double is v. The floats differ only if v is midway between two
 * floats. If v is subnormal as a float, the function always returns true. */
static inline bool is_midway(double v)
{
	uint64_t bits;

	memcpy(&bits, &v, sizeof bits);
	return ((bits & 0x1fffffff) == 0x10000000) |
	    ((fabs(v) < 0x1p-126) & (v != 0));
}

#endif
