/* SPDX-License-Identifier: MIT */
#include "utf8.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

/* Returns whether start has three letters or more and word begins with start. */
static bool begins_with(const char *word, const char *start)
{
	size_t n = strlen(start);

	return n > 2 && strncasecmp(word, start, n) == 0;
}

/* Returns whether at most n edits lead from a to b. No letter is edited twice. */
static bool edits_reach(const char *a, const char *b, int n)
{
	for (; *a != '\0' && strncasecmp(a, b, 1) == 0; a++)
		b++;
	if (*a == '\0' && *b == '\0')
		return true;
	if (n == 0)
		return false;
	if ((*a != '\0' && edits_reach(a + 1, b, n - 1)) ||
	    (*b != '\0' && edits_reach(a, b + 1, n - 1)))
		return true;
	if (*a == '\0' || *b == '\0')
		return false;
	return edits_reach(a + 1, b + 1, n - 1) ||
	    (strncasecmp(a, b + 1, 1) == 0 && strncasecmp(a + 1, b, 1) == 0 &&
		edits_reach(a + 2, b + 2, n - 1));
}

const char *nearest_word(const char *word, const char *const *words)
{
	size_t length = strlen(word);
	int most = length < 2 ? 0 : length < 6 ? 1 : length < 9 ? 2 : 3;

	for (int n = 0; n <= most; n++)
		for (const char *const *w = words; *w != NULL; w++)
			if (edits_reach(word, *w, n))
				return *w;
	for (; *words != NULL; words++)
		if (begins_with(word, *words) || begins_with(*words, word))
			return *words;
	return NULL;
}

bool word_is_one_of(const char *word, const char *words)
{
	char sought[64];
	size_t n = 0, length;

	for (; *word != '\0' && n < sizeof sought; word++)
		if (*word != '_' && *word != '-')
			sought[n++] = (char)tolower((unsigned char)*word);
	for (; *words != '\0'; words += length + (words[length] == ' ')) {
		length = strcspn(words, " ");
		if (length == n && memcmp(words, sought, n) == 0)
			return true;
	}
	return false;
}
