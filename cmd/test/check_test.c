/* SPDX-License-Identifier: MIT */
#include "../json/check.h"

#include "../json/value.h"

#include "refusal.h"

struct text {
	const char *s;
	size_t size;
	const char *line; /* of the refusal, after "projcalc: s.json:" */
};

#define TEXT(s, line)                  \
	{                              \
		s, sizeof(s) - 1, line \
	}

/* By value_parse_without, which prints what json_check says. */
static void check(const void *argument)
{
	struct source source = { .name = "s.json" };
	const struct text *t = argument;
	char *copy = malloc(t->size + 1);

	memcpy(copy, t->s, t->size);
	struct span none;

	value_parse_without(&source, "none", copy, t->size, &none);
	free(copy);
}

#define COMMENTS "comments are not JSON; use a member \"_comment\""
#define EMPTY "1: the document is empty; expected a JSON value"
#define AFTER "text after the document; one JSON value is wanted"
#define INFINITE "is not JSON; only \"far\" can be \"infinity\""

static const struct text refused[] = {
	TEXT("", EMPTY),
	TEXT(" \n", "2: the document is empty; expected a JSON value"),
	TEXT("\xef\xbb\xbf", EMPTY),
	TEXT("{\n\"a\":\n01}", "3: '01' is not a JSON number; write 1"),
	TEXT("[-012.50]", "1: '-012.50' is not a JSON number; write -12.5"),
	TEXT("[1.]", "1: '1.' is not a JSON number; write 1"),
	TEXT("[+1]", "1: '+1' is not a JSON number; write 1"),
	TEXT("[.5]", "1: '.5' is not a JSON number; write 0.5"),
	TEXT("[1.e5]", "1: '1.e5' is not a JSON number; write 100000"),
	TEXT("[-]", "1: '-' is not a JSON number; write it like -1.5e-3"),
	TEXT("[1e]", "1: '1e' is not a JSON number; write it like -1.5e-3"),
	TEXT("[0x1]", "1: '0x1' is not a JSON number; write it like -1.5e-3"),
	TEXT("[6\xc2\xb0]",
	    "1: '6\xc2\xb0' is not a JSON number; write it like -1.5e-3"),
	TEXT("[NaN]", "1: 'NaN' is not JSON; an unknown coordinate is null"),
	TEXT("[-nan]", "1: '-nan' is not JSON; an unknown coordinate is null"),
	TEXT("[Infinity]", "1: 'Infinity' " INFINITE),
	TEXT("[-Infinity]", "1: '-Infinity' " INFINITE),
	TEXT("[inf]", "1: 'inf' " INFINITE),
	TEXT("[True]", "1: 'True' is not JSON; write true"),
	TEXT("[None]", "1: 'None' is not JSON; write null"),
	TEXT("[gl]", "1: 'gl' is not JSON; text needs \"double quotes\""),
	TEXT("[truefalse]",
	    "1: 'truefalse' is not JSON; text needs \"double quotes\""),
	TEXT("['a']", "1: 'single quotes' are not JSON; use \"double\" ones"),
	TEXT("{'a':1}", "1: 'single quotes' are not JSON; use \"double\" ones"),
	TEXT("{eye:1}", "1: the name eye has no quotes; write \"eye\""),
	TEXT("{1:1}", "1: expected a member's name in quotes, not '1'"),
	TEXT("{\"a\":0,\n 1}",
	    "2: expected a member's name in quotes, not '1'; several numbers "
	    "stand in brackets: [1,2,3]"),
	TEXT("{\"a\":16/9}",
	    "1: JSON has no arithmetic, and '/' is not ',' or '}'; write the "
	    "number that it gives"),
	TEXT("{\"a\":1,\n}", "2: trailing comma before '}'; remove it"),
	TEXT("[1,]", "1: trailing comma before ']'; remove it"),
	TEXT("[1,,2]", "1: expected a value, not ','"),
	TEXT("[,]", "1: expected a value, not ','"),
	TEXT("{,}", "1: expected a member's name in quotes, not ','"),
	TEXT("{\"a\" 1}", "1: expected ':' after the member's name, not '1'"),
	TEXT("{\"a\":}", "1: expected a value, not '}'"),
	TEXT("{\"a\":1\n\"b\":2}", "2: expected ',' or '}', not '\"'"),
	TEXT("[1 2]", "1: expected ',' or ']', not '2'"),
	TEXT("[1}", "1: expected ',' or ']', not '}'"),
	TEXT("[1/2]",
	    "1: JSON has no arithmetic, and '/' is not ',' or ']'; write the "
	    "number that it gives"),
	TEXT("[\x01]", "1: expected a value, not '\\u0001'"),
	TEXT("[\xff]", "1: expected a value, not '\\xff'"),
	TEXT("[\xc2\xa0]",
	    "1: expected a value, not '\\u00a0' (U+00A0 in it can't be seen)"),
	TEXT("[\f1]", "1: expected a value, not '\\u000c'"),
	TEXT("{\n[1", "2: expected a member's name in quotes, not '['"),
	TEXT("{\n\"a\":[1\n\n", "4: the text ends; add ']' for '[' of line 2"),
	TEXT("{\"a\":1", "1: the text ends; add '}' for '{' of line 1"),
	TEXT("{\"a\"",
	    "1: expected ':' after the member's name, but the text ends"),
	TEXT("{\"a\":", "1: expected a value, but the text ends"),
	TEXT("[", "1: expected a value, but the text ends"),
	TEXT("{}\n{}", "2: " AFTER),
	TEXT("0 0 0\n", "1: " AFTER),
	TEXT("{}]", "1: " AFTER),
	TEXT("{} //", "1: " COMMENTS),
	TEXT("{} // x", "1: " COMMENTS),
	TEXT("{\n/* x */}", "2: " COMMENTS),
	TEXT("# x\n{}", "1: " COMMENTS),
	TEXT("[1 // x\n]", "1: " COMMENTS),
	TEXT("[\"\\x\"]", "1: \\x is no escape of JSON; a backslash is \\\\"),
	TEXT("[\"\\", "1: \\ is no escape of JSON; a backslash is \\\\"),
	TEXT("[\"\\u12g4\"]",
	    "1: \\u in a string needs four hexadecimal digits"),
	TEXT("[\"\\u12", "1: \\u in a string needs four hexadecimal digits"),
	TEXT("{\"\\u0000\":1}",
	    "1: \\u0000 in a string is not supported; leave it out"),
	TEXT("[\"\\ud800\"]",
	    "1: \\ud800 is half of a surrogate pair; write both"),
	TEXT("[\"\\ud800\\ud800\"]",
	    "1: \\ud800 is half of a surrogate pair; write both"),
	TEXT("[\"\\uDC00\\uD800\"]",
	    "1: \\udc00 is half of a surrogate pair; write both"),
	TEXT("[\"\\ud83d\\ude00", "1: a string is not closed; add '\"'"),
	TEXT("[\"\\ud83d\\ude0",
	    "1: \\ud83d is half of a surrogate pair; write both"),
	TEXT("[\"a\n\"]", "1: a string is not closed on its line; add '\"'"),
	TEXT("[\"a\r\"]", "1: a string is not closed on its line; add '\"'"),
	TEXT("[\"a", "1: a string is not closed; add '\"'"),
	TEXT("[\"\t\"]", "1: control character in a string; write \\u0009"),
	TEXT("\n{\"a\":\0}", "2: a NUL byte; JSON is UTF-8 text"),
#define NO_UTF8(byte) "1: byte 0x" byte " is not UTF-8; JSON is UTF-8 text"
	TEXT("[\"\x80\"]", NO_UTF8("80")),
	TEXT("[\"\xc0\x80\"]", NO_UTF8("c0")), /* an overlong NUL */
	TEXT("[\"\xc3\"]", NO_UTF8("c3")),
	TEXT("[\"\xe0\x80\x80\"]", NO_UTF8("e0")),
	TEXT("[\"\xed\xa0\x80\"]", NO_UTF8("ed")), /* a surrogate */
	TEXT("[\"\xf0\x8f\xbf\xbf\"]", NO_UTF8("f0")),
	TEXT("[\"\xf4\x90\x80\x80\"]", NO_UTF8("f4")), /* U+110000 */
	TEXT("[\"\xf5\x80\x80\x80\"]", NO_UTF8("f5")),
	TEXT("[\"\xe2\x82", NO_UTF8("e2")),
};

static void test_refused(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
		char line[512];

		snprintf(line, sizeof line, "s.json:%s", refused[i].line);
		assert_refused(check, &refused[i], line);
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
		TEXT("[\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\ud83d\\uDE00\"]",
		    NULL),
		TEXT("[\"\x7f\xc2\x80\xe0\xa0\x80\xed\x9f\xbf\xee\x80\x80"
		     "\xf0\x90\x80\x80\xf4\x8f\xbf\xbf // # '\"]",
		    NULL),
	};

	(void)state;
	for (size_t i = 0; i < sizeof accepted / sizeof *accepted; i++) {
		int status;

		assert_string_equal(output_of(check, &accepted[i], &status),
		    "");
		assert_int_equal(status, 0);
	}
}

static void test_depth(void **state)
{
	char text[202];
	struct text t = { text, 200, NULL };
	int status;

	(void)state;
	memset(text, '[', 100);
	memset(text + 100, ']', 100);
	assert_string_equal(output_of(check, &t, &status), "");
	memset(text, '[', 101);
	memset(text + 101, ']', 101);
	t.size = 202;
	assert_refused(check, &t, "s.json:1: more than 100 levels of brackets");
}

/* A line of points, and what is left of it where it goes wrong; NULL where it
 * is right. */
struct line {
	const char *text, *left;
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
		{ "[1,2e5e]", "e]" },
		{ "[1,2.5.3]", ".3]" },
		{ "[1,2x]", "x]" },
		{ "[1,truer]", "r]" },
		{ "[1,True]", "True]" },
		{ "[1,nan]", "nan]" },
		{ "[1,'a']", "'a']" },
		{ "[1] 2", "2" },
		{ "[{a:1}]", "a:1}]" },
		{ "[{\"a\" 1}]", "1}]" },
		{ "[{\"a\":1,}]", "}]" },
		{ "[\"a\tb\"]", "\tb\"]" },
		{ "[\"a\\xb\"]", "\\xb\"]" },
		{ "[\"\\u12g4\"]", "2g4\"]" },
		{ "[\"\\ug\"]", "ug\"]" },
		{ "[1}", "}" },
		{ "[1", "" },
		{ "[\"a", "" },
	};

	(void)state;
	for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
		const char *s = lines[i].text, *end = s + strlen(s);
		struct json_error e = { NULL, 0, "" };
		bool ok = json_check(JSON_LINE, s, end, &e);

		assert_int_equal(ok, lines[i].left == NULL);
		if (!ok)
			assert_string_equal(e.at, lines[i].left);
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
