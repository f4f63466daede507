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
