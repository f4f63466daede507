/* SPDX-License-Identifier: MIT */
/* Puts the values of a point into a line: its numbers, and the word of --flags. */
#pragma once

#include <math.h>

#include "../number/vector/loops.h"
#include "layout.h"

enum { FLAG_MAX = 48 }; /* bytes for the word of --flags, as left+near */

/* Number k of a point is v[k * stride], and text[k * text_stride] its text. */
struct image_numbers {
	const double *v;
	const struct number_text *text;
	size_t stride, text_stride;
};

struct flags {
	char s[FLAG_MAX];
	size_t size;
};

/* The words that flags_word has made, by their OUT_ bits (frustum.h); else empty. */
struct flag_words {
	struct flags word[256];
};

const struct flags *flags_word(struct flag_words *, unsigned outside);

static inline char *put_flags_word(const struct layout *l, const struct flags *w,
    char *out)
{
	bool quoted = *format_of(l->out)->open != '\0';

	*out = '"';
	memcpy(out + quoted, w->s, sizeof w->s);
	out += quoted + w->size;
	*out = '"';
	return out + quoted;
}

static inline char *put_coordinate(const struct layout *l, struct image_numbers n,
    int k, char *out)
{
	const struct number_text *text = &n.text[(size_t)k * n.text_stride];
	double v = n.v[(size_t)k * n.stride];

	if (__builtin_expect(text->layout == 0, 0) && isnan(v))
		return stpcpy(out, format_of(l->out)->nan_text);
	return number_text_put(out, text, v, l->output.single, l->output.style[k]);
}

/* Writes the numbers from k on and the word unless it is NULL, after separators. */
static inline char *put_added(const struct layout *l, struct image_numbers n, int k,
    char separator, const struct flags *flags, char *out)
{
	for (; k < l->writes; k++) {
		*out++ = separator;
		out = put_coordinate(l, n, k, out);
	}
	if (flags != NULL) {
		*out++ = separator;
		out = put_flags_word(l, flags, out);
	}
	return out;
}

/* Copies the n bytes at s, which precede a coordinate or end the line. Copies the first
 * bytes without a branch, as n varies where columns are aligned by blanks. */
static inline char *put_gap(const char *s, size_t n, char *out)
{
	memcpy(out, s, LINE_MARGIN);
	if (n > LINE_MARGIN)
		memcpy(out, s, n);
	return out + n;
}
