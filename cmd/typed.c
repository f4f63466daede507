/* SPDX-License-Identifier: MIT */
#include "typed.h"

#include <stdio.h>
#include <string.h>

bool is_numbers(const char *s)
{
	return strpbrk(s, "0123456789") != NULL &&
	    s[strspn(s, "0123456789+-.eE,; \t\n()[]")] == '\0';
}

size_t add_numbers(char *list, size_t at, size_t room, const char *s)
{
	const char between[] = ",; \t\n()[]";

	for (s += strspn(s, between); *s != '\0'; s += strspn(s, between)) {
		size_t n = strcspn(s, between);

		if (at + n + 2 > room)
			break;
		at += (size_t)sprintf(list + at, "%s%.*s", at > 0 ? "," : "",
		    (int)n, s);
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
	const char digits[] = "0123456789", between[] = "; \t\n";
	size_t at = 0;
	int n = 0;

	for (; *words != NULL && is_numbers(*words); words++) {
		const char *s = *words;

		while (*(s += strspn(s, between)) != '\0') {
			size_t whole = strspn(s, "+-0123456789");
			size_t part = s[whole] != ',' ?
			    0 :
			    strspn(s + whole + 1, digits);
			size_t length = strcspn(s, between);

			if (whole == 0 || part == 0 ||
			    length != whole + 1 + part ||
			    at + length + 3 > TYPED_MAX)
				return false;
			at += (size_t)sprintf(out + at, "%s%.*s.%.*s",
			    n++ > 0 ? "," : "[", (int)whole, s, (int)part,
			    s + whole + 1);
			s += length;
		}
	}
	strcpy(out + at, "]");
	return n == coordinates;
}
