/* SPDX-License-Identifier: MIT */
#include "../message/escape.h"

#include <stdbool.h>

#include "../../core/test/numbers.h"

static void test_escaped(void **state)
{
	char out[ESCAPED_MAX], text[200];

	(void)state;
	assert_string_equal(escape_short(out, "a\x1b[m\x7f\xc2\x9b\xff\xc3\xa9", 10),
	    "a\\u001b[m\\u007f\\u009b\\xff\xc3\xa9");
	assert_string_equal(escape_short(out, "abc", 0), "");
	memset(text, 'a', sizeof text);
	escape_short(out, text, sizeof text);
	assert_string_equal(out + strlen(out) - 4, "a...");
	for (size_t at = 50; at < ESCAPED_MAX; at++) {
		text[at] = 1;
		escape_short(out, text, sizeof text);
		assert_string_equal(out + strlen(out) - 3, "...");
		assert_true(strlen(out) < ESCAPED_MAX);
		text[at] = 'a';
	}
	memset(text, 1, sizeof text);
	escape_short(out, text, sizeof text);
	assert_string_equal(out + strlen(out) - 9, "\\u0001...");
}

/* Characters that control output, end lines, are invisible or change the direction of
 * text are escaped. Here are the ends of their ranges, and neighbours that are not
 * escaped. */
static void test_which_are_escaped(void **state)
{
	static const struct {
		const char *s;
		bool escaped;
	} cases[] = {
		{ "\x1f", true },
		{ " ", false },
		{ "~", false },
		{ "\xc2\x80", true },
		{ "\xc2\x9f", true },
		{ "\xc2\xa0", true },
		{ "\xc2\xa1", false },
		{ "\xc2\xac", false },
		{ "\xc2\xad", true },
		{ "\xc2\xae", false },
		{ "\xd8\x9b", false },
		{ "\xd8\x9c", true },
		{ "\xe2\x80\x8a", false },
		{ "\xe2\x80\x8b", true },
		{ "\xe2\x80\x8d", true },
		{ "\xe2\x80\x8e", true },
		{ "\xe2\x80\x8f", true },
		{ "\xe2\x80\x90", false },
		{ "\xe2\x80\xa7", false },
		{ "\xe2\x80\xa8", true },
		{ "\xe2\x80\xae", true },
		{ "\xe2\x80\xaf", false },
		{ "\xe2\x81\x9f", false },
		{ "\xe2\x81\xa0", true },
		{ "\xe2\x81\xa4", true },
		{ "\xe2\x81\xa5", true }, /* assigned to nothing */
		{ "\xe2\x81\xa6", true },
		{ "\xe2\x81\xa9", true },
		{ "\xe2\x81\xaa", false },
		{ "\xef\xbb\xbe", false },
		{ "\xef\xbb\xbf", true },
		{ "\xf0\x9f\x98\x80", false },
	};
	char text[20], json[20];

	(void)state;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		const char *s = cases[i].s;

		escape_copy(text, sizeof text, s, strlen(s), false, "");
		escape_copy(json, sizeof json, s, strlen(s), true, "");
		assert_text(json, text, s);
		if (cases[i].escaped)
			text[2] = '\0';
		assert_text(text, cases[i].escaped ? "\\u" : s, s);
	}
}

/* However little room there is, escape_copy writes whole characters and escapes, and a
 * NUL. */
static void test_little_room(void **state)
{
	const char s[] = "a\"\\\n\xff\xc3\xa9",
		   all[] = "a\\\"\\\\\\u000a\\ufffd\xc3\xa9";
	char out[40];

	(void)state;
	for (size_t room = 1; room < sizeof out; room++) {
		memset(out, 'x', sizeof out);
		size_t n = escape_copy(out, room, s, sizeof s - 1, true, "");

		assert_true(n < room && out[n] == '\0');
		assert_memory_equal(out, all, n);
		assert_true(n == 0 || out[n - 1] != '\\' || n == 5);
	}
	assert_string_equal(out, all);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_escaped),
		cmocka_unit_test(test_which_are_escaped),
		cmocka_unit_test(test_little_room),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
