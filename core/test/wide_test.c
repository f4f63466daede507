/* SPDX-License-Identifier: MIT */
/* Compares the functions of wide.h that 32-bit compilers use with integers of 128
 * bits, for words of every length and near 0 and 2^64. */
#ifdef __SIZEOF_INT128__
#define HAS_WIDE
#undef __SIZEOF_INT128__
#endif
#include "../exact/wide.h"

#include <stdio.h>

#include "claims.h"

#ifdef HAS_WIDE
typedef unsigned __int128 wide;

enum { TRIES = 200000 };

static uint64_t any_word(void)
{
	uint64_t w = (uint64_t)sample_below(1 << 16) << 48 |
	    (uint64_t)sample_below(1 << 16) << 32 |
	    (uint64_t)sample_below(1 << 16) << 16 | sample_below(1 << 16);

	w >>= sample_below(64);
	return sample_below(4) ? w : sample_below(2) ? w % 3 : -(w % 3);
}

static wide wide_of_words(uint64_t high, uint64_t low)
{
	return (wide)high << 64 | low;
}

static void products(void **state)
{
	(void)state;
	SAMPLES(i, TRIES) {
		uint64_t a = any_word(), b = any_word(), c = any_word();
		uint64_t before = any_word(), carry = before;
		uint64_t p = wide_multiply_add(a, b, c, &carry);

		assert_true(wide_of_words(carry, p) == (wide)a * b + c + before);
	}
}

static void quotients(void **state)
{
	(void)state;
	SAMPLES(i, TRIES) {
		uint64_t d = any_word() | 1, high = any_word() % d;
		uint64_t low = any_word(), q = wide_divide(high, low, d);

		assert_true(q == wide_of_words(high, low) / d);
	}
}
#endif

int main(void)
{
#ifdef HAS_WIDE
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(products),
		cmocka_unit_test(quotients),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
#else
	puts("1..0 # SKIP no integers of 128 bits to compare with");
	return 0;
#endif
}
