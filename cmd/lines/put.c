/* SPDX-License-Identifier: MIT */
#include "put.h"

#include <math.h>
#include <string.h>

char *put_rare_number(const struct layout *l, int k, double v, char *out)
{
	if (isnan(v))
		return stpcpy(out, format_of(l->out)->nan_text);
	return l->output.single ?
	    number_write_float(out, (float)v, l->output.style[k]) :
	    number_write(out, v, l->output.style[k]);
}

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
