/* SPDX-License-Identifier: MIT */
#include "binary.h"

#include <math.h>

#include "../../core/points/kernel/little.h"

/* Complains of points beyond the range. The first of them ends the chunk,
 * unless the job keeps going. Returns how many points it goes on with. */
static size_t refuse_beyond(const struct job *j, struct chunk *c, size_t n,
    size_t reads)
{
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < reads; k++) {
			if (!(fabs(c->in[k][i]) > MAGNITUDE_MAX))
				continue;
			chunk_complain(c, c->n_lines + i,
			    "a coordinate is beyond 1e150 in magnitude; "
			    "choose another unit");
			if (!j->keep_going) {
				c->text = c->end;
				return i;
			}
			c->in[k][i] = (double)NAN;
			break;
		}
	return n;
}

size_t binary_read(const struct job *j, struct chunk *c)
{
	size_t size = point_size(j->layout.in.format, j->layout.reads);
	size_t n = (size_t)(c->end - c->text) / size;
	size_t reads = (size_t)j->layout.reads;
	bool wide = j->layout.in.format == FORMAT_F64;

	if (n > POINTS_BLOCK)
		n = POINTS_BLOCK;
	bool within = points_split(c->text, wide, j->layout.reads, c->in, n);

	c->text += n * size;
	if (!within)
		n = refuse_beyond(j, c, n, reads);
	c->n_lines += n;
	return n;
}

bool binary_carry(const struct job *j, struct chunk *c)
{
	size_t size = point_size(j->layout.in.format, j->layout.reads);
	size_t n = (size_t)(c->end - c->text) / size;

	if (n > POINTS_BLOCK)
		n = POINTS_BLOCK;
	if (n == 0)
		return false;
	char *at = chunk_reserve(c, n * size);

	if (!points_carry_floats(&j->transform, c->text, at, n))
		return false;
	c->size += n * size;
	c->text += n * size;
	c->n_lines += n;
	return true;
}

/* v, coordinate k of the image of point p, as a float. With precision exact it
 * is computed anew: what is rounded to a double and then to a float may not be
 * the nearest float. */
static float narrowed(const struct job *j, const struct chunk *c, size_t p,
    int k, double v)
{
	double in[4];

	if (j->rays || j->precision != PRECISION_EXACT)
		return (float)v;
	for (int i = 0; i < 4; i++)
		in[i] = c->in[i][p];
	return point_single(&j->transform, in, k, v);
}

void binary_mark(const struct job *j, struct chunk *c, size_t p, size_t line)
{
	bool narrow = j->layout.out.format == FORMAT_F32;

	for (int k = 0; narrow && k < j->layout.writes; k++) {
		double *v = &c->image[k][p];

		if (fabs(*v) == MIDWAY_TO_INFINITY)
			*v = (double)narrowed(j, c, p, k, *v);
	}
	chunk_mark(c, &j->layout, p, line);
}

void binary_write(const struct job *j, struct chunk *c, size_t p,
    const double *v)
{
	size_t size = point_size(j->layout.out.format, j->layout.writes);
	char *at = chunk_reserve(c, size);

	for (int k = 0; k < j->layout.writes; k++) {
		double wide = v[k] + 0.0; /* -0 is 0 */
		float narrow = j->layout.out.format == FORMAT_F32 &&
			!isnan(wide) ?
		    narrowed(j, c, p, k, wide) + 0.0f :
		    (float)wide;

		if (j->layout.out.format == FORMAT_F64)
			put_little_double(at + 8 * k, wide);
		else
			put_little_float(at + 4 * k, narrow);
	}
	c->size += size;
}

void binary_write_block(const struct job *j, struct chunk *c, size_t n,
    size_t first_line)
{
	bool wide = j->layout.out.format == FORMAT_F64;
	int writes = j->layout.writes;
	size_t size = n * point_size(j->layout.out.format, writes);
	char *at = chunk_reserve(c, size);
	double v[COORDINATES_MAX];

	if (points_join(c->image, at, wide, writes, n)) {
		c->size += size;
		return;
	}
	for (size_t i = 0; i < n; i++) {
		binary_mark(j, c, i, first_line + i);
		for (int k = 0; k < writes; k++)
			v[k] = c->image[k][i];
		binary_write(j, c, i, v);
	}
}
