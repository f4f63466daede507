/* SPDX-License-Identifier: MIT */
#include "../json/check.h"

#include "../json/value.h"

#include "refusal.h"

struct text {
	const char *s;
	size_t size;
	const char *line; /* the expected message, after "projcalc: s.json:" */
};

#define TEXT(s, line)                  \
	{                              \
		s, sizeof(s) - 1, line \
	}

/* Parses a text by value_parse_document, which prints the reason if json_check refuses
 * it. */
static void parse(const void *argument)
{
	struct json_source source = { .name = "s.json" };
	const struct text *t = argument;
	char *copy = malloc(t->size + 1);

	memcpy(copy, t->s, t->size);
	struct span none;

	value_parse_document(&source, "/none", copy, t->size, &none);
	free(copy);
}

static const struct text refused[] = {
	TEXT("", "1: expected a value, but the text ends"),
	TEXT(" \n", "2: expected a value, but the text ends"),
	TEXT("\xef\xbb\xbf", "1: expected a value, but the text ends"),
	TEXT("{\n\"a\":\n01}",
	    "3: expected a value, not '01'; a value is like -1.5e-3, true, null or "
	    "\"text\""),
	TEXT("[-012.50]",
	    "1: expected a value, not '-012.50'; a value is like -1.5e-3, true, null "
	    "or \"text\""),
	TEXT("[1.]",
	    "1: expected a value, not '1.'; a value is like -1.5e-3, true, null or "
	    "\"text\""),
	TEXT("[+1]",
	    "1: expected a value, not '+1'; a value is like -1.5e-3, true, null or "
	    "\"text\""),
	TEXT("[.5]",
	    "1: expected a value, not '.5'; a value is like -1.5e-3, true, null or "
	    "\"text\""),
	TEXT("[1.e5]",
	    "1: expected a value, not '1.e5'; a value is like -1.5e-3, true, null or "
	    "\"text\""),
	TEXT("[-]",
	    "1: expected a value, not '-'; a value is like -1.5e-3, true, null or "
	    "\"text\""),
	TEXT("[1e]",
	    "1: expected a value, not '1e'; a value is like -1.5e-3, true, null or "
	    "\"text\""),
	TEXT("[0x1]",
	    "1: expected a value, not '0x1'; a value is like -1.5e-3, true, null or "
	    "\"text\""),
	TEXT("[6\xc2\xb0]",
	    "1: expected a value, not '6\xc2\xb0'; a value is like -1.5e-3, true, null "
	    "or \"text\""),
	TEXT("[NaN]",
	    "1: expected a value, not 'NaN'; "
	    "a point may have null; in a scene write a number, or leave "
	    "the member out"),
	TEXT("[-nan]",
	    "1: expected a value, not '-nan'; "
	    "a point may have null; in a scene write a number, or leave "
	    "the member out"),
	TEXT("[Infinity]",
	    "1: expected a value, not 'Infinity'; "
	    "write \"infinity\" for far, else a number up to 1e150; a point "
	    "may have null"),
	TEXT("[-Infinity]",
	    "1: expected a value, not '-Infinity'; "
	    "write \"infinity\" for far, else a number up to 1e150; a point "
	    "may have null"),
	TEXT("[inf]",
	    "1: expected a value, not 'inf'; "
	    "write \"infinity\" for far, else a number up to 1e150; a point "
	    "may have null"),
	TEXT("[True]",
	    "1: expected a value, not 'True'; "
	    "JSON has true and false"),
	TEXT("[None]",
	    "1: expected a value, not 'None'; "
	    "a point may have null; in a scene write a number, or leave "
	    "the member out"),
	TEXT("[gl]",
	    "1: expected a value, not 'gl'; a value is like -1.5e-3, true, null or "
	    "\"text\""),
	TEXT("[truefalse]",
	    "1: expected a value, not 'truefalse'; a value is like -1.5e-3, true, null "
	    "or \"text\""),
	TEXT("['a']", "1: expected a value, not '''; JSON has \"double quotes\" alone"),
	TEXT("{'a':1}",
	    "1: expected a member's name in \"double quotes\", not '''; JSON "
	    "has \"double quotes\" alone"),
	TEXT("{eye:1}", "1: expected a member's name in \"double quotes\", not 'eye'"),
	TEXT("{1:1}", "1: expected a member's name in \"double quotes\", not '1'"),
	TEXT("{\"a\":0,\n 1}",
	    "2: expected a member's name in \"double quotes\", not '1'; "
	    "several numbers stand in brackets: [1,2,3]"),
	TEXT("{\"a\":16/9}", "1: expected ',' or '}', not '/'; JSON has no arithmetic"),
	TEXT("{\"a\":1,\n}",
	    "2: expected a member's name in \"double quotes\", not '}'; remove "
	    "the comma before it"),
	TEXT("[1,]", "1: expected a value, not ']'; remove the comma before it"),
	TEXT("[1,,2]", "1: expected a value, not ','"),
	TEXT("[,]", "1: expected a value, not ','"),
	TEXT("{,}", "1: expected a member's name in \"double quotes\", not ','"),
	TEXT("{\"a\" 1}", "1: expected ':' after the member's name, not '1'"),
	TEXT("{\"a\":}", "1: expected a value, not '}'"),
	TEXT("{\"a\":1\n\"b\":2}", "2: expected ',' or '}', not '\"'"),
	TEXT("[1 2]", "1: expected ',' or ']', not '2'"),
	TEXT("[1}", "1: expected ',' or ']', not '}'"),
	TEXT("[1/2]", "1: expected ',' or ']', not '/'; JSON has no arithmetic"),
	TEXT("[\x01]", "1: expected a value, not '\\u0001'"),
	TEXT("[\xff]", "1: expected a value, not '\\xff'; JSON is UTF-8 text"),
	TEXT("[\xc2\xa0]",
	    "1: expected a value, not '\\u00a0'; a value is like -1.5e-3, true, null "
	    "or \"text\""),
	TEXT("[\f1]", "1: expected a value, not '\\u000c'"),
	TEXT("{\n[1", "2: expected a member's name in \"double quotes\", not '['"),
	TEXT("{\n\"a\":[1\n\n",
	    "4: expected ',' or ']', but the text ends; the '[' is on line 2"),
	TEXT("{\"a\":1",
	    "1: expected ',' or '}', but the text ends; the '{' is on line 1"),
	TEXT("{\"a\"", "1: expected ':' after the member's name, but the text ends"),
	TEXT("{\"a\":", "1: expected a value, but the text ends"),
	TEXT("[", "1: expected a value, but the text ends"),
	TEXT("{}\n{}",
	    "2: expected the end of the text, not '{'; --scenes reads several "
	    "scenes"),
	TEXT("0 0 0\n", "1: expected the end of the text, not '0'"),
	TEXT("{}]", "1: expected the end of the text, not ']'"),
	TEXT("{} //",
	    "1: expected the end of the text, not '/'; comments are not JSON; "
	    "use a member \"_comment\""),
	TEXT("{} // x",
	    "1: expected the end of the text, not '/'; comments are not JSON; "
	    "use a member \"_comment\""),
	TEXT("{\n/* x */}",
	    "2: expected a member's name in \"double quotes\", not '/'; "
	    "comments are not JSON; use a member \"_comment\""),
	TEXT("# x\n{}",
	    "1: expected a value, not '#'; comments are not JSON; use a member "
	    "\"_comment\""),
	TEXT("[1 // x\n]",
	    "1: expected ',' or ']', not '/'; comments are not JSON; use a "
	    "member \"_comment\""),
	TEXT("[\"\\x\"]",
	    "1: expected an escape for a character, not '\\x'; a backslash "
	    "itself is \\\\"),
	TEXT("[\"\\",
	    "1: expected an escape for a character, not '\\'; a backslash "
	    "itself is \\\\"),
	TEXT("[\"\\u12g4\"]",
	    "1: expected an escape for a character, not '\\u12g4'; a backslash "
	    "itself is \\\\"),
	TEXT("[\"\\u12",
	    "1: expected an escape for a character, not '\\u12'; a backslash "
	    "itself is \\\\"),
	TEXT("{\"\\u0000\":1}",
	    "1: expected an escape for a character, not '\\u0000'; a backslash "
	    "itself is \\\\"),
	TEXT("[\"\\ud800\"]",
	    "1: expected an escape for a character, not '\\ud800'; a backslash "
	    "itself is \\\\"),
	TEXT("[\"\\ud800\\ud800\"]",
	    "1: expected an escape for a character, not '\\ud800\\ud800'; a "
	    "backslash itself is \\\\"),
	TEXT("[\"\\uDC00\\uD800\"]",
	    "1: expected an escape for a character, not '\\uDC00\\uD800'; a "
	    "backslash itself is \\\\"),
	TEXT("[\"\\ud83d\\ude00",
	    "1: expected text or '\"' in a string, but the text ends"),
	TEXT("[\"\\ud83d\\ude0",
	    "1: expected an escape for a character, not '\\ud83d\\ude0'; a "
	    "backslash itself is \\\\"),
	TEXT("[\"a\n\"]",
	    "1: expected text or '\"' in a string, not '\\u000a'; write a "
	    "control character as this escape"),
	TEXT("[\"a\r\"]",
	    "1: expected text or '\"' in a string, not '\\u000d'; write a "
	    "control character as this escape"),
	TEXT("[\"a", "1: expected text or '\"' in a string, but the text ends"),
	TEXT("[\"\t\"]",
	    "1: expected text or '\"' in a string, not '\\u0009'; write a "
	    "control character as this escape"),
	TEXT("\n{\"a\":\0}", "2: expected a value, not '\\u0000'; JSON is UTF-8 text"),
	TEXT("[\"\x80\"]",
	    "1: expected text or '\"' in a string, not '\\x80'; JSON is UTF-8 "
	    "text"),
	TEXT("[\"\xc0\x80\"]",
	    "1: expected text or '\"' in a string, not '\\xc0\\x80'; JSON is "
	    "UTF-8 text"), /* NUL in two bytes instead of one */
	TEXT("[\"\xc3\"]",
	    "1: expected text or '\"' in a string, not '\\xc3'; JSON is UTF-8 "
	    "text"),
	TEXT("[\"\xe0\x80\x80\"]",
	    "1: expected text or '\"' in a string, not '\\xe0\\x80\\x80'; JSON "
	    "is UTF-8 text"),
	TEXT("[\"\xed\xa0\x80\"]",
	    "1: expected text or '\"' in a string, not '\\xed\\xa0\\x80'; JSON "
	    "is UTF-8 text"), /* U+D800, a surrogate */
	TEXT("[\"\xf0\x8f\xbf\xbf\"]",
	    "1: expected text or '\"' in a string, not '\\xf0\\x8f\\xbf\\xbf'; "
	    "JSON is UTF-8 text"),
	TEXT("[\"\xf4\x90\x80\x80\"]",
	    "1: expected text or '\"' in a string, not '\\xf4\\x90\\x80\\x80'; "
	    "JSON is UTF-8 text"), /* U+110000 */
	TEXT("[\"\xf5\x80\x80\x80\"]",
	    "1: expected text or '\"' in a string, not '\\xf5\\x80\\x80\\x80'; "
	    "JSON is UTF-8 text"),
	TEXT("[\"\xe2\x82",
	    "1: expected text or '\"' in a string, not '\\xe2\\x82'; JSON is "
	    "UTF-8 text"),
};

static void test_refused(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
		char line[512];

		snprintf(line, sizeof line, "s.json:%s", refused[i].line);
		assert_refused(parse, &refused[i], refused[i].s, line);
	}
}

static void test_accepted(void **state)
{
	static const struct text accepted[] = {
		TEXT("{}", NULL),
		TEXT("[]", NULL),
		TEXT("null", NULL),
		TEXT("\xef\xbb\xbf \t\r\n{ \"a\" : [ true , false ] }\n", NULL),
		TEXT("[0,-0,-0.0e-0,1E+5,10.25e01,1e999,1e-999]", NULL),
		TEXT("[\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\ud83d\\uDE00\"]", NULL),
		TEXT("[\"\x7f\xc2\x80\xe0\xa0\x80\xed\x9f\xbf\xee\x80\x80"
		     "\xf0\x90\x80\x80\xf4\x8f\xbf\xbf // # '\"]",
		    NULL),
	};

	(void)state;
	for (size_t i = 0; i < sizeof accepted / sizeof *accepted; i++) {
		int status;

		assert_text(output_of(parse, &accepted[i], &status), "", accepted[i].s);
		assert_int_equal(status, 0);
	}
}

static void test_depth(void **state)
{
	char text[402];
	struct text t = { text, 400, NULL };
	int status;

	(void)state;
	memset(text, '[', 200);
	memset(text + 200, ']', 200);
	assert_string_equal(output_of(parse, &t, &status), "");
	memset(text, '[', 201);
	memset(text + 201, ']', 201);
	t.size = 402;
	assert_refused(parse, &t, "201 brackets",
	    "s.json:1: expected at most 200 levels of brackets, not '['");
}

/* A line of points, and its rest from the first error on, or NULL if it is JSON. */
struct line {
	const char *text, *rest;
};

static void test_lines(void **state)
{
	static const struct line lines[] = {
		{ "[1,2,3]", NULL },
		{ "\t[ 1\t,\r{\"a\"\r: [null, true]}\t] ", NULL },
		{ "\v[1]", "\v[1]" },
		{ "[1\f]", "\f]" },
		{ "[{\"a\":\v1}]", "\v1}]" },
		{ "[\"\xff\x80\x7f\",\"\\u0000\\ud800\\uDC00x\"]", NULL },
		{ "[-0, 0.10, 1E+5, 1e999]", NULL },
		{ "[1,]", "]" },
		{ "[1,,2]", ",2]" },
		{ "[1 2]", "2]" },
		{ "[1,+2]", "+2]" },
		{ "[1,01]", "01]" },
		{ "[1,2.]", "2.]" },
		{ "[1,2.e5]", "2.e5]" },
		{ "[1,.5]", ".5]" },
		{ "[1,-]", "-]" },
		{ "[1,2e]", "2e]" },
		{ "[1,2e+]", "2e+]" },
		{ "[1,2e5e]", "2e5e]" },
		{ "[1,2.5.3]", "2.5.3]" },
		{ "[1,2x]", "2x]" },
		{ "[1,truer]", "truer]" },
		{ "[1,True]", "True]" },
		{ "[1,nan]", "nan]" },
		{ "[1,'a']", "'a']" },
		{ "[1] 2", "2" },
		{ "[{a:1}]", "a:1}]" },
		{ "[{\"a\" 1}]", "1}]" },
		{ "[{\"a\":1,}]", "}]" },
		{ "[\"a\tb\"]", "\tb\"]" },
		{ "[\"a\\xb\"]", "\\xb\"]" },
		{ "[\"\\u12g4\"]", "\\u12g4\"]" },
		{ "[\"\\ug\"]", "\\ug\"]" },
		{ "[1}", "}" },
		{ "[1", "" },
		{ "[\"a", "" },
	};

	(void)state;
	for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
		const char *s = lines[i].text, *end = s + strlen(s);
		struct json_check c = { .is_line = true, .text = s, .end = end };

		assert_text(json_check(&c) ? NULL : c.at, lines[i].rest, s);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_refused),
		cmocka_unit_test(test_accepted),
		cmocka_unit_test(test_depth),
		cmocka_unit_test(test_lines),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
