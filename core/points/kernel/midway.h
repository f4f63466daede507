/* SPDX-License-Identifier: MIT */
/* Tells whether a double that is a rounded result may be rounded again, to a float. */
#ifndef MIDWAY_H
#define MIDWAY_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Returns true if v may round to another float than the exact value to which v is the
 * nearest double. The floats can differ only if v is midway between two floats. If v
 * would be a subnormal float, is_midway returns true without a test. */
static inline bool is_midway(double v)
{
	uint64_t bits;

	memcpy(&bits, &v, sizeof bits);
	return ((bits & 0x1fffffff) == 0x10000000) |
	    ((fabs(v) < 0x1p-126) & (v != 0));
}

#endif
