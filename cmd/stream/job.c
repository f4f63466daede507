/* SPDX-License-Identifier: MIT */
#include "job.h"

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

static void job_carry(const struct job *j, struct chunk *c, size_t n)
{
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	double *const out[4] = { c->image[0], c->image[1], c->image[2],
		c->image[3] };

	if (j->rays)
		cast_rays(j, c, n);
	else
		points_carry(&j->transform, j->precision, in, out, n);
}

/* Shows each line of the block that is a point, or bad, or a header, to the command
 * that wants to see them. number is that of the first. */
static void job_show(const struct job *j, struct chunk *c, size_t n,
    size_t number)
{
	size_t p = 0;

	for (size_t i = 0; i < n; i++) {
		const struct line *line = &c->line[i];

		if (line->kind == LINE_POINT)
			j->take(j, c, line, p++, number + i);
		else if (line->kind != LINE_COPY)
			j->take(j, c, line, 0, number + i);
	}
}

void job_do(struct job *j, struct chunk *c)
{
	const struct layout *l = &j->layout;
	bool binary = is_binary(l->in.format), whole = binary_is_whole(j);
	bool direct = whole && same_dialect(l->in, l->out) &&
	    l->in.format == FORMAT_F32 && l->single;

	chunk_clear(c);
	while (c->text < c->end) {
		size_t n, points, number = c->n_lines;

		/* where one has no image, others will have none */
		if (direct && c->imageless == 0 && binary_carry(j, c))
			continue;
		n = binary ? binary_read(j, c, &points) :
			     block_read(j, c, &points);
		if (j->take_block != NULL) {
			j->take_block(j, c, points);
			continue;
		}
		job_carry(j, c, points);
		if (j->take != NULL)
			job_show(j, c, n, number);
		else if (!(whole && n == points && binary_join(j, c, n)))
			block_write(j, c, n, points, number);
	}
}
