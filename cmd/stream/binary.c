/* SPDX-License-Identifier: MIT */
#include "binary.h"

#include <math.h>

#include "../../core/points/kernel/little.h"
#include "../../core/points/points.h"

bool binary_is_rows(const struct job *j)
{
	return format_is_binary(j->layout.in.format) &&
	    format_is_binary(j->layout.out.format) && j->take_block == NULL &&
	    !j->visible && !j->rays;
}

static size_t binary_size(const struct layout *l)
{
	return l->output.keeps ? layout_record_size(l) :
				 format_point_size(l->out.format, l->writes);
}

/* Copies coordinates of `size` bytes between records and rows. */
static inline void copy_numbers(const struct layout *l, size_t size, char *records,
    char *rows, bool to_records, size_t n)
{
	const size_t record = layout_record_size(l), row = size * (size_t)l->reads;

	for (int k = 0; k < l->reads; k++) {
		char *in_record = records + size * (size_t)layout_field(l, k);
		char *in_row = rows + size * (size_t)k;

		for (size_t i = 0; i < n; i++) {
			memcpy(to_records ? in_record : in_row,
			    to_records ? in_row : in_record, size);
			in_record += record;
			in_row += row;
		}
	}
}

/* Calls copy_numbers with a constant size, for which memcpy is a load and a store. */
static void copy_coordinates(const struct layout *l, char *records, char *rows,
    bool to_records, size_t n)
{
	if (l->in.format == FORMAT_F32)
		copy_numbers(l, sizeof(float), records, rows, to_records, n);
	else
		copy_numbers(l, sizeof(double), records, rows, to_records, n);
}

static size_t count_points(const struct job *j, const struct chunk *c)
{
	size_t n = (size_t)(c->end - c->text) / layout_record_size(&j->layout);

	return n < POINTS_BLOCK ? n : POINTS_BLOCK;
}

/* Returns rows of the next n points: the text or, of records, a copy in c->image. */
static const char *next_rows(const struct layout *l, struct chunk *c, size_t n)
{
	if (l->record == 0)
		return c->text;
	copy_coordinates(l, (char *)c->text, (char *)c->image, false, n);
	return (const char *)c->image;
}

static void set_lines(struct chunk *c, const char *text, size_t size, size_t n)
{
	for (size_t i = 0; i < n; i++)
		c->line[i] = (struct line){ .s = text + i * size,
			.size = (uint32_t)size,
			.kind = LINE_POINT,
			.newline = true };
}

static bool binary_refuse(const struct job *j, struct chunk *c, const struct refusal *r)
{
	c->line[c->block_lines].kind = LINE_LOST;
	return chunk_complain(j, c, r);
}

/* Refuses each of n points that is out of range, and removes it from the columns c->in.
 * If such a point ends the chunk, the block ends before it. */
static void refuse_beyond_range(const struct job *j, struct chunk *c, size_t n)
{
	size_t *kept = &c->block_points;

	for (; c->block_lines < n; c->block_lines++) {
		struct refusal r;
		bool within = true;

		for (int k = 0; k < j->layout.reads; k++) {
			double v = c->in[k][c->block_lines];

			c->in[k][*kept] = v;
			within = within && plan_in_range(&j->layout, k, v, &r);
		}
		*kept += within;
		if (!within && !binary_refuse(j, c, &r))
			return;
	}
}

void binary_read_block(const struct job *j, struct chunk *c)
{
	const struct layout *l = &j->layout;
	const bool wide = l->in.format == FORMAT_F64;
	size_t size = layout_record_size(l), n = count_points(j, c);
	const char *from = c->text;
	struct refusal r;

	if (n == 0) { /* the source ends within a point */
		refusal_set(&r, NULL, "ends within a point",
		    l->record > 0 ?
			text("a point is %zu bytes", size) :
			text("a point is %zu bytes; -i %s reads four numbers a point",
			    size, wide ? "f64x4" : "f32x4"));
		set_lines(c, from, (size_t)(c->end - from), 1);
		c->text = c->end;
		c->block_lines = binary_refuse(j, c, &r);
		return;
	}
	bool within = kernels_chosen()->to_columns[wide][l->reads](next_rows(l, c, n),
	    c->in, n, SCENE_MAGNITUDE_MAX);

	c->text += n * size;
	if (!within || !binary_is_rows(j))
		set_lines(c, from, size, n);
	if (within)
		c->block_lines = c->block_points = n;
	else
		refuse_beyond_range(j, c, n);
}

bool binary_map_floats(const struct job *j, struct chunk *c)
{
	const struct layout *l = &j->layout;
	size_t n = count_points(j, c);
	char *images = chunk_reserve(c, n * binary_size(l));

	if (l->in.format != FORMAT_F32 || l->out.format != FORMAT_F32 ||
	    !l->output.single || l->output.keeps || n == 0 ||
	    !points_map_floats(&j->transform, next_rows(l, c, n), images, n))
		return false;
	c->size += n * binary_size(l);
	c->text += n * layout_record_size(l);
	c->block_lines = n;
	return true;
}

bool binary_write_rows(const struct job *j, struct chunk *c, const char *text)
{
	const struct layout *l = &j->layout;
	const bool wide = l->out.format == FORMAT_F64;
	size_t n = c->block_points, size = n * binary_size(l);
	char *out = chunk_reserve(c, 2 * size);
	char *images = out + (l->output.keeps ? size : 0);

	if (!kernels_chosen()->to_rows[wide][l->writes](c->image, images, n)) {
		set_lines(c, text, layout_record_size(l), n);
		return false;
	}
	if (l->output.keeps) {
		memcpy(out, text, size);
		copy_coordinates(l, out, images, true, n);
	}
	c->size += size;
	return true;
}

/* Writes the image of point p of the block or, for a bad line, nan. Returns its end. */
static char *put_record(const struct layout *l, const struct chunk *c,
    const struct line *line, size_t p, char *at)
{
	size_t size = format_point_size(l->out.format, 1), written = binary_size(l);
	bool copied = l->output.keeps && line->size == written;

	if (copied)
		memcpy(at, line->s, written);
	/* if the source ends within a record, all numbers of the record become nan */
	int n = copied ? l->writes : (int)(written / size);

	for (int k = 0; k < n; k++) {
		size_t to = size * (size_t)(copied ? layout_field(l, k) : k);

		little_put(at + to, l->out.format == FORMAT_F64,
		    line->kind == LINE_POINT ? c->image[k][p] : (double)NAN);
	}
	return at + written;
}

void binary_put_block(const struct job *j, struct chunk *c,
    const unsigned char *outside)
{
	const struct layout *l = &j->layout;
	char *at = chunk_reserve(c, c->block_lines * binary_size(l));

	for (size_t i = 0, p = 0; i < c->block_lines; i++) {
		const struct line *line = &c->line[i];
		const bool point = line->kind == LINE_POINT;

		if (point ? !j->visible || outside[p] == 0 :
			    line_is_bad(line) && !j->visible)
			at = put_record(l, c, line, p, at);
		p += point;
	}
	c->size = (size_t)(at - c->out);
}
