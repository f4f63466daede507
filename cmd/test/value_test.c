/* SPDX-License-Identifier: MIT */
#include "../json/value.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static void parse(char *text, size_t size)
{
	const struct source source = { .name = "s.json" };
	struct span none;
	struct value v = value_parse_without(&source, "none", text, size,
	    &none);

	value_free(&v);
}

/* A number of 63 characters stays as it is; one of 64 becomes the shortest text
 * of the same double, with blanks in the place of the rest. */
static void test_long_numbers(void **state)
{
#define NINES20 "99999999999999999999"
	char kept[] = "[0." NINES20 NINES20 NINES20 "9]";
	char cut[] = "[0." NINES20 NINES20 NINES20 "99]";
	char tenth[] = "[-0.100000000000000000000000000000000000000000000000000"
		       "00000000000000000000000000e0 , 2]";
	char huge[] = "[1" NINES20 NINES20 NINES20 "99e999]";
	char tiny[] = "[-1" NINES20 NINES20 NINES20 "99e-999]";

	(void)state;
	parse(kept, sizeof kept - 1);
	assert_string_equal(kept, "[0." NINES20 NINES20 NINES20 "9]");
	parse(cut, sizeof cut - 1);
	assert_int_equal(strlen(cut), sizeof cut - 1);
	assert_memory_equal(cut, "[1  ", 4);
	assert_int_equal(strspn(cut + 2, " "), sizeof cut - 4);
	parse(tenth, sizeof tenth - 1);
	assert_memory_equal(tenth, "[-0.1 ", 6);
	assert_string_equal(strchr(tenth, ','), ", 2]");
	parse(huge, sizeof huge - 1);
	assert_memory_equal(huge, "[1e999 ", 7);
	parse(tiny, sizeof tiny - 1);
	assert_memory_equal(tiny, "[0 ", 3);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_long_numbers),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
