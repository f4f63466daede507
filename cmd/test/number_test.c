/* SPDX-License-Identifier: MIT */
/* number_read and number_write agree with strtod and printf, which round correctly in
 * the C library. The shortest text has the layout of JavaScript, by ECMA-262,
 * 6.1.6.1.20. */
#include "random.h"

#include "../number/number.h"

enum { TEXT_MAX = 2048 };

static char *guard; /* the end of the texts that are read */

static int make_guard(void **unused)
{
	(void)unused;
	guard = guard_page();
	return 0;
}

/* Returns a random finite double, of a random kind. */
static double random_double(void)
{
	uint64_t bits = next_random();
	double v = 2 * (double)(bits >> 11) / 0x1p53 - 1;

	switch (random_below(5)) {
	case 0:
		memcpy(&v, &bits, sizeof v);
		return isfinite(v) ? v : 0;
	case 1: /* up to 15 decimals, of at most ten digits */
		return floor(v * 1e10) / pow(10, random_below(16));
	case 2: /* integers, and numbers that are ties for few decimals */
		return floor(v * pow(2, random_below(70))) / pow(2, random_below(30));
	case 3: /* powers of two: the double below is half as far as that above */
		return ldexp(v < 0 ? -1 : 1, random_below(2098) - 1074);
	default:
		return v * pow(10, random_below(8));
	}
}

/* Asserts that number_read reads the text, which ends before the guard page, as strtod
 * does. */
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
	assert_ptr_equal(end, start + (expected_end - text));
	if (memcmp(&v, &expected, sizeof v) != 0 && !(isnan(v) && isnan(expected)))
		fail_msg("%s: expected %a, came %a", text, expected, v);
}

static void reads_as_strtod(void **unused)
{
	static const char *const texts[] = { "0", "-0", "+0", "1", "+1.5", "-12.25",
		".5", "-.5", "5.", "5.e1", ".", "-", "+", "+-1", "-+1", "--1", "", "e5",
		".e5", "1e", "1e+", "1e-", "1ex", "1E5", "1e+05", "1e5.5", "1.2.3",
		"1,5", "12 13", "1-2", "1234567.12345678 ", "12345678.1234567 ",
		"1.5e3xxxxxxxxxxxxxx", "-0.000000 -1.000000 xxxxx",
		"1234567.1234567 xxxxxx", ".1234567e1xxxxxxxxxxx",
		". xxxxxxxxxxxxxxxxxxx", "-. xxxxxxxxxxxxxxxxxxx",
		"5.xxxxxxxxxxxxxxxxxxx", "7xxxxxxxxxxxxxxxxxxx",
		"1/2xxxxxxxxxxxxxxxxxxx", "1:2xxxxxxxxxxxxxxxxxxx",
		"1\xff\xb1 xxxxxxxxxxxxxxxx", "1.\xb1\xff\xba xxxxxxxxxxxxxxx", "nan",
		"NaN", "-nan", "inf", "+Inf", "-INFINITY", "infinit", "infinityx",
		"nano", "1e400", "-1e400", "1e-400", "-1e-400",
		"1e99999999999999999999", "1e-99999999999999999999",
		"0e99999999999999999999", "4.9e-324", "2.4703282292062327e-324",
		"2.4703282292062328e-324", "2.2250738585072011e-308",
		"1.7976931348623158e308", "1.7976931348623159e308", "9007199254740993",
		"1e23", "9007199254740993.00000000000000001",
		"0.500000000000000166533453693773481063544750213623046875",
		"00000000000000000000000000000000000001.25", "8.5e22" };
	const char hex[] = "0x10", sequence[] = "-nan(1)", blank[] = " 1";
	char prefix[128];
	double v;

	(void)unused;
	for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
		for (size_t n = strlen(strcpy(prefix, texts[i])); n > 0; n--) {
			check_read(prefix);
			prefix[n - 1] = '\0';
		}
	/* only 0 is read of 0x10, only -nan of -nan(1), and nothing after a blank */
	assert_ptr_equal(number_read(hex, hex + 4, &v), hex + 1);
	assert_ptr_equal(number_read(sequence, sequence + 7, &v), sequence + 4);
	assert_null(number_read(blank, blank + 2, &v));
}

static void reads_doubles(void **unused)
{
	static const char *const formats[] = { "%.17g", "%.6f", "%.3f", "%.25e", "%g",
		"%.0f", "%+.9g", "%.16e" };
	char text[TEXT_MAX];

	(void)unused;
	for (int i = 0; i < 200000; i++) {
		int size = snprintf(text, sizeof text, formats[random_below(8)],
		    random_double());

		/* number_read stops at the end of the number */
		sprintf(text + size, "%.*s", random_below(24),
		    " 1.000000 2.000000 -3.000000");
		check_read(text);
	}
}

static void reads_digits(void **unused)
{
	char text[TEXT_MAX];

	(void)unused;
	for (int i = 0; i < 100000; i++) {
		int n = i % 100 == 0 ? 800 : 1 + random_below(24);

		for (int k = 0; k < n; k++)
			text[k] = (char)('0' + random_below(10));
		text[random_below(n)] = '.';
		sprintf(text + n, "e%d", random_below(700) - 350 - n / 2);
		check_read(text);
	}
}

/* Reads midpoints of two doubles, which a long double can print, and numbers that
 * differ from a midpoint in a late digit. */
static void reads_halves(void **unused)
{
	char text[TEXT_MAX];

	(void)unused;
	for (int i = 0; i < 2000; i++) {
		double v = fabs(random_double());
		long double half = ((long double)v +
				       (long double)nextafter(v, HUGE_VAL)) /
		    2;
		int size = snprintf(text, sizeof text, "%.1080Lf1", half);

		check_read(text);
		text[--size] = '\0';
		check_read(text);
		while (strchr("0.", text[size - 1]))
			size--;
		text[size - 1]--;
		check_read(text);
	}
}

/* Writes to s the number that printf wrote as d.ddde+-dd to text, in the layout of
 * JavaScript. */
static void write_as_javascript(char *s, const char *text)
{
	int n = 0, point = atoi(strchr(text, 'e') + 1) + 1;
	char digits[128];

	if (*text == '-')
		*s++ = *text++;
	for (; *text != 'e'; text++)
		if (*text != '.')
			digits[n++] = *text;
	while (n > 1 && digits[n - 1] == '0')
		n--;
	if (n <= point && point <= 21)
		sprintf(s, "%.*s%.*s", n, digits, point - n, "000000000000000000000");
	else if (0 < point && point <= 21)
		sprintf(s, "%.*s.%.*s", point, digits, n - point, digits + point);
	else if (-6 < point && point <= 0)
		sprintf(s, "0.%.*s%.*s", -point, "000000", n, digits);
	else
		sprintf(s, "%.1s%s%.*se%+d", digits, n > 1 ? "." : "", n - 1,
		    digits + 1, point - 1);
}

static const char *text_of(double v, unsigned kind, int n)
{
	static char text[NUMBER_MAX + 1];
	char *end = number_write(text, v, (struct number_style){ kind, n });

	assert_in_range(end - text, 1, NUMBER_MAX);
	*end = '\0';
	return text;
}

static void lays_out_as_javascript(void **unused)
{
	static const char *const texts[] = { "0", "1", "-1", "0.1", "123.456", "100",
		"4294967296", "100000000000000000000", "1e+21", "-1e+21", "1.5e+22",
		"123456789012345680000", "999999999999999900000",
		"1.2345678901234568e+21", "0.000001", "0.0000012",
		"0.0000012345678901234567", "1e-7", "-1.5e-7", "9.999999999999997e-7",
		"5e-324", "1.7976931348623157e+308", "1e+23", "1e+100", "1e-10",
		"0.30000000000000004", "nan" };

	(void)unused;
	for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
		assert_string_equal(text_of(strtod(texts[i], NULL), NUMBER_SHORTEST, 0),
		    texts[i]);
	assert_string_equal(text_of(-0.0, NUMBER_SHORTEST, 0), "0");
	assert_string_equal(text_of(-HUGE_VAL, NUMBER_SHORTEST, 0), "nan");
}

/* Compares the shortest text with that of printf at the least precision that reads
 * back as v. Next to a power of two, where the doubles on one side are nearer,
 * number_write may find a shorter text. */
static void writes_the_shortest(void **unused)
{
	char c[64], expected[64];

	(void)unused;
	for (int i = 0; i < 300000; i++) {
		double v = random_double();
		const char *text = text_of(v, NUMBER_SHORTEST, 0);

		if (strtod(text, NULL) != v)
			fail_msg("%a: expected a text that reads back, came %s", v,
			    text);
		if (i % 8 != 0 || v == 0)
			continue;
		for (int n = 0; n == 0 || strtod(c, NULL) != v; n++)
			snprintf(c, sizeof c, "%.*e", n, v);
		write_as_javascript(expected, c);
		if (strlen(text) >= strlen(expected))
			assert_string_equal(text, expected);
	}
}

static void writes_floats(void **unused)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 },
				  two = { NUMBER_DECIMALS, 2 };
	char text[NUMBER_MAX + 1], c[NUMBER_MAX], expected[64];

	(void)unused;
	for (int i = 0; i < 30000; i++) {
		float v = (float)random_double();

		v = isinf(v) || v == 0 ? 0.1f : v;
		*number_write_float(text, v, two) = '\0';
		snprintf(c, sizeof c, "%.2f", (double)v);
		assert_string_equal(text, c + (strcmp(c, "-0.00") == 0));
		*number_write_float(text, v, shortest) = '\0';
		assert_true(strtof(text, NULL) == v);
		for (int n = 0; n == 0 || strtof(c, NULL) != v; n++)
			snprintf(c, sizeof c, "%.*e", n, (double)v);
		write_as_javascript(expected, c);
		if (strlen(text) >= strlen(expected))
			assert_string_equal(text, expected);
	}
}

static void rounds_what_the_double_is(void **unused)
{
	static const struct {
		double v;
		int n;
		const char *decimals, *digits;
	} cases[] = { { 2.5, 1, "2.5", "2" }, { 3.5, 1, "3.5", "4" },
		{ 0.125, 2, "0.12", "0.12" }, { 0.375, 2, "0.38", "0.38" },
		{ 1.005, 2, "1.00", "1" }, { 0, 3, "0.000", "0" },
		{ -0.0, 3, "0.000", "0" }, { -0.006, 2, "-0.01", "-0.006" },
		{ -0.004, 2, "0.00", "-0.004" }, { 0.3, 5, "0.30000", "0.3" },
		{ -5e-324, 9, "0.000000000", "-4.94065646e-324" },
		{ 9.9996, 4, "9.9996", "10" }, { 9.9996, 3, "10.000", "10" },
		{ 1234567, 3, "1234567.000", "1230000" },
		{ -99999.5, 5, "-99999.50000", "-100000" },
		{ 1.23456e-7, 3, "0.000", "1.23e-7" },
		{ 1.23456e-6, 3, "0.000", "0.00000123" },
		{ 9.9999e20, 3, "999990000000000065536.000", "1e+21" },
		{ 0.1, 20, "0.10000000000000000555", "0.10000000000000000555" },
		{ (double)NAN, 3, "nan", "nan" }, { HUGE_VAL, 3, "nan", "nan" } };

	(void)unused;
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		assert_string_equal(text_of(cases[i].v, NUMBER_DECIMALS, cases[i].n),
		    cases[i].decimals);
		assert_string_equal(text_of(cases[i].v, NUMBER_DIGITS, cases[i].n),
		    cases[i].digits);
	}
}

static void rounds_as_printf(void **unused)
{
	char text[TEXT_MAX], expected[TEXT_MAX];

	(void)unused;
	for (int i = 0; i < 200000; i++) {
		int n = random_below(4) ? random_below(20) : random_below(101);
		double v = random_double();

		snprintf(text, sizeof text, "%.*f", n, v);
		assert_string_equal(text_of(v, NUMBER_DECIMALS, n),
		    text + (*text == '-' && strspn(text, "-0.") == strlen(text)));
		if (n == 0 || v == 0)
			continue;
		snprintf(text, sizeof text, "%.*e", n - 1, v);
		write_as_javascript(expected, text);
		assert_string_equal(text_of(v, NUMBER_DIGITS, n), expected);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(reads_as_strtod),
		cmocka_unit_test(reads_doubles),
		cmocka_unit_test(reads_digits),
		cmocka_unit_test(reads_halves),
		cmocka_unit_test(lays_out_as_javascript),
		cmocka_unit_test(writes_the_shortest),
		cmocka_unit_test(writes_floats),
		cmocka_unit_test(rounds_what_the_double_is),
		cmocka_unit_test(rounds_as_printf),
	};

	return cmocka_run_group_tests(tests, make_guard, NULL);
}
