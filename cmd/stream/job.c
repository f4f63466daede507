/* SPDX-License-Identifier: MIT */
#include "job.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "binary.h"
#include "block_read.h"
#include "block_write.h"

/* Rays are computed exactly, whatever the precision; for single they are
 * rounded to floats. */
static void cast_rays(const struct job *j, struct chunk *c, size_t n)
{
	bool single = j->precision == PRECISION_SINGLE ||
	    j->layout.out.format == FORMAT_F32;
	const double *const at[2] = { c->in[0], c->in[1] };
	double *const image[6] = { c->image[0], c->image[1], c->image[2],
		c->image[3], c->image[4], c->image[5] };

	rays_cast(&j->ray, single, at, image, image + 3, n);
}

static void carry(const struct job *j, struct chunk *c, size_t n)
{
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	double *const out[4] = { c->image[0], c->image[1], c->image[2],
		c->image[3] };

	if (j->rays)
		cast_rays(j, c, n);
	else
		points_carry(&j->transform, j->precision, in, out, n);
}

/* The source ends within a binary point: that counts as a bad line. */
static void cut_short(const struct job *j, struct chunk *c, size_t size)
{
	const struct line line = { "", .kind = LINE_LOST, .newline = true };
	char reason[REASON_MAX];

	snprintf(reason, sizeof reason,
	    "ends within a point; a point is %zu bytes", size);
	chunk_complain(c, c->n_lines, reason);
	c->text = c->end;
	if (j->keep_going && j->take != NULL)
		j->take(j, c, &line, 0, c->n_lines);
	else if (j->keep_going && j->take_block == NULL)
		block_write_nan(j, c);
}

/* Shows each point of a block of n lines, or binary points, to the command that
 * wants to see them. number is that of the first; where points are binary, the
 * first begins at text. */
static void show(const struct job *j, struct chunk *c, size_t n, size_t number,
    const char *text)
{
	bool binary = is_binary(j->layout.in.format);
	size_t size = point_size(j->layout.in.format, j->layout.reads), p = 0;
	struct line point = { .kind = LINE_POINT,
		.size = (uint32_t)size,
		.newline = true };

	for (size_t i = 0; i < n; i++) {
		const struct line *line = binary ? &point : &c->line[i];

		point.s = text + i * size;
		if (line->kind == LINE_POINT)
			j->take(j, c, line, p++, number + i);
		else if (line_is_bad(line) || line->kind == LINE_HEADER)
			j->take(j, c, line, 0, number + i);
	}
}

void job_do(struct job *j, struct chunk *c)
{
	bool binary = is_binary(j->layout.in.format);
	size_t size = point_size(j->layout.in.format, j->layout.reads);
	/* a block of images goes out as it is: every point becomes as many
	 * bytes, and no command wants to see it */
	bool whole = binary && is_binary(j->layout.out.format) &&
	    j->take == NULL && j->take_block == NULL && !j->visible && !j->rays;
	bool direct = whole && same_dialect(j->layout.in, j->layout.out) &&
	    j->layout.in.format == FORMAT_F32 && j->layout.single;

	chunk_clear(c);
	while (c->text < c->end) {
		size_t n, points, number = c->n_lines;
		const char *text = c->text;

		/* where one has no image, others will have none */
		if (direct && c->imageless == 0 && binary_carry(j, c))
			continue;
		if (binary && (size_t)(c->end - text) < size) {
			cut_short(j, c, size);
			break;
		}
		if (binary)
			n = points = binary_read(j, c);
		else
			n = block_read(j, c, &points);
		if (j->take_block != NULL) {
			j->take_block(j, c, points);
			continue;
		}
		carry(j, c, points);
		if (whole)
			binary_write_block(j, c, n, number);
		else if (j->take != NULL)
			show(j, c, n, number, text);
		else
			block_write(j, c, n, points, number);
	}
}
