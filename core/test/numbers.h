/* SPDX-License-Identifier: MIT */
/* Assertions about doubles and texts. Includes cmocka. */
#pragma once

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* Fails unless the doubles are equal, and prints both. */
#define assert_number(got, expected) \
	assert_number_at(got, expected, #got, __FILE__, __LINE__)

static inline void assert_number_at(double got, double expected, const char *name,
    const char *file, int line)
{
	if (got == expected)
		return;
	print_error("%s is %.17g, expected %.17g\n", name, got, expected);
	_fail(file, line);
}

/* Fails unless the texts are equal or both NULL, and prints both with the input. */
#define assert_text(got, expected, input) \
	assert_text_at(got, expected, input, __FILE__, __LINE__)

static inline void assert_text_at(const char *got, const char *expected,
    const char *input, const char *file, int line)
{
	if (got == NULL ? expected == NULL :
			  expected != NULL && strcmp(got, expected) == 0)
		return;
	print_error("%s: expected %s\n%s: came %s\n", input,
	    expected == NULL ? "none" : expected, input, got == NULL ? "none" : got);
	_fail(file, line);
}
