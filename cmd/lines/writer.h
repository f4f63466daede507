/* SPDX-License-Identifier: MIT */
/* Writes the lines of a block with the images of its points: most in place, where only
 * numbers change; splice.h writes all others. */
#pragma once

#include "../../core/points/transform.h"
#include "line.h"
#include "put.h"

/* A block of n lines, with the images of those that are points, in their order. */
struct written_block {
	const struct layout *layout;
	const struct line *line;
	size_t n, n_images;
	const double (*image)[POINTS_BLOCK]; /* number k of image p: [k][p] */
	/* the frustum planes that point p is outside of, for --flags and `visible` */
	const unsigned char *outside;
	struct flag_words *words;
	bool visible; /* only points in the view volume are written */
};

/* Writes the lines of a block; in a bad line each coordinate becomes nan. Returns the
 * end of the output, which needs splice_room (splice.h). */
char *writer_put_block(const struct written_block *, char *out);
