/* SPDX-License-Identifier: MIT */
/* Assertions about doubles. A file that includes this header includes cmocka.h before
 * it. */
#ifndef NUMBERS_H
#define NUMBERS_H

#include <math.h>

/* Fails unless the doubles are equal, and prints both. */
#define assert_number(got, expected) \
	assert_number_at(got, expected, #got, __FILE__, __LINE__)

static inline void assert_number_at(double got, double expected,
    const char *name, const char *file, int line)
{
	if (got == expected)
		return;
	print_error("%s is %.17g, expected %.17g\n", name, got, expected);
	_fail(file, line);
}

#endif
