/* SPDX-License-Identifier: MIT */
#include "typed.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../number/number.h"

bool is_numbers(const char *s)
{
	return strpbrk(s, "0123456789") != NULL &&
	    s[strspn(s, "0123456789+-.eE,; \t\n()[]")] == '\0';
}

/* Adds one, as JSON writes it: 0.5 for +.50. */
static size_t add_number(char *list, size_t at, size_t room, const char *s,
    size_t n)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	char text[NUMBER_MAX];
	double v;

	if (number_read(s, s + n, &v) == s + n && isfinite(v)) {
		n = (size_t)(number_write(text, v, shortest) - text);
		s = text;
	}
	if (at + n + 2 > room)
		return at;
	return at +
	    (size_t)sprintf(list + at, "%s%.*s", at > 0 ? "," : "", (int)n, s);
}

size_t add_numbers(char *list, size_t at, size_t room, const char *s)
{
	const char between[] = ",; \t\n()[]";

	while (*(s += strspn(s, between)) != '\0') {
		size_t n = strcspn(s, between);

		at = add_number(list, at, room, s, n);
		s += n;
	}
	return at;
}

/* So many characters of numbers are enough to show what is meant; and beyond them
 * some may be left out. */
enum { ENOUGH = TYPED_MAX / 4 };

int write_points(char out[TYPED_MAX], char **words, int coordinates)
{
	/* a comma may become three characters, and brackets stand around */
	char list[TYPED_MAX / 3 - 2] = "";
	size_t at = 0;
	int n, point = 0;

	for (; *words != NULL && is_numbers(*words); words++)
		at = add_numbers(list, at, sizeof list, *words);
	n = at > 0;
	for (const char *s = list; *s != '\0'; s++)
		n += *s == ',';
	bool points = n > 0 && n % coordinates == 0 && at < ENOUGH;
	bool several = points && n > coordinates;

	if (!points)
		snprintf(list, sizeof list, "%.*s", 2 * coordinates - 1,
		    "0,0,0,0");
	at = (size_t)sprintf(out, several ? "[[" : "[");
	for (const char *s = list; *s != '\0'; s++)
		if (*s == ',' && ++point % coordinates == 0)
			at += (size_t)sprintf(out + at, "],[");
		else
			out[at++] = *s;
	strcpy(out + at, several ? "]]" : "]");
	return n;
}

bool write_decimals(char out[TYPED_MAX], char **words, int coordinates)
{
	const char digits[] = "+-0123456789", between[] = "; \t\n";
	char text[ENOUGH] = "", *texts[] = { text, NULL };
	size_t at = 0;

	for (; *words != NULL && is_numbers(*words); words++) {
		const char *s = *words;

		while (*(s += strspn(s, between)) != '\0') {
			size_t n = strcspn(s, between);
			size_t whole = strspn(s, digits);

			if (at + n + 2 > sizeof text || whole == 0 ||
			    s[whole] != ',' || whole + 1 == n ||
			    whole + 1 + strspn(s + whole + 1, digits + 2) != n)
				return false;
			at += (size_t)sprintf(text + at, "%.*s.%.*s ",
			    (int)whole, s, (int)(n - whole - 1), s + whole + 1);
			s += n;
		}
	}
	return at > 0 &&
	    write_points(out, texts, coordinates) % coordinates == 0;
}
