/* SPDX-License-Identifier: MIT */
#include "nearest.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>

/* Whether one is the beginning of the other, and has three letters at least. */
static bool begins(const char *word, const char *other)
{
	size_t length = strlen(word), n = strlen(other);

	if (n < length)
		length = n;
	return length > 2 && strncasecmp(word, other, length) == 0;
}

static bool same(char a, char b)
{
	return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* Whether at most n edits lead from a to b, without two of one letter. */
static bool within(const char *a, const char *b, int n)
{
	for (; *a != '\0' && same(*a, *b); a++)
		b++;
	if (*a == '\0' && *b == '\0')
		return true;
	if (n == 0)
		return false;
	if ((*a != '\0' && within(a + 1, b, n - 1)) ||
	    (*b != '\0' && within(a, b + 1, n - 1)))
		return true;
	if (*a == '\0' || *b == '\0')
		return false;
	return within(a + 1, b + 1, n - 1) ||
	    (same(a[0], b[1]) && same(a[1], b[0]) &&
		within(a + 2, b + 2, n - 1));
}

const char *nearest(const char *word, const char *const *words)
{
	size_t length = strlen(word);
	int most = length < 2 ? 0 : length < 6 ? 1 : length < 9 ? 2 : 3;

	for (int n = 0; n <= most; n++)
		for (const char *const *w = words; *w != NULL; w++)
			if (within(word, *w, n))
				return *w;
	for (; *words != NULL; words++)
		if (begins(word, *words))
			return *words;
	return NULL;
}
