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

size_t binary_written(const struct layout *l)
{
	return l->keeps ? layout_record(l) :
			  point_size(l->out.format, l->writes);
}

/* Numbers of points in memory: coordinate k of point i begins at
 * s + i * step + at[k]. */
struct rows {
	char *s;
	size_t step, at[4];
};

static struct rows rows_of(const struct layout *l, char *s, bool records)
{
	struct rows r = { s,
		records ? layout_record(l) : point_size(l->in.format, l->reads),
		{ 0 } };

	for (int k = 0; k < l->reads; k++)
		r.at[k] = point_size(l->in.format,
		    records ? layout_field(l, k) : k);
	return r;
}

/* Copies coordinates of n points, each of so many bytes. */
static inline void copy_rows(const struct layout *l, size_t size,
    const struct rows *to, const struct rows *from, size_t n)
{
	for (int k = 0; k < l->reads; k++) {
		const char *s = from->s + from->at[k];
		char *t = to->s + to->at[k];

		for (size_t i = 0; i < n; i++)
			memcpy(t + i * to->step, s + i * from->step, size);
	}
}

static void binary_copy(const struct layout *l, const struct rows *to,
    const struct rows *from, size_t n)
{
	if (l->in.format == FORMAT_F32)
		copy_rows(l, sizeof(float), to, from, n);
	else
		copy_rows(l, sizeof(double), to, from, n);
}

/* Returns the coordinates of the next n points, one after another: where they were
 * read, or of records in the columns of images, which are not made yet. */
static const char *binary_rows(const struct layout *l, struct chunk *c,
    size_t n)
{
	if (l->record == 0)
		return c->text;
	const struct rows from = rows_of(l, (char *)c->text, true);
	const struct rows to = rows_of(l, (char *)c->image, false);

	binary_copy(l, &to, &from, n);
	return to.s;
}

/* Makes room for the images of n points, and returns where they go, one after
 * another. */
static char *images_begin(const struct layout *l, struct chunk *c, size_t n)
{
	size_t size = n * binary_written(l);

	return l->keeps ? chunk_reserve(c, 2 * size) + size :
			  chunk_reserve(c, size);
}

/* Appends these images, of records that begin at text with what else is in them. */
static void images_end(const struct layout *l, struct chunk *c,
    const char *text, char *images, size_t n)
{
	size_t size = n * binary_written(l);
	char *out = c->out + c->size;

	c->size += size;
	if (!l->keeps)
		return;
	const struct rows to = rows_of(l, out, true);
	const struct rows from = rows_of(l, images, false);

	memcpy(out, text, size);
	binary_copy(l, &to, &from, n);
}

/* Makes lines of the n points of so many bytes that begin at text. */
static void make_lines(struct chunk *c, const char *text, size_t size, size_t n)
{
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
	size_t n = (size_t)(c->end - c->text) / layout_record(&j->layout);

	return n < POINTS_BLOCK ? n : POINTS_BLOCK;
}

size_t binary_read(const struct job *j, struct chunk *c, size_t *points)
{
	const struct layout *l = &j->layout;
	size_t size = layout_record(l);
	size_t n = *points = count_points(j, c);
	const char *text = c->text;
	char reason[REASON_MAX];

	if (n == 0) { /* the source ends within a point */
		snprintf(reason, sizeof reason,
		    "ends within a point; a point is %zu bytes", size);
		make_lines(c, text, (size_t)(c->end - text), 1);
		c->text = c->end;
		return binary_refuse(j, c, 0, reason);
	}
	bool within = points_split(binary_rows(l, c, n),
	    l->in.format == FORMAT_F64, l->reads, c->in, n);

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
	char *images = images_begin(l, c, n);

	if (n == 0 ||
	    !points_carry_floats(&j->transform, binary_rows(l, c, n), images,
		n))
		return false;
	images_end(l, c, c->text, images, n);
	c->text += n * layout_record(l);
	c->n_lines += n;
	return true;
}

bool binary_join(const struct job *j, struct chunk *c, size_t n)
{
	const struct layout *l = &j->layout;
	const char *text = c->text - n * layout_record(l);
	char *images = images_begin(l, c, n);

	if (points_join(c->image, images, l->out.format == FORMAT_F64,
		l->writes, n)) {
		images_end(l, c, text, images, n);
		return true;
	}
	make_lines(c, text, layout_record(l), n);
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

char *binary_put(const struct job *j, const struct chunk *c,
    const struct line *line, size_t p, char *at)
{
	const struct layout *l = &j->layout;
	size_t size = point_size(l->out.format, 1), written = binary_written(l);
	bool copied = l->keeps && line->size == written;

	if (copied)
		memcpy(at, line->s, written);
	/* of a record that the source's end cuts, no number is known */
	int n = copied ? l->writes : (int)(written / size);

	for (int k = 0; k < n; k++) {
		/* -0 is 0 */
		double v = line->kind == LINE_POINT ? c->image[k][p] + 0.0 :
						      (double)NAN;
		char *to = at +
		    size * (size_t)(copied ? layout_field(l, k) : k);

		if (l->out.format == FORMAT_F64)
			put_little_double(to, v);
		else
			put_little_float(to,
			    binary_float(j, c, p, k, v) + 0.0f);
	}
	return at + written;
}
