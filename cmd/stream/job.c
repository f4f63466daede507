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
	char reason[REASON_MAX];

	snprintf(reason, sizeof reason,
	    "ends within a point; a point is %zu bytes", size);
	chunk_complain(c, c->n_lines, reason);
	c->text = c->end;
	if (j->keep_going && j->take != NULL) {
		c->line[0] = (struct line){ .s = "", .kind = LINE_LOST };
		j->take(j, c, 1, 0);
	} else if (j->keep_going) {
		block_write_nan(j, c);
	}
}

/* Makes lines of n binary points of the size, the first of which begins at text. */
static void show_points(struct chunk *c, size_t n, size_t size,
    const char *text)
{
	for (size_t i = 0; i < n; i++)
		c->line[i] = (struct line){ .s = text + i * size,
			.size = (uint32_t)size,
			.kind = LINE_POINT };
}

void job_do(struct job *j, struct chunk *c)
{
	bool binary = is_binary(j->layout.in.format);
	size_t size = point_size(j->layout.in.format, j->layout.reads);
	/* a block of images goes out as it is: every point becomes as many
	 * bytes, and no command wants to see it */
	bool whole = binary && is_binary(j->layout.out.format) &&
	    j->take == NULL && !j->visible && !j->rays;
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
		if (j->take != NULL) {
			if (binary)
				show_points(c, n, size, text);
			j->take(j, c, n, points);
			continue;
		}
		carry(j, c, points);
		if (whole)
			binary_write_block(j, c, n, number);
		else
			block_write(j, c, n, points, number);
	}
}
