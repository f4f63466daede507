/* SPDX-License-Identifier: MIT */
#include "../json/value.h"

#include "../../core/test/numbers.h"

/* Parses an array of n values, asserts n, and returns the first value, a number. */
static double first_number(const char *array, size_t n)
{
	static struct refusals faults;
	struct json_source source = { .name = "s.json", .faults = &faults };
	struct span points;
	struct value v;
	char copy[1024];
	double x;

	strcpy(copy, array);
	assert_true(value_parse_document(&source, copy, strlen(copy), &v, &points));
	struct value e = value_child(&v), last = e;

	for (; last.item != NULL; value_next(&last))
		n--;
	assert_int_equal(n, 0);
	assert_true(value_number(&e, &range_any, &x));
	return x;
}

/* Numbers of more digits than a double has are read correctly, up to the 63 characters
 * that every cJSON reads. */
static void test_long_numbers(void **state)
{
#define NINES20 "99999999999999999999"
#define ZEROS20 "00000000000000000000"
	(void)state;
	assert_number(first_number("[0." NINES20 NINES20 NINES20 "9]", 1), 1);
	assert_number(first_number("[-0.1" ZEROS20 ZEROS20 "1e0 , 2]", 2), -0.1);
	assert_number(first_number("[1" ZEROS20 ZEROS20 "e-40]", 1), 1);
	assert_number(first_number("[-1" NINES20 NINES20 "99e-999]", 1), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_long_numbers),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
