/* SPDX-License-Identifier: MIT */
#include "../json/text.h"

#include <stdio.h>

#include "../../core/test/numbers.h"

/* A text, and the expected result: the rest of the text after its number or item, or
 * NULL if no number begins the text; for test_unescape the character. */
struct example {
	const char *text, *expected;
};

static void test_number(void **state)
{
	static const struct example numbers[] = {
		{ "-1.5e+3,", "," },
		{ "0", "" },
		{ "10x", "x" },
		{ "1e5e5", "e5" },
		{ "", NULL },
		{ "-", NULL },
		{ "01", NULL },
		{ "-00", NULL },
		{ "1.", NULL },
		{ "1.e1", NULL },
		{ "1E", NULL },
		{ "1e-", NULL },
		{ ".5", NULL },
		{ "+1", NULL },
		{ "inf", NULL },
		{ "-nan", NULL },
	};
	double v;

	(void)state;
	for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
		const char *s = numbers[i].text;
		const char *e = json_number(s, s + strlen(s), &v);

		assert_text(e, numbers[i].expected, s);
	}
	json_number("-1.5e+3", &"-1.5e+3"[7], &v);
	assert_number(v, -1500);
}

/* json_number ends at the first byte that cannot be in a number, wherever it stands. */
static void test_digits(void **state)
{
	char text[32];

	(void)state;
	for (size_t n = 1; n <= sizeof text; n++)
		for (size_t i = 1; i < n; i++)
			for (int c = 0; c < 256; c++) {
				memset(text, '9', n);
				text[i] = (char)c;
				if (strchr("0123456789.eE", c) == NULL || c == 0)
					assert_ptr_equal(json_number(text, text + n,
							     NULL),
					    text + i);
			}
}

/* json_number finds the same end with and without a place for the value, in every text
 * of up to six of these characters. */
static void test_number_end(void **state)
{
	const char some[] = "01.eE+-x";
	char text[6];

	(void)state;
	for (unsigned k = 0; k < 1u << 18; k++)
		for (size_t n = 0; n <= sizeof text; n++) {
			double v;

			for (size_t i = 0; i < n; i++)
				text[i] = some[k >> 3 * i & 7];
			assert_ptr_equal(json_number(text, text + n, NULL),
			    json_number(text, text + n, &v));
		}
}

/* json_item_end skips commas in quotes and brackets, also if the text is not JSON. */
static void test_skip(void **state)
{
	static const struct example values[] = {
		{ "1 ,2", ",2" },
		{ "1]", "]" },
		{ "a'b:c}", "}" },
		{ "[1,{\"]\":2}] ,3", ",3" },
		{ "[1,2}]", "]" },
		{ "\"a\\\",\\\\\",3", ",3" },
		{ "\"a,", "" },
		{ "\"a\\", "" },
		{ "[1,2", "" },
		{ "", "" },
	};

	(void)state;
	for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
		const char *s = values[i].text;

		assert_text(json_item_end(s, s + strlen(s)), values[i].expected, s);
	}
}

static void test_unescape(void **state)
{
	static const struct example escapes[] = {
		{ "\\n", "\n" },
		{ "\\\"", "\"" },
		{ "\\/", "/" },
		{ "\\b", "\b" },
		{ "\\u0041", "A" },
		{ "\\u00E9", "\xc3\xa9" },
		{ "\\u20ac", "\xe2\x82\xac" },
		{ "\\uD83d\\uDe00", "\xf0\x9f\x98\x80" },
		{ "\\ud83d", "\xef\xbf\xbd" },
		{ "\\udc00", "\xef\xbf\xbd" },
	};
	static const char two_high_surrogates[] = "\\ud800\\ud800";
	char out[5];
	int n;

	(void)state;
	for (size_t i = 0; i < sizeof escapes / sizeof *escapes; i++) {
		const char *s = escapes[i].text, *end = s + strlen(s);

		assert_ptr_equal(json_unescape(s, end, out, &n), end);
		out[n] = '\0';
		assert_text(out, escapes[i].expected, s);
	}
	assert_ptr_equal(json_unescape(two_high_surrogates, two_high_surrogates + 12,
			     out, &n),
	    two_high_surrogates + 6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_number),
		cmocka_unit_test(test_digits),
		cmocka_unit_test(test_number_end),
		cmocka_unit_test(test_skip),
		cmocka_unit_test(test_unescape),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
