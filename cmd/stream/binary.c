/* SPDX-License-Identifier: MIT */
#include "binary.h"

#include <math.h>
#include <stdio.h>

#include "../../core/points/kernel/little.h"

bool binary_is_whole(const struct job *j)
{
	return is_binary(j->layout.in.format) &&
	    is_binary(j->layout.out.format) && j->take == NULL && !j->visible &&
	    !j->rays;
}

/* Makes lines of the n points that begin at text. */
static void make_lines(const struct job *j, struct chunk *c, const char *text,
    size_t n)
{
	size_t size = point_size(j->layout.in.format, j->layout.reads);

	for (size_t i = 0; i < n; i++)
		c->line[i] = (struct line){ .s = text + i * size,
			.size = (uint32_t)size,
			.kind = LINE_POINT,
			.newline = true };
}

/* Complains of line i of the block, which becomes a bad one. Returns whether the
 * job goes on; else the chunk ends. */
static bool binary_refuse(const struct job *j, struct chunk *c, size_t i,
    const char *reason)
{
	c->line[i].kind = LINE_LOST;
	chunk_complain(c, c->n_lines + i, reason);
	if (!j->keep_going)
		c->text = c->end;
	return j->keep_going;
}

/* Refuses points beyond the range, whose place those behind them take. Returns how
 * many lines there are up to the end of the chunk. */
static size_t refuse_beyond(const struct job *j, struct chunk *c, size_t n,
    size_t *points)
{
	*points = 0;
	for (size_t i = 0; i < n; i++) {
		bool within = true;

		for (int k = 0; k < j->layout.reads; k++) {
			c->in[k][*points] = c->in[k][i];
			within &= !(fabs(c->in[k][i]) > MAGNITUDE_MAX);
		}
		*points += within;
		if (!within &&
		    !binary_refuse(j, c, i,
			"a coordinate is beyond 1e150 in magnitude; choose "
			"another unit"))
			return i;
	}
	return n;
}

/* Returns how many whole points are left, at most a block. */
static size_t count_points(const struct job *j, const struct chunk *c)
{
	size_t n = (size_t)(c->end - c->text) /
	    point_size(j->layout.in.format, j->layout.reads);

	return n < POINTS_BLOCK ? n : POINTS_BLOCK;
}

size_t binary_read(const struct job *j, struct chunk *c, size_t *points)
{
	size_t size = point_size(j->layout.in.format, j->layout.reads);
	size_t n = *points = count_points(j, c);
	const char *text = c->text;
	char reason[REASON_MAX];

	if (n == 0) { /* the source ends within a point */
		snprintf(reason, sizeof reason,
		    "ends within a point; a point is %zu bytes", size);
		make_lines(j, c, text, 1);
		c->text = c->end;
		return binary_refuse(j, c, 0, reason);
	}
	bool within = points_split(text, size / (size_t)j->layout.reads == 8,
	    j->layout.reads, c->in, n);

	c->text += n * size;
	if (!within || !binary_is_whole(j))
		make_lines(j, c, text, n);
	if (!within)
		n = refuse_beyond(j, c, n, points);
	c->n_lines += n;
	return n;
}

bool binary_carry(const struct job *j, struct chunk *c)
{
	size_t n = count_points(j, c);
	size_t size = n * point_size(j->layout.in.format, j->layout.reads);

	if (n == 0 ||
	    !points_carry_floats(&j->transform, c->text, chunk_reserve(c, size),
		n))
		return false;
	c->size += size;
	c->text += size;
	c->n_lines += n;
	return true;
}

bool binary_join(const struct job *j, struct chunk *c, size_t n)
{
	size_t size = n * point_size(j->layout.in.format, j->layout.reads);
	size_t more = n * point_size(j->layout.out.format, j->layout.writes);

	if (points_join(c->image, chunk_reserve(c, more),
		j->layout.out.format == FORMAT_F64, j->layout.writes, n)) {
		c->size += more;
		return true;
	}
	make_lines(j, c, c->text - size, n);
	return false;
}

/* With precision exact it is computed anew: what is rounded to a double and then to a
 * float may not be the nearest float. */
float binary_float(const struct job *j, const struct chunk *c, size_t p, int k,
    double v)
{
	double in[4];

	if (isnan(v) || j->rays || j->precision != PRECISION_EXACT)
		return (float)v;
	for (int i = 0; i < 4; i++)
		in[i] = c->in[i][p];
	return point_single(&j->transform, in, k, v);
}

char *binary_put(const struct job *j, const struct chunk *c, bool image,
    size_t p, char *at)
{
	for (int k = 0; k < j->layout.writes; k++) {
		/* -0 is 0 */
		double v = image ? c->image[k][p] + 0.0 : (double)NAN;

		if (j->layout.out.format == FORMAT_F64) {
			put_little_double(at, v);
			at += sizeof(double);
		} else {
			put_little_float(at,
			    binary_float(j, c, p, k, v) + 0.0f);
			at += sizeof(float);
		}
	}
	return at;
}
