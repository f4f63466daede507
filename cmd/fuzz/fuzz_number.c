/* SPDX-License-Identifier: MIT */
/* Reads any bytes as the text of a number and as a double, for libFuzzer. The results
 * are compared with strtod and snprintf, which round correctly in glibc. */
#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../../core/points/transform.h"
#include "../number/vector/loops.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void want(bool so)
{
	if (!so)
		abort();
}

static bool same(double a, double b)
{
	return (isnan(a) && isnan(b)) || (a == b && signbit(a) == signbit(b));
}

static size_t digits(const char *s)
{
	return strspn(s, "0123456789");
}

/* Returns the length of the number at the beginning of s, by the grammar in
 * number.h. */
static size_t length_of(const char *s)
{
	static const char *const words[] = { "infinity", "inf", "nan" };
	const char *p = s + (*s == '+' || *s == '-');

	for (int i = 0; i < 3; i++)
		if (strncasecmp(p, words[i], strlen(words[i])) == 0)
			return (size_t)(p - s) + strlen(words[i]);
	size_t whole = digits(p), decimals = 0;

	p += whole;
	if (*p == '.') {
		decimals = digits(p + 1);
		p += whole + decimals > 0 ? 1 + decimals : 0;
	}
	if (whole + decimals == 0)
		return 0;
	if (*p == 'e' || *p == 'E') {
		const char *e = p + 1 + (p[1] == '+' || p[1] == '-');

		p = digits(e) > 0 ? e + digits(e) : p;
	}
	return (size_t)(p - s);
}

static void check_read(const uint8_t *data, size_t size)
{
	/* no byte of room after the text, so that a sanitizer finds a read there */
	char *text = malloc(size), *copy = malloc(size + 1);
	double v = 0;

	memcpy(text, data, size);
	memcpy(copy, data, size);
	copy[size] = '\0';
	const char *end = number_read(text, text + size, &v);
	size_t length = length_of(copy);

	want(end == (length > 0 ? text + length : NULL));
	copy[length] = '\0';
	if (length > 0)
		want(same(v, strtod(copy, NULL)));
	free(copy);
	free(text);
}

/* Returns the number of digits from the first to the last that is not 0. */
static int significant(const char *s)
{
	int n = 0, last = 0;

	for (s += strspn(s, "-0."); *s != '\0' && *s != 'e'; s++)
		if (isdigit((unsigned char)*s) && ++n && *s != '0')
			last = n;
	return last;
}

static void check_shortest(double v)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	char text[NUMBER_MAX + 1], other[64];
	int n = 1;

	*number_write(text, v, shortest) = '\0';
	if (!isfinite(v)) {
		want(strcmp(text, "nan") == 0);
		return;
	}
	want(same(strtod(text, NULL), v == 0 ? 0 : v));
	for (;; n++) {
		snprintf(other, sizeof other, "%.*e", n - 1, v);
		if (n == 17 || strtod(other, NULL) == v)
			break;
	}
	want(significant(text) <= n);
	bool plain = strchr(text, 'e') == NULL;

	want(plain == (v == 0 || (fabs(v) >= 1e-6 && fabs(v) < 1e21)));
}

static void check_float(float v)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	char text[NUMBER_MAX + 1], other[64];

	*number_write_float(text, v, shortest) = '\0';
	if (!isfinite(v))
		return;
	float back = strtof(text, NULL);

	want(same((double)back, v == 0 ? 0 : (double)v));
	snprintf(other, sizeof other, "%.8e", (double)v);
	want(significant(text) <= significant(other));
}

static void check_decimals(double v, int n)
{
	const struct number_style style = { NUMBER_DECIMALS, n };
	char text[NUMBER_MAX + 1], truth[NUMBER_MAX + 1], *s = truth;
	char *end = number_write(text, v, style);

	want(end - text <= NUMBER_MAX);
	*end = '\0';
	if (!isfinite(v))
		return;
	snprintf(truth, sizeof truth, "%.*f", n, v);
	if (*s == '-' && s[strspn(s, "-0.")] == '\0')
		s++;
	want(strcmp(text, s) == 0);
}

static void check_digits(double v, int n)
{
	const struct number_style style = { NUMBER_DIGITS, n };
	char text[NUMBER_MAX + 1], truth[NUMBER_MAX + 1];
	char *end = number_write(text, v, style);

	want(end - text <= NUMBER_MAX);
	*end = '\0';
	if (!isfinite(v) || v == 0)
		return;
	snprintf(truth, sizeof truth, "%.*e", n - 1, v);
	want(same(strtod(text, NULL), strtod(truth, NULL)));
	want(significant(text) == significant(truth));
}

/* Checks the text of v when the vector code makes it together with those of other
 * numbers. */
static void check_texts(double v, int n)
{
	const double numbers[64] = { v, 1, -v, 0.1, (double)(float)v };
	struct number_text texts[64];
	char expected[NUMBER_MAX + 1], text[NUMBER_MAX + 65];

	kernels_choose(NULL);
	for (unsigned kind = NUMBER_SHORTEST; kind <= NUMBER_DIGITS; kind++) {
		const struct number_style style = { kind,
			kind == NUMBER_DIGITS && n == 0 ? 1 : n };

		number_texts(numbers, 5, false, style, texts);
		for (int i = 0; i < 5; i++) {
			*number_text_put(text, &texts[i], numbers[i], false,
			    style) = '\0';
			*number_write(expected, numbers[i], style) = '\0';
			want(strcmp(text, expected) == 0);
		}
	}
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	double v = 0;
	float f = 0;

	check_read(data, size);
	memcpy(&v, data, size < sizeof v ? size : sizeof v);
	memcpy(&f, data, size < sizeof f ? size : sizeof f);
	int n = size > 8 ? data[8] % 101 : 2;

	check_shortest(v);
	check_float(f);
	check_decimals(v, n);
	check_digits(v, n > 0 ? n : 1);
	check_texts(v, n > 0 ? n : 1);
	number_read((const char *)data, (const char *)data + size, &v);
	check_decimals(v, n);
	check_digits(v, n > 0 ? n : 1);
	check_texts(v, n > 0 ? n : 1);
	return 0;
}
