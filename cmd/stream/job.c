/* SPDX-License-Identifier: MIT */
/* Does a job on a chunk in blocks: reads lines, transforms points, writes images. */
#include "job.h"

#include <math.h>
#include <string.h>

#include "../../core/points/point.h"
#include "../../core/points/points.h"
#include "binary.h"

/* Reads the next line, `text`, to the block. Returns false if the chunk ends there. */
static bool block_read_line(struct job *j, struct chunk *c, struct span text,
    bool newline)
{
	struct line *line = &c->line[c->block_lines];
	struct refusal r;
	double v[4];

	plan_line(&j->layout, text, &c->first, line, v, &r);
	line->newline = newline;
	c->refused = line->kind == LINE_REFUSED;
	if (line_is_bad(line) && !chunk_complain(j, c, &r))
		return false;
	if (line->kind == LINE_POINT) {
		for (int i = 0; i < j->layout.reads; i++)
			c->in[i][c->block_points] = v[i];
		c->block_points++;
	}
	c->block_lines++;
	return true;
}

/* Adds n lines, by plan_line if set in unread. Returns false if the chunk ends. */
static bool block_add_lines(struct job *j, struct chunk *c, size_t n, uint64_t unread,
    double v[4][PLAIN_BATCH])
{
	for (size_t i = 0; i < n; i++) {
		size_t end = unread >> i == 0 ?
		    n :
		    i + (size_t)__builtin_ctzll(unread >> i);

		for (int k = 0; k < j->layout.reads; k++)
			memcpy(&c->in[k][c->block_points], &v[k][i],
			    (end - i) * sizeof v[k][i]);
		c->block_points += end - i;
		c->block_lines += end - i;
		i = end;
		if (end < n &&
		    !block_read_line(j, c, line_text(&c->line[c->block_lines]), true))
			return false;
	}
	return true;
}

static bool block_walk(struct job *j, struct chunk *c)
{
	const struct walk *walk = &c->walk;
	struct line *line = &c->line[c->block_lines];
	size_t n = POINTS_BLOCK - c->block_lines;
	struct plain_places at[4];
	double v[4][PLAIN_BATCH];
	uint64_t unread;

	n = walk_lines(&c->stretch, walk, n < PLAIN_BATCH ? n : PLAIN_BATCH, line, at,
	    &unread);
	unread = walk_numbers(walk, line, n, at, unread, v);
	c->text = c->stretch.text + c->stretch.at;
	return block_add_lines(j, c, n, unread, v);
}

static void block_read(struct job *j, struct chunk *c)
{
	struct stretch *s = &c->stretch;
	bool more = true;

	while (more && c->block_lines < POINTS_BLOCK && c->text < c->end) {
		/* the first row completes the plan */
		if (!c->walk_planned && !c->first) {
			c->walk_planned = true;
			c->can_walk = number_loops_chosen() != NULL &&
			    plan_walk(&j->layout, &c->walk);
		}
		if (c->can_walk &&
		    (s->at < s->end || stretch_open(s, &c->walk, c->text, c->end))) {
			more = block_walk(j, c);
			continue;
		}
		const char *newline = memchr(c->text, '\n', (size_t)(c->end - c->text));
		struct span text = { c->text, newline != NULL ? newline : c->end };

		c->text = newline != NULL ? newline + 1 : c->end;
		more = block_read_line(j, c, text, newline != NULL);
	}
}

/* Returns true only if all images are finite. Rays are exact in every precision. */
static bool block_transform(const struct job *j, struct chunk *c)
{
	bool single = j->precision == PRECISION_SINGLE ||
	    j->layout.out.format == FORMAT_F32;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	double *const out[6] = { c->image[0], c->image[1], c->image[2], c->image[3],
		c->image[4], c->image[5] };

	return j->rays ?
	    rays_cast(&j->ray, single, in, out, out + 3, c->block_points) :
	    points_map(&j->transform, j->precision, in, out, c->block_points);
}

/* Makes nan of each coordinate that is not finite in the output's format; returns
 * whether any is. The nearest double may round to a float that is not the nearest. */
static bool mark_nan(const struct job *j, struct chunk *c, size_t p)
{
	bool nan = false, narrow = j->layout.out.format == FORMAT_F32;
	double in[4];

	for (int i = 0; i < 4; i++)
		in[i] = c->in[i][p];
	for (int k = 0; k < j->layout.writes; k++) {
		double *v = &c->image[k][p];

		if (narrow && !isnan(*v) && !j->rays && j->precision == PRECISION_EXACT)
			*v = (double)point_exact_float(&j->transform, in, k, *v);
		if (!isfinite(narrow ? (double)(float)*v : *v)) {
			*v = (double)NAN;
			nan = true;
		}
	}
	return nan;
}

static void write_lines(const struct job *j, struct chunk *c,
    const unsigned char *outside)
{
	const struct layout *l = &j->layout;
	const struct line *last = &c->line[c->block_lines - 1];
	const size_t bytes = (size_t)(last->s + last->size - c->line[0].s);
	const struct emit_block b = { .line = c->line,
		.lines = c->block_lines,
		.points = c->block_points,
		.image = (const double(*)[POINTS_BLOCK])c->image,
		.outside = outside,
		.visible = j->visible,
		.words = &c->words };
	char *out = chunk_reserve(c, emit_room(l, c->block_lines, bytes));

	c->size = (size_t)(emit_lines(l, &b, out) - c->out);
}

/* Returns whether w of a point is not positive. Doubles decide this but for points in
 * the plane of the eye: the errors of four products and their sum are within 2^-40. */
static bool is_behind(const struct job *j, const struct chunk *c, size_t p)
{
	const struct kernel_map *k = &j->transform.for_kernel;
	double in[4], w = k->hi[3][3], size = fabs(w);

	for (int i = 0; i < 4; i++)
		in[i] = c->in[i][p];
	for (int i = 0; i < j->transform.in; i++)
		if (isnan(in[i]))
			return false;
	for (int i = 0; i < 3; i++) {
		const double product = (in[i] - k->origin[i]) * k->hi[i][3];

		w += product;
		size += fabs(product);
	}
	if (j->transform.in == 3 && fabs(w) > 0x1p-40 * size)
		return w < 0;
	return sum_sign(point_column(&j->transform, 3, in)) <= 0;
}

/* Counts point p of the block, on its line i. */
static void count_imageless(const struct job *j, struct chunk *c, size_t i, size_t p)
{
	if (c->imageless == 0)
		c->first_imageless = c->n_lines + i;
	if (j->behind != BEHIND_NOTHING && c->behind == c->imageless)
		c->behind += is_behind(j, c, p);
	c->imageless++;
}

/* `finite` may be true only if all images are finite doubles. */
static void block_write(const struct job *j, struct chunk *c, bool finite)
{
	const struct layout *l = &j->layout;
	const size_t n = c->block_lines;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	unsigned char outside[POINTS_BLOCK]; /* frustum_outside of point p */

	if (n == 0)
		return;
	if (!finite || l->out.format == FORMAT_F32)
		for (size_t i = 0, p = 0; i < n; i++)
			if (c->line[i].kind == LINE_POINT && mark_nan(j, c, p++))
				count_imageless(j, c, i, p - 1);
	if (l->output.flags || j->visible)
		frustum_outside_all(&j->frustum, in, outside, c->block_points);
	if (format_is_binary(l->out.format))
		binary_put_block(j, c, outside);
	else
		write_lines(j, c, outside);
}

void job_do(struct job *j, struct chunk *c)
{
	bool binary = format_is_binary(j->layout.in.format);
	bool by_blocks = binary_is_rows(j);

	c->n_lines = c->size = c->n_complaints = c->imageless = c->behind = 0;
	c->refused = c->walk_planned = c->can_walk = false;
	c->text = c->stretch.readable = c->piece.text;
	c->end = c->text + c->piece.whole_size;
	c->stretch.at = c->stretch.end = 0;
	c->block_lines = 0;
	c->is_list = j->layout.plan.is_list;
	if (c->first == FIRST_BYTE) {
		if (j->layout.plan.drops_bom && !binary)
			c->text = skip_bom(c->text, c->end);
		c->first = binary ? FIRST_NONE : FIRST_LINE;
	}
	for (; c->text < c->end; c->n_lines += c->block_lines) {
		const char *text = c->text;

		c->block_lines = c->block_points = 0;
		/* after a point without image binary_map_floats often fails */
		if (by_blocks && c->imageless == 0 && binary_map_floats(j, c))
			continue;
		if (binary)
			binary_read_block(j, c);
		else
			block_read(j, c);
		if (j->take_block != NULL) {
			j->take_block(j, c);
			continue;
		}
		bool finite = block_transform(j, c);

		if (!(by_blocks && c->block_lines == c->block_points &&
			binary_write_rows(j, c, text)))
			block_write(j, c, finite);
	}
}
