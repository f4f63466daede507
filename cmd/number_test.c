/* The truth is strtod's and printf's, which round correctly in the C library
 * this is tested with, and for the layout the rules of ECMA-262, 6.1.6.1.20. */
#define _DEFAULT_SOURCE
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "number.h"

enum { TEXT_MAX = 2048 };

static char *guard; /* from here on memory must not be touched */
static uint64_t state = 88172645463325252;

static int set_up(void **unused)
{
	size_t page = (size_t)sysconf(_SC_PAGESIZE);
	char *pages = mmap(NULL, 2 * page, PROT_READ | PROT_WRITE,
	    MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);

	(void)unused;
	if (pages == MAP_FAILED)
		return -1;
	guard = pages + page;
	return mprotect(guard, page, PROT_NONE);
}

static uint64_t next_random(void)
{
	state ^= state << 13;
	state ^= state >> 7;
	return state ^= state << 17;
}

static int below(int n)
{
	return (int)(next_random() >> 33) % n;
}

static bool same(double a, double b)
{
	return memcmp(&a, &b, sizeof a) == 0;
}

static double random_bits(void)
{
	uint64_t bits = next_random();
	double v;

	memcpy(&v, &bits, sizeof v);
	return isfinite(v) ? v : random_bits();
}

/* Finite, of every kind that a calculator meets. */
static double random_double(void)
{
	double v = 2 * (double)(next_random() >> 11) / 0x1p53 - 1;

	switch (below(6)) {
	case 0:
		return random_bits();
	case 1: /* so many decimals, ten at most */
		return floor(v * 1e10) / pow(10, below(16));
	case 2: /* integers */
		return floor(v * pow(2, below(70)));
	case 3: /* many halves: ties when rounded */
		return floor(v * 1e6) / pow(2, below(20));
	case 4: /* powers of two, with a gap below half of that above */
		return ldexp(v < 0 ? -1 : 1, below(2098) - 1074);
	default:
		return v * pow(10, below(8));
	}
}

/* What C writes as d.ddde+-dd, laid out as JavaScript does. */
static void as_javascript(char *s, const char *text)
{
	int sign = *text == '-', n = 0, point;
	char digits[128];

	point = atoi(strchr(text, 'e') + 1) + 1;
	for (; *text != 'e'; text++)
		if (*text >= '0' && *text <= '9')
			digits[n++] = *text;
	while (n > 1 && digits[n - 1] == '0')
		n--;
	if (sign)
		*s++ = '-';
	if (n <= point && point <= 21)
		sprintf(s, "%.*s%.*s", n, digits, point - n,
		    "000000000000000000000");
	else if (0 < point && point <= 21)
		sprintf(s, "%.*s.%.*s", point, digits, n - point,
		    digits + point);
	else if (-6 < point && point <= 0)
		sprintf(s, "0.%.*s%.*s", -point, "000000", n, digits);
	else
		sprintf(s, "%.1s%s%.*se%+d", digits, n > 1 ? "." : "", n - 1,
		    digits + 1, point - 1);
}

static const char *written(double v, struct number_style style)
{
	static char text[NUMBER_MAX + 1];
	char *end = number_write(text, v, style);

	assert_in_range(end - text, 1, NUMBER_MAX);
	*end = '\0';
	return text;
}

static const char *shortest(double v)
{
	return written(v, (struct number_style){ NUMBER_SHORTEST, 0 });
}

static const char *decimals(double v, int n)
{
	return written(v, (struct number_style){ NUMBER_DECIMALS, n });
}

static const char *digits(double v, int n)
{
	return written(v, (struct number_style){ NUMBER_DIGITS, n });
}

/* Reads text, right before the guard, as strtod does. */
static void check_read(const char *text)
{
	size_t size = strlen(text);
	const char *start = memcpy(guard - size, text, size), *end;
	char *expected_end;
	double v = 0, expected = strtod(text, &expected_end);

	end = number_read(start, guard, &v);
	if (expected_end == text) {
		assert_null(end);
		return;
	}
	assert_non_null(end);
	assert_int_equal(end - start, expected_end - text);
	if (isnan(expected))
		assert_true(isnan(v));
	else if (!same(v, expected))
		fail_msg("%s read as %a", text, v);
}

static void reads_as_strtod(void **unused)
{
	static const char *const texts[] = { "0", "-0", "+0", "1", "+1.5",
		"-12.25", ".5", "-.5", "5.", "5.e1", ".", "-", "+", "+-1",
		"-+1", "--1", "", "e5", ".e5", "1e", "1e+", "1e-", "1ex",
		"1E5", "1e+05", "1e5.5", "1.2.3", "1,5", "12 13", "1-2",
		"12345678", "1234567.1234567", "1234567.12345678 ",
		"12345678.1234567 ", "1.5e3xxxxxxxxxxxxxxxxxxxx",
		"-0.000000 -1.000000 xxxxx", "1234567.1234567 xxxxxx",
		".1234567e1xxxxxxxxxxx", ". xxxxxxxxxxxxxxxxxxx",
		"-. xxxxxxxxxxxxxxxxxxx", "5.xxxxxxxxxxxxxxxxxxx",
		"7xxxxxxxxxxxxxxxxxxx", "1/2xxxxxxxxxxxxxxxxxxx",
		"1:2xxxxxxxxxxxxxxxxxxx", "\x80\xb1\xff xxxxxxxxxxxxxxx",
		"1.\xb1\xff\xba xxxxxxxxxxxxxxx", "nan", "NaN", "-nan", "inf",
		"+Inf", "-INFINITY", "infinit", "infinityx", "na", "in", "i",
		"nano", "nanometres of length", "1e400", "-1e400", "1e-400",
		"-1e-400", "1e99999999999999999999", "1e-99999999999999999999",
		"0e99999999999999999999", "4.9e-324", "2.4703282292062327e-324",
		"2.4703282292062328e-324", "2.2250738585072011e-308",
		"1.7976931348623157e308", "1.7976931348623158e308",
		"1.7976931348623159e308", "9007199254740993",
		"9007199254740992.99999", "9007199254740993.00000000000000001",
		"0.500000000000000166533453693773481063544750213623046875",
		"00000000000000000000000000000000000001.25", "1e23", "8.5e22",
		"0.00000000000000000000000000000000000000000000000000012e40" };
	char prefix[128];

	(void)unused;
	for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
		for (size_t n = 0; n <= strlen(texts[i]); n++) {
			snprintf(prefix, n + 1, "%s", texts[i]);
			check_read(prefix);
		}
}

static void reads_no_more_than_it_says(void **unused)
{
	const char hex[] = "0x10", sequence[] = "-nan(1)", blank[] = " 1";
	double v = 1;

	(void)unused;
	assert_ptr_equal(number_read(hex, hex + 4, &v), hex + 1);
	assert_true(v == 0);
	assert_ptr_equal(number_read(sequence, sequence + 7, &v), sequence + 4);
	assert_true(isnan(v));
	assert_null(number_read(blank, blank + 2, &v));
}

static void reads_doubles(void **unused)
{
	static const char *const formats[] = { "%.17g", "%.6f", "%.3f", "%.16e",
		"%g", "%.0f", "%+.9g", "%.25e" };
	char text[TEXT_MAX];

	(void)unused;
	for (int i = 0; i < 200000; i++) {
		int size = snprintf(text, sizeof text, formats[below(8)],
		    random_double());

		/* What follows leaves or denies the room to read fast. */
		snprintf(text + size, sizeof text - (size_t)size, "%.*s",
		    below(24), " 1.000000 2.000000 -3.000000");
		check_read(text);
	}
}

static void reads_digits(void **unused)
{
	char text[TEXT_MAX];

	(void)unused;
	for (int i = 0; i < 100000; i++) {
		int n = i % 100 == 0 ? 800 : 1 + below(24), point = below(n + 1);
		char *s = text;

		for (int k = 0; k < n; k++) {
			if (k == point)
				*s++ = '.';
			*s++ = (char)('0' + below(10));
		}
		*s = '\0';
		if (below(2))
			sprintf(s, "e%d", below(700) - 350 - n / 2);
		check_read(text);
	}
}

/* Half way between two doubles, where there are longer ones to print it, and
 * a digit far behind off it to both sides. */
static void reads_halves(void **unused)
{
	char text[TEXT_MAX];

	(void)unused;
	for (int i = 0; i < 2000; i++) {
		double v = fabs(random_double());
		long double half = ((long double)v +
		    (long double)nextafter(v, HUGE_VAL)) / 2;
		int size = snprintf(text, sizeof text, "%.*Lf",
		    i % 2 ? 1080 : 800, half);

		check_read(text);
		strcpy(text + size, "1");
		check_read(text);
		text[size] = '\0';
		while (size > 0 && (text[size - 1] == '0' ||
		    text[size - 1] == '.'))
			size--;
		if (size > 0)
			text[size - 1]--;
		check_read(text);
	}
}

static void lays_out_as_javascript(void **unused)
{
	static const char *const texts[] = { "0", "1", "-1", "0.1", "123.456",
		"100", "4294967296", "100000000000000000000", "1e+21",
		"-1e+21", "1.5e+22", "123456789012345680000",
		"999999999999999900000", "1.2345678901234568e+21", "0.000001",
		"0.0000012", "0.0000012345678901234567", "1e-7", "-1.5e-7",
		"9.999999999999997e-7", "5e-324", "2.2250738585072014e-308",
		"1.7976931348623157e+308", "1e+23", "1e+100", "1e-10",
		"0.30000000000000004", "0.3333333333333333" };

	(void)unused;
	for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
		assert_string_equal(shortest(strtod(texts[i], NULL)), texts[i]);
	assert_string_equal(shortest(-0.0), "0");
	assert_string_equal(shortest(9007199254740993.0), "9007199254740992");
	assert_string_equal(shortest((double)NAN), "nan");
	assert_string_equal(shortest(-HUGE_VAL), "nan");
}

/* The first precision at which printf's text reads back; past a gap that is
 * half as wide there can be a shorter text that printf would not choose. */
static void check_shortest(double v)
{
	char text[64], expected[64];
	int n = 0;

	do
		snprintf(text, sizeof text, "%.*e", n++, v);
	while (strtod(text, NULL) != v);
	as_javascript(expected, text);
	if (strlen(shortest(v)) >= strlen(expected))
		assert_string_equal(shortest(v), expected);
}

static void writes_the_shortest(void **unused)
{
	(void)unused;
	for (int i = 0; i < 300000; i++) {
		double v = random_double();

		if (v == 0)
			continue;
		if (!same(strtod(shortest(v), NULL), v))
			fail_msg("%a written as %s", v, shortest(v));
		if (i % 10 == 0)
			check_shortest(v);
	}
}

static void writes_floats(void **unused)
{
	const struct number_style style = { NUMBER_SHORTEST, 0 },
	    two = { NUMBER_DECIMALS, 2 };
	char text[NUMBER_MAX + 1], c[64], expected[64];

	(void)unused;
	for (int i = 0; i < 30000; i++) {
		uint32_t bits = (uint32_t)next_random();
		float v = (float)random_double();
		int n = 0;

		if (i % 2)
			memcpy(&v, &bits, sizeof v);
		if (!isfinite(v) || v == 0)
			continue;
		*number_write_float(text, v, style) = '\0';
		assert_true(strtof(text, NULL) == v);
		do
			snprintf(c, sizeof c, "%.*e", n++, (double)v);
		while (strtof(c, NULL) != v);
		as_javascript(expected, c);
		if (strlen(text) >= strlen(expected))
			assert_string_equal(text, expected);
	}
	*number_write_float(text, 0.1f, style) = '\0';
	assert_string_equal(text, "0.1");
	*number_write_float(text, -0.0f, style) = '\0';
	assert_string_equal(text, "0");
	*number_write_float(text, 2.675f, two) = '\0';
	assert_string_equal(text, "2.67");
}

static void rounds_what_the_double_is(void **unused)
{
	static const struct {
		double v;
		int n;
		const char *decimals, *digits;
	} cases[] = { { 0.5, 1, "0.5", "0.5" }, { 2.5, 1, "2.5", "2" },
		{ 3.5, 1, "3.5", "4" }, { 0.125, 2, "0.12", "0.12" },
		{ 0.375, 2, "0.38", "0.38" }, { 1.005, 2, "1.00", "1" },
		{ 1.005, 3, "1.005", "1" }, { 0, 3, "0.000", "0" },
		{ -0.0, 3, "0.000", "0" }, { -0.006, 2, "-0.01", "-0.006" },
		{ -0.004, 2, "0.00", "-0.004" }, { 0.3, 5, "0.30000", "0.3" },
		{ -5e-324, 9, "0.000000000", "-4.94065646e-324" },
		{ 9.9996, 4, "9.9996", "10" }, { 9.9996, 3, "10.000", "10" },
		{ 1234567, 3, "1234567.000", "1230000" },
		{ -99999.5, 5, "-99999.50000", "-100000" },
		{ 1.23456e-7, 3, "0.000", "1.23e-7" },
		{ 1.23456e-6, 3, "0.000", "0.00000123" },
		{ 9.9999e20, 3, "999990000000000000000.000", "1e+21" },
		{ 0.1, 20, "0.10000000000000000555", "0.10000000000000000555" },
		{ (double)NAN, 3, "nan", "nan" }, { HUGE_VAL, 3, "nan", "nan" }
	};

	(void)unused;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		assert_string_equal(decimals(cases[i].v, cases[i].n),
		    cases[i].decimals);
		assert_string_equal(digits(cases[i].v, cases[i].n),
		    cases[i].digits);
	}
	assert_string_equal(decimals(0.5, 0), "0");
	assert_string_equal(decimals(-0.5, 0), "0");
	assert_string_equal(decimals(1.5, 0), "2");
	assert_int_equal(strlen(decimals(-1.7976931348623157e308, 100)), 411);
}

static void rounds_as_printf(void **unused)
{
	char text[TEXT_MAX], expected[TEXT_MAX];

	(void)unused;
	for (int i = 0; i < 200000; i++) {
		int n = below(4) ? below(20) : below(101);
		double v = random_double();

		snprintf(text, sizeof text, "%.*f", n, v);
		if (strspn(text, "-0.") == strlen(text))
			assert_string_equal(decimals(v, n),
			    text + (*text == '-'));
		else
			assert_string_equal(decimals(v, n), text);
		if (n == 0 || v == 0)
			continue;
		snprintf(text, sizeof text, "%.*e", n - 1, v);
		as_javascript(expected, text);
		assert_string_equal(digits(v, n), expected);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(reads_as_strtod),
		cmocka_unit_test(reads_no_more_than_it_says),
		cmocka_unit_test(reads_doubles),
		cmocka_unit_test(reads_digits),
		cmocka_unit_test(reads_halves),
		cmocka_unit_test(lays_out_as_javascript),
		cmocka_unit_test(writes_the_shortest),
		cmocka_unit_test(writes_floats),
		cmocka_unit_test(rounds_what_the_double_is),
		cmocka_unit_test(rounds_as_printf),
	};

	return cmocka_run_group_tests(tests, set_up, NULL);
}
