/* SPDX-License-Identifier: MIT */
#include "nearest.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>

enum { WORD_MAX = 32 };

/* Whether one is the beginning of the other, and has three letters at least. */
static bool begins(const char *word, const char *other)
{
	size_t length = strlen(word), n = strlen(other);

	if (n < length)
		length = n;
	return length > 2 && strncasecmp(word, other, length) == 0;
}

/* How many edits lead from a to b: the Damerau-Levenshtein distance in which no
 * letter is edited twice. Row i of the table is for the first i letters of a,
 * column j for the first j of b; a row needs the two before it, and no others
 * are kept. */
static size_t edits(const char *a, const char *b)
{
	size_t row[3][WORD_MAX + 1];
	size_t la = strlen(a), lb = strlen(b);

	for (size_t j = 0; j <= lb; j++)
		row[0][j] = j;
	for (size_t i = 1; i <= la; i++) {
		size_t *r = row[i % 3], *up = row[(i + 2) % 3];
		size_t *up2 = row[(i + 1) % 3];

		r[0] = i;
		for (size_t j = 1; j <= lb; j++) {
			int p = tolower((unsigned char)a[i - 1]);
			int q = tolower((unsigned char)b[j - 1]);
			size_t best = up[j - 1] + (p != q);

			if (up[j] + 1 < best)
				best = up[j] + 1;
			if (r[j - 1] + 1 < best)
				best = r[j - 1] + 1;
			if (i > 1 && j > 1 && up2[j - 2] + 1 < best &&
			    p == tolower((unsigned char)b[j - 2]) &&
			    q == tolower((unsigned char)a[i - 2]))
				best = up2[j - 2] + 1;
			r[j] = best;
		}
	}
	return row[la % 3][lb];
}

/* What others call a value. */
static const struct {
	const char *word, *is;
} values[] = {
	{ "opengl", "gl" },
	{ "directx", "d3d" },
	{ "direct3d", "d3d" },
	{ "metal", "webgpu" },
	{ "pixels", "device" },
	{ "screen", "device" },
	{ "image", "device" },
	{ "camera", "view" },
	{ "eye", "view" },
	{ "object", "model" },
	{ "local", "model" },
	{ "none", "null" },
	{ "undefined", "null" },
	{ "txt", "text" },
	{ "double", "f64" },
	{ "float", "f32" },
	{ "float", "single" },
};

/* The synonym of a word that is one of words, or NULL. */
static const char *value_called(const char *word, const char *const *words)
{
	for (size_t i = 0; i < sizeof values / sizeof *values; i++)
		for (const char *const *w = words; *w != NULL; w++)
			if (strcasecmp(values[i].word, word) == 0 &&
			    strcmp(values[i].is, *w) == 0)
				return *w;
	return NULL;
}

const char *nearest(const char *word, const char *const *words)
{
	const char *best = value_called(word, words);
	size_t length = strlen(word);
	/* one more than may be edited: nothing in a single letter */
	size_t least = (length < 2 ? 0 : length < 6 ? 1 : length / 3) + 1;

	if (best != NULL || length > WORD_MAX)
		return best;
	for (; *words != NULL; words++) {
		size_t d = strlen(*words) > WORD_MAX ? least :
						       edits(word, *words);

		if (d < least) {
			least = d;
			best = *words;
		} else if (best == NULL && begins(word, *words)) {
			best = *words;
		}
	}
	return best;
}
