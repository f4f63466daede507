/* SPDX-License-Identifier: MIT */
/* Doubles that were rounded once, and are to be floats rounded once. */
#ifndef MIDWAY_H
#define MIDWAY_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Whether the float nearest to v may be another than that nearest to what v is the
 * nearest double to: v lies midway between two floats, or is below those with all
 * their digits, where it is not asked further. */
static inline bool is_midway(double v)
{
	uint64_t bits;

	memcpy(&bits, &v, sizeof bits);
	return ((bits & 0x1fffffff) == 0x10000000) |
	    ((fabs(v) < 0x1p-126) & (v != 0));
}

#endif
