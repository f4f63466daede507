/* SPDX-License-Identifier: MIT */
#include "put.h"

#include <string.h>

const struct flags *flags_word(struct flag_words *words, unsigned outside)
{
	static const char *const names[] = { "left", "right", "bottom", "top", "near",
		"far", "behind", "nan" };
	struct flags *w = &words->word[outside];
	char *at = w->s;

	if (w->size > 0)
		return w;
	for (int k = 0; k < 8; k++)
		if (outside >> k & 1) {
			if (at > w->s)
				*at++ = '+';
			at = stpcpy(at, names[k]);
		}
	if (at == w->s)
		at = stpcpy(at, "in");
	w->size = (size_t)(at - w->s);
	return w;
}
