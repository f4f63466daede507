/* SPDX-License-Identifier: MIT */
/* The one way out for lines: what a plan says is written in the place of what was read,
 * and everything else stays. */
#pragma once

#include "../../core/points/transform.h"
#include "plan.h"

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

/* The lines of a block, and what is written for its points. */
struct emit_block {
	const struct line *line;
	size_t lines, points;
	const double (*image)[POINTS_BLOCK]; /* number k of point p: image[k][p] */
	/* for --flags and --visible: the planes that point p is outside of */
	const unsigned char *outside;
	bool visible; /* only points in the view volume are written, no bad lines */
	struct flag_words *words;
	bool general; /* all points are written in the general way */
};

/* Returns the most bytes that the output for lines of so many bytes takes. */
size_t emit_room(const struct layout *, size_t lines, size_t bytes);

/* Writes the lines of a block; in a bad line each coordinate becomes nan. Returns the
 * end. */
char *emit_lines(const struct layout *, const struct emit_block *, char *out);

/* Writes the header of the names of an output that has another format than the
 * input. */
char *emit_names(const struct layout *, char *out);
