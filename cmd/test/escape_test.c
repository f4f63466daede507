#include "../escape.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static void test_escaped(void **state)
{
	char out[ESCAPED_MAX], text[200];

	(void)state;
	assert_string_equal(escaped(out, "a\x1b[m\x7f\xc2\x9b\xff\xc3\xa9", 10),
	    "a\\u001b[m\\u007f\\u009b\\xff\xc3\xa9");
	assert_string_equal(escaped(out, "abc", 0), "");
	memset(text, 'a', sizeof text);
	escaped(out, text, sizeof text);
	assert_string_equal(out + strlen(out) - 4, "a...");
	memset(text, 1, sizeof text);
	escaped(out, text, sizeof text);
	assert_string_equal(out + strlen(out) - 9, "\\u0001...");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_escaped),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
