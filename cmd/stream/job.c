/* SPDX-License-Identifier: MIT */
#include "job.h"

/* Rays are computed exactly, whatever the precision; for single they are
 * rounded to floats. */
static void job_carry(const struct job *j, struct chunk *c, size_t n)
{
	bool single = j->precision == PRECISION_SINGLE ||
	    j->layout.out.format == FORMAT_F32;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	double *const out[6] = { c->image[0], c->image[1], c->image[2],
		c->image[3], c->image[4], c->image[5] };

	if (j->rays)
		rays_cast(&j->ray, single, in, out, out + 3, n);
	else
		points_map(&j->transform, j->precision, in, out, n);
}

void job_do(struct job *j, struct chunk *c)
{
	bool binary = is_binary(j->layout.in.format);
	bool whole = binary_is_whole(j);

	c->n_lines = c->size = c->n_complaints = c->imageless = 0;
	c->refused = false;
	c->text = c->stretch.readable = c->piece.text;
	c->end = c->text + c->piece.whole;
	c->stretch.at = c->stretch.end = 0;
	while (c->text < c->end) {
		const char *text = c->text;
		size_t n, points, number = c->n_lines;

		/* where one has no image, others will have none */
		if (whole && c->imageless == 0 && binary_carry(j, c))
			continue;
		n = binary ? binary_read(j, c, &points) :
			     block_read(j, c, &points);
		if (j->take != NULL) {
			j->take(j, c, n, points);
			continue;
		}
		job_carry(j, c, points);
		if (!(whole && n == points && binary_join(j, c, text, n)))
			block_write(j, c, n, points, number);
	}
}
