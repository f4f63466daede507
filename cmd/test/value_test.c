/* SPDX-License-Identifier: MIT */
#include "../json/value.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/* The values of an array or object, with their names. */
static void assert_values(const char *json, const char *wanted)
{
	struct source source = { .name = "s.json" };
	char text[100], got[100], *at = got;

	memcpy(text, json, strlen(json));
	struct value root = value_parse(&source, "passed", text, strlen(json));
	struct value v = value_child(&root);

	for (; v.s != NULL; value_next(&v))
		at += sprintf(at, "%zu%s<%.*s>", v.index, v.name,
		    (int)(v.after - v.s), v.s);
	*at = '\0';
	assert_string_equal(got, wanted);
}

static void test_values(void **state)
{
	(void)state;
	assert_values("[]", "");
	assert_values("{ \n}", "");
	assert_values("17", "");
	assert_values(" [1]", "0<1>");
	assert_values("[ \"a:,\" , [2, {}],\n\t{\"b\":3} ]",
	    "0<\"a:,\" >1<[2, {}]>2<{\"b\":3} >");
	assert_values("{\"a\":1, \"\\\"\\u0041}\" : [2], \"c\":\"d\"}",
	    "0a<1>1\"A}<[2]>2c<\"d\">");
	assert_values("{\"passed\": [[1,2],3] ,\"c\":[4]}",
	    "0passed<[[1,2],3] >1c<[4]>");
}

/* A name is cut between two characters. */
static void test_long_names(void **state)
{
	struct source source = { .name = "s.json" };
	char text[400], name[NAME_ROOM];

	(void)state;
	for (int n = NAME_ROOM - 6; n < NAME_ROOM + 100; n++) {
		int size = sprintf(text, "{\"%0*d\\u20ac\":\"%0*d\"}", n, 0, n,
		    0);
		struct value root = value_parse(&source, NULL, text,
		    (size_t)size);
		struct value v = value_child(&root);
		int whole = n < NAME_ROOM ? n : NAME_ROOM - 1;

		assert_int_equal(strlen(v.name),
		    n + 3 < NAME_ROOM ? n + 3 : whole);
		assert_int_equal(strlen(value_string(&v, name)), whole);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_values),
		cmocka_unit_test(test_long_names),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
