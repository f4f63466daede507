/* SPDX-License-Identifier: MIT */
/* Random numbers, the same in every run, and a guard page, for tests of numbers.
 * Includes cmocka. A test includes this header first. */
#pragma once

#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

#include "../../core/test/numbers.h"

/* Returns the next number of the generator xorshift64*. */
static inline uint64_t next_random(void)
{
	static uint64_t state = 88172645463325252;

	state ^= state << 13;
	state ^= state >> 7;
	state ^= state << 17;
	return state * 2685821657736338717u;
}

static inline int random_below(int n)
{
	return (int)(next_random() >> 33) % n;
}

/* Returns the start of a page whose access ends the program. The 65536 bytes before it
 * can be used. */
static inline char *guard_page(void)
{
	enum { PAGE = 65536 };
	char *start = mmap(NULL, 2 * PAGE, PROT_READ | PROT_WRITE,
	    MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);

	assert_true(start != MAP_FAILED);
	assert_int_equal(mprotect(start + PAGE, PAGE, PROT_NONE), 0);
	return start + PAGE;
}
