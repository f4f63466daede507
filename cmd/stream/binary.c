/* SPDX-License-Identifier: MIT */
/* Blocks of points as binary numbers in a row. */
#include <math.h>
#include <stdio.h>

#include "../../core/points/kernel/little.h"
#include "job.h"

bool binary_is_whole(const struct job *j)
{
	return is_binary(j->layout.in.format) &&
	    is_binary(j->layout.out.format) && j->take == NULL && !j->visible &&
	    !j->rays;
}

size_t binary_written(const struct layout *l)
{
	return l->keeps ? layout_record(l) :
			  point_size(l->out.format, l->writes);
}

/* Copies the coordinates of n points, numbers of a size, from records to rows that
 * have no others; or back. */
static inline void copy_numbers(const struct layout *l, size_t size,
    char *records, char *rows, bool back, size_t n)
{
	size_t record = layout_record(l), row = size * (size_t)l->reads;
	size_t step = back ? row : record, to_step = back ? record : row;

	for (int k = 0; k < l->reads; k++) {
		char *in_record = records + size * (size_t)layout_field(l, k);
		char *in_row = rows + size * (size_t)k;
		const char *s = back ? in_row : in_record;
		char *to = back ? in_record : in_row;

		for (size_t i = 0; i < n; i++)
			memcpy(to + i * to_step, s + i * step, size);
	}
}

static void copy_coordinates(const struct layout *l, char *records, char *rows,
    bool back, size_t n)
{
	if (l->in.format == FORMAT_F32)
		copy_numbers(l, sizeof(float), records, rows, back, n);
	else
		copy_numbers(l, sizeof(double), records, rows, back, n);
}

/* Returns how many whole points are left, at most a block. */
static size_t count_points(const struct job *j, const struct chunk *c)
{
	size_t n = (size_t)(c->end - c->text) / layout_record(&j->layout);

	return n < POINTS_BLOCK ? n : POINTS_BLOCK;
}

/* Makes lines of the n points that begin at text, each of so many bytes. */
static void make_lines(struct chunk *c, const char *text, size_t size, size_t n)
{
	for (size_t i = 0; i < n; i++)
		c->line[i] = (struct line){ .s = text + i * size,
			.size = (uint32_t)size,
			.kind = LINE_POINT,
			.newline = true };
}

/* Complains of line i of the block, which becomes a bad one. Returns whether the job
 * goes on. */
static bool binary_refuse(const struct job *j, struct chunk *c, size_t i,
    const char *reason)
{
	c->line[i].kind = LINE_LOST;
	return chunk_complain(j, c, c->n_lines + i, reason);
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

size_t binary_read(const struct job *j, struct chunk *c, size_t *points)
{
	const struct layout *l = &j->layout;
	size_t size = layout_record(l), n = *points = count_points(j, c);
	const char *text = c->text, *rows = text;
	char reason[REASON_MAX];

	if (n == 0) { /* the source ends within a point */
		snprintf(reason, sizeof reason,
		    "ends within a point; a point is %zu bytes", size);
		make_lines(c, text, (size_t)(c->end - text), 1);
		c->text = c->end;
		return binary_refuse(j, c, 0, reason);
	}
	const bool wide = l->in.format == FORMAT_F64;

	if (l->record > 0) { /* rows stand where images will */
		rows = (char *)c->image;
		copy_coordinates(l, (char *)text, (char *)rows, false, n);
	}
	bool within = points_kernels()->split[wide][l->reads](rows, c->in, n,
	    MAGNITUDE_MAX);

	c->text += n * size;
	if (!within || !binary_is_whole(j))
		make_lines(c, text, size, n);
	if (!within)
		n = refuse_beyond(j, c, n, points);
	c->n_lines += n;
	return n;
}

bool binary_carry(const struct job *j, struct chunk *c)
{
	const struct layout *l = &j->layout;
	size_t n = count_points(j, c);
	char *images = chunk_reserve(c, n * binary_written(l));

	if (l->in.format != FORMAT_F32 || l->out.format != FORMAT_F32 ||
	    !l->single || l->record > 0 || n == 0 ||
	    !points_map_floats(&j->transform, c->text, images, n))
		return false;
	c->size += n * binary_written(l);
	c->text += n * layout_record(l);
	c->n_lines += n;
	return true;
}

bool binary_join(const struct job *j, struct chunk *c, const char *text,
    size_t n)
{
	const struct layout *l = &j->layout;
	size_t size = n * binary_written(l);
	char *out = chunk_reserve(c, 2 * size);
	char *images = out + (l->keeps ? size : 0);
	const bool wide = l->out.format == FORMAT_F64;

	/* false if a number is not finite, or floats are to be asked of point_single */
	if (!points_kernels()->join[wide][l->writes](c->image, images, n)) {
		make_lines(c, text, layout_record(l), n);
		return false;
	}
	if (l->keeps) {
		memcpy(out, text, size);
		copy_coordinates(l, out, images, true, n);
	}
	c->size += size;
	return true;
}

char *binary_put(const struct layout *l, const struct chunk *c,
    const struct line *line, size_t p, char *at)
{
	size_t size = point_size(l->out.format, 1), written = binary_written(l);
	bool copied = l->keeps && line->size == written;

	if (copied)
		memcpy(at, line->s, written);
	/* of a record that the source's end cuts, no number is known */
	int n = copied ? l->writes : (int)(written / size);

	for (int k = 0; k < n; k++) {
		double v = line->kind == LINE_POINT ? c->image[k][p] :
						      (double)NAN;
		char *to = at +
		    size * (size_t)(copied ? layout_field(l, k) : k);

		/* -0 is 0 */
		if (l->out.format == FORMAT_F64)
			put_little_double(to, v + 0.0);
		else
			put_little_float(to, (float)v + 0.0f);
	}
	return at + written;
}
