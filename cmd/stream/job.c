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
		if (j->take != NULL) {
			j->take(j, c, n, points);
			continue;
		}
		job_carry(j, c, points);
		if (!(whole && n == points && binary_join(j, c, n)))
			block_write(j, c, n, points, number);
	}
}
