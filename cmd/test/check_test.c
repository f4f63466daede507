/* SPDX-License-Identifier: MIT */
#include "../table/check.h"

#include "../json/value.h"

#include "../../core/test/numbers.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct refusals faults;

/* Parses a text, and writes "LINE:COLUMN: WHAT; REMEDY" if it is refused. */
static void parse(const char *text, size_t size, char out[1024])
{
	struct json_source source = { .name = "s.json", .faults = &faults };
	const struct refusal *r = &faults.list[0];
	char *copy = malloc(size + 1);
	struct span points;
	struct value v;

	faults.n = 0;
	memcpy(copy, text, size);
	*out = '\0';
	if (!value_parse_document(&source, copy, size, &v, &points))
		snprintf(out, 1024, "%lld:%zu: %s%s%s", r->line, r->column, r->what,
		    *r->remedy != '\0' ? "; " : "", r->remedy);
	free(copy);
}

static const struct {
	const char *text, *refusal;
} texts[] = {
	{ "", "1:1: expected a value, but the text ends" },
	{ " \n", "2:1: expected a value, but the text ends" },
	{ "\xef\xbb\xbf", "1:4: expected a value, but the text ends" },
	{ "{\n\"a\":\n01}", "3:1: expected a value, not '01'" },
	{ "[-012.50]", "1:2: expected a value, not '-012.50'" },
	{ "[1.]", "1:2: expected a value, not '1.'" },
	{ "[+1]", "1:2: expected a value, not '+1'" },
	{ "[.5]", "1:2: expected a value, not '.5'" },
	{ "[1.e5]", "1:2: expected a value, not '1.e5'" },
	{ "[-]", "1:2: expected a value, not '-'" },
	{ "[1e]", "1:3: expected ',' or ']', not 'e'" },
	{ "[0x1]", "1:3: expected ',' or ']', not 'x1'" },
	{ "[6\xc2\xb0]", "1:3: expected ',' or ']', not '\xc2\xb0'" },
	{ "[NaN]", "1:2: expected a value, not 'NaN'" },
	{ "[-nan]", "1:2: expected a value, not '-nan'" },
	{ "[Infinity]", "1:2: expected a value, not 'Infinity'" },
	{ "[-Infinity]", "1:2: expected a value, not '-Infinity'" },
	{ "[inf]", "1:2: expected a value, not 'inf'" },
	{ "[True]", "1:2: expected a value, not 'True'" },
	{ "[None]", "1:2: expected a value, not 'None'" },
	{ "[gl]", "1:2: expected a value, not 'gl'" },
	{ "[truefalse]", "1:6: expected ',' or ']', not 'false'" },
	{ "['a']",
	    "1:2: expected a value, not ''a''; JSON has \"double quotes\" alone" },
	{ "{'a':1}",
	    "1:2: expected a member's name in \"double quotes\", not ''a''; JSON has "
	    "\"double quotes\" alone" },
	{ "{eye:1}", "1:2: expected a member's name in \"double quotes\", not 'eye'" },
	{ "{1:1}", "1:2: expected a member's name in \"double quotes\", not '1'" },
	{ "{\"a\":0,\n 1}",
	    "2:2: expected a member's name in \"double quotes\", not '1'" },
	{ "{\"a\":16/9}", "1:8: expected ',' or '}', not '/9'" },
	{ "{\"a\":1,\n}",
	    "2:1: expected a member's name in \"double quotes\", not '}'; remove the "
	    "comma before it" },
	{ "[1,]", "1:4: expected a value, not ']'; remove the comma before it" },
	{ "[1,,2]", "1:4: expected a value, not ','" },
	{ "[,]", "1:2: expected a value, not ','" },
	{ "{,}", "1:2: expected a member's name in \"double quotes\", not ','" },
	{ "{\"a\" 1}", "1:6: expected ':' after the member's name, not '1'" },
	{ "{\"a\":}", "1:6: expected a value, not '}'" },
	{ "{\"a\":1\n\"b\":2}", "2:1: expected ',' or '}', not '\"'" },
	{ "[1 2]", "1:4: expected ',' or ']', not '2'" },
	{ "[1}", "1:3: expected ',' or ']', not '}'" },
	{ "[1/2]", "1:3: expected ',' or ']', not '/2'" },
	{ "[\x01]", "1:2: a control character is no JSON" },
	{ "[\xff]", "1:2: expected a value, not '\\xff'" },
	{ "[\xc2\xa0]", "1:2: expected a value, not '\\u00a0'" },
	{ "[\f1]", "1:2: a control character is no JSON" },
	{ "{\n[1", "2:1: expected a member's name in \"double quotes\", not '['" },
	{ "{\n\"a\":[1\n\n",
	    "4:1: expected ',' or ']', but the text ends; the '[' on line 2 is not "
	    "closed" },
	{ "{\"a\":1",
	    "1:7: expected ',' or '}', but the text ends; the '{' on line 1 is not "
	    "closed" },
	{ "{\"a\"",
	    "1:5: expected ':' after the member's name, but the text ends; the '{' on "
	    "line 1 is not closed" },
	{ "{\"a\":",
	    "1:6: expected a value, but the text ends; the '{' on line 1 is not "
	    "closed" },
	{ "[",
	    "1:2: expected a value, but the text ends; the '[' on line 1 is not "
	    "closed" },
	{ "{}\n{}",
	    "2:1: expected the end of the text, not '{'; --scenes reads several "
	    "scenes" },
	{ "0 0 0\n", "1:3: expected the end of the text, not '0'" },
	{ "{}]", "1:3: expected the end of the text, not ']'" },
	{ "{} //",
	    "1:4: expected the end of the text, not '//'; comments are not JSON; use a "
	    "member \"_comment\"" },
	{ "{} // x",
	    "1:4: expected the end of the text, not '//'; comments are not JSON; use a "
	    "member \"_comment\"" },
	{ "{\n/* x */}",
	    "2:1: expected a member's name in \"double quotes\", not '/*'; comments "
	    "are not JSON; use a member \"_comment\"" },
	{ "# x\n{}",
	    "1:1: expected a value, not '#'; comments are not JSON; use a member "
	    "\"_comment\"" },
	{ "[1 // x\n]",
	    "1:4: expected ',' or ']', not '//'; comments are not JSON; use a member "
	    "\"_comment\"" },
	{ "[\"\\x\"]", "1:3: '\\x' is in a string; a backslash itself is \\\\" },
	{ "[\"\\",
	    "1:4: expected '\"' at the end of a string, but the text ends; the '[' on "
	    "line 1 is not closed" },
	{ "[\"\\u12g4\"]",
	    "1:3: '\\u12g4' is in a string; \\u has four hexadecimal digits, and is "
	    "not 0" },
	{ "[\"\\u12",
	    "1:7: expected '\"' at the end of a string, but the text ends; the '[' on "
	    "line 1 is not closed" },
	{ "{\"\\u0000\":1}",
	    "1:3: '\\u0000' is in a string; \\u has four hexadecimal digits, and is "
	    "not 0" },
	{ "[\"\\ud800\"]",
	    "1:3: '\\ud800' is in a string; it is half of a surrogate pair" },
	{ "[\"\\ud800\\ud800\"]",
	    "1:3: '\\ud800' is in a string; it is half of a surrogate pair" },
	{ "[\"\\uDC00\\uD800\"]",
	    "1:3: '\\uDC00' is in a string; it is half of a surrogate pair" },
	{ "[\"\\ud83d\\ude00",
	    "1:15: expected '\"' at the end of a string, but the text ends; the '[' on "
	    "line 1 is not closed" },
	{ "[\"\\ud83d\\ude0",
	    "1:14: expected '\"' at the end of a string, but the text ends; the '[' on "
	    "line 1 is not closed" },
	{ "[\"a\n\"]", "1:4: a control character is in a string; write \\u000a" },
	{ "[\"a\r\"]", "1:4: a control character is in a string; write \\u000d" },
	{ "[\"a",
	    "1:4: expected '\"' at the end of a string, but the text ends; the '[' on "
	    "line 1 is not closed" },
	{ "[\"\t\"]", "1:3: a control character is in a string; write \\u0009" },
	{ "[\"\x80\"]",
	    "1:3: a byte is not UTF-8; iconv -f LATIN1 -t UTF-8 makes UTF-8 of "
	    "Latin-1" },
	{ "[\"\xc0\x80\"]",
	    "1:3: a byte is not UTF-8; iconv -f LATIN1 -t UTF-8 makes UTF-8 of "
	    "Latin-1" },
	{ "[\"\xc3\"]",
	    "1:3: a byte is not UTF-8; iconv -f LATIN1 -t UTF-8 makes UTF-8 of "
	    "Latin-1" },
	{ "[\"\xe0\x80\x80\"]",
	    "1:3: a byte is not UTF-8; iconv -f LATIN1 -t UTF-8 makes UTF-8 of "
	    "Latin-1" },
	{ "[\"\xed\xa0\x80\"]",
	    "1:3: a byte is not UTF-8; iconv -f LATIN1 -t UTF-8 makes UTF-8 of "
	    "Latin-1" },
	{ "[\"\xf0\x8f\xbf\xbf\"]",
	    "1:3: a byte is not UTF-8; iconv -f LATIN1 -t UTF-8 makes UTF-8 of "
	    "Latin-1" },
	{ "[\"\xf4\x90\x80\x80\"]",
	    "1:3: a byte is not UTF-8; iconv -f LATIN1 -t UTF-8 makes UTF-8 of "
	    "Latin-1" },
	{ "[\"\xf5\x80\x80\x80\"]",
	    "1:3: a byte is not UTF-8; iconv -f LATIN1 -t UTF-8 makes UTF-8 of "
	    "Latin-1" },
	{ "[\"\xe2\x82",
	    "1:3: a byte is not UTF-8; iconv -f LATIN1 -t UTF-8 makes UTF-8 of "
	    "Latin-1" },
	/* an empty object is no name, and the last byte may be what is wrong */
	{ "{\"a\":{}\"b\":1}", "1:8: expected ',' or '}', not '\"'" },
	{ "{\"a\":[{}5]}", "1:9: expected ',' or ']', not '5'" },
	{ "{\"a\":[1}", "1:8: expected ',' or ']', not '}'" },
	{ "{\"a\":[1,]", "1:9: expected a value, not ']'; remove the comma before it" },
	{ "{\"a\":t", "1:6: expected a value, not 't'" },
	{ "{}", "" },
	{ "[]", "" },
	{ "null", "" },
	{ "\xef\xbb\xbf \t\r\n{ \"a\" : [ true , false ] }\n", "" },
	{ "[0,-0,-0.0e-0,1E+5,10.25e01,1e999,1e-999]", "" },
	{ "[\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\ud83d\\uDE00\"]", "" },
	{ "[\"\x7f\xc2\x80\xe0\xa0\x80\xed\x9f\xbf\xee\x80\x80"
	  "\xf0\x90\x80\x80\xf4\x8f\xbf\xbf // # '\"]",
	    "" },
};

static void test_texts(void **state)
{
	char got[1024];

	(void)state;
	for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
		parse(texts[i].text, strlen(texts[i].text), got);
		assert_text(got, texts[i].refusal, texts[i].text);
	}
	parse("\n{\"a\":\0}", 8, got);
	assert_text(got, "2:6: a control character is no JSON", "NUL");
}

static void test_depth(void **state)
{
	char deep[402], got[1024];

	(void)state;
	memset(deep, '[', 200);
	memset(deep + 200, ']', 200);
	parse(deep, 400, got);
	assert_string_equal(got, "");
	memset(deep, '[', 201);
	memset(deep + 201, ']', 201);
	parse(deep, 402, got);
	assert_string_equal(got,
	    "1:201: brackets are nested more than 200 levels deep");
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
		struct json_check c = { .at = s, .end = end };

		assert_text(json_check(&c) ? NULL : c.at, lines[i].rest, s);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_texts),
		cmocka_unit_test(test_depth),
		cmocka_unit_test(test_lines),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
