/* SPDX-License-Identifier: MIT */
/* Tells which doubles, which are results of rounding, cannot be rounded again to
 * floats. */
#ifndef MIDWAY_H
#define MIDWAY_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Returns true if the float nearest to v may differ from the float nearest to the exact
 * value that was rounded to v. They differ only if v is midway between two floats. If v
 * is subnormal as a float, the function always returns true. */
static inline bool is_midway(double v)
{
	uint64_t bits;

	memcpy(&bits, &v, sizeof bits);
	return ((bits & 0x1fffffff) == 0x10000000) |
	    ((fabs(v) < 0x1p-126) & (v != 0));
}

#endif
