/* SPDX-License-Identifier: MIT */
#include "../json/value.h"

#include "../../core/test/numbers.h"

/* Parses an array of n values, asserts n, and returns the first value, a number. */
static double first_number(const char *array, size_t n)
{
	struct json_source source = { .name = "s.json" };
	struct span none;
	char text[1024];

	strcpy(text, array);
	struct value v = value_parse_document(&source, "/none", text, strlen(text),
	    &none);
	struct value e = value_child(&v), last = e;

	for (; last.item != NULL; value_next(&last))
		n--;
	assert_int_equal(n, 0);
	return value_number(&e, &range_any);
}

/* Numbers of more digits than a double has are read correctly. */
static void test_long_numbers(void **state)
{
#define NINES20 "99999999999999999999"
#define ZEROS20 "00000000000000000000"
	(void)state;
	assert_number(first_number("[0." NINES20 NINES20 NINES20 "9]", 1), 1);
	assert_number(first_number("[0." NINES20 NINES20 NINES20 "99]", 1), 1);
	assert_number(first_number("[-0.1" ZEROS20 ZEROS20 ZEROS20 "1e0 , 2]", 2),
	    -0.1);
	assert_number(first_number("[1" ZEROS20 ZEROS20 ZEROS20 "e-60]", 1), 1);
	assert_number(first_number("[-1" NINES20 NINES20 NINES20 "99e-999]", 1), 0);
}

/* A member whose name begins with _ is left out, and all else is kept. */
static void test_hidden(void **state)
{
	(void)state;
	assert_number(first_number("{\"_a\" : [{\"b\":\"}\"}] , \"c\":3}", 1), 3);
	assert_number(first_number("{\"c\":3,\"_a\":{}, \"_\" :null}", 1), 3);
	assert_number(first_number("{\"c\":3,\"_\":0,\"d_\":\"_e\"}", 2), 3);
	assert_number(first_number("[4,\"_a\",{\"_\":1}]", 3), 4);
	assert_number(first_number("{\"_\":\"1\",\"c\":5}", 1), 5);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_long_numbers),
		cmocka_unit_test(test_hidden),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
