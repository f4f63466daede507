/* SPDX-License-Identifier: MIT */
#include "runs.h"

#include <stdlib.h>
#include <string.h>

#include "../../core/points/points.h"
#include "../message/grow.h"

/* A chunk's out has, for each block: struct block_head, the points, and their names up
 * to a multiple of the alignment. A point whose only bit is OUT_NAN ends a run. */
struct block_head {
	size_t points, names; /* how many points; bytes of names */
};

enum { NAMES_UNIT = _Alignof(struct run_point) };

static size_t names_stride(size_t size)
{
	return (size + NAMES_UNIT - 1) / NAMES_UNIT * NAMES_UNIT;
}

/* Returns whether no point follows the one before: the line is blank or bad. Comments,
 * headers and the other lines of obj are no part of the points. */
static bool ends_run(const struct job *j, const struct line *line)
{
	const struct span text = line_text(line);

	return line_is_bad(line) ||
	    (line->kind == LINE_COPY &&
		skip_blanks(j->layout.in, skip_bom(text.s, text.end), text.end) ==
		    text.end);
}

/* Returns what follows the coordinates of a line. */
static struct span after_coordinates(const struct job *j, const struct line *line)
{
	const struct dialect in = j->layout.in;
	struct span rest = line_text(line);
	uint32_t from = 0;

	for (int k = 0; k < j->layout.reads; k++)
		from = line->at[k].to > from ? line->at[k].to : from;
	rest.s += from;
	rest = trimmed(in, rest);
	/* a quote of csv that closes the coordinate, and the separator */
	if (in.format == FORMAT_CSV && rest.s < rest.end && *rest.s == '"')
		rest.s = skip_blanks(in, rest.s + 1, rest.end);
	if (!format_of(in)->blanks && rest.s < rest.end && *rest.s == in.separator)
		rest.s++;
	if (in.format == FORMAT_JSON)
		rest.end -= rest.end > rest.s;
	return trimmed(in, rest);
}

/* Returns what is before the coordinates of a line of text or of a table. */
static struct span before_coordinates(const struct job *j, const struct line *line)
{
	const struct dialect in = j->layout.in;
	struct span rest = line_text(line);
	uint32_t to = line->size;

	for (int k = 0; k < j->layout.reads; k++)
		to = line->at[k].from < to ? line->at[k].from : to;
	rest.end = rest.s + to;
	rest.s = skip_bom(rest.s, rest.end);
	rest = trimmed(in, rest);
	/* a quote of csv that opens the coordinate, and the separator */
	if (in.format == FORMAT_CSV && rest.s < rest.end && rest.end[-1] == '"')
		rest = trimmed(in, (struct span){ rest.s, rest.end - 1 });
	if (!format_of(in)->blanks && rest.s < rest.end && rest.end[-1] == in.separator)
		rest.end--;
	return trimmed(in, rest);
}

/* Returns the rest of a line, as struct run describes it. */
static struct span rest_of(const struct job *j, const struct line *line)
{
	const struct span after = after_coordinates(j, line);
	const enum format in = j->layout.in.format;

	return after.s < after.end || in == FORMAT_JSON || in == FORMAT_OBJ ?
	    after :
	    before_coordinates(j, line);
}

static void add_name(const struct job *j, const struct line *line, char *names,
    struct block_head *head, struct run_point *p)
{
	const struct span rest = rest_of(j, line);

	p->name = head->names;
	p->name_size = (uint32_t)(rest.end - rest.s);
	memcpy(names + head->names, rest.s, p->name_size);
	head->names += p->name_size;
}

static void set_point(const struct job *j, const struct chunk *c, size_t i,
    unsigned char outside, struct run_point *p)
{
	for (int k = 0; k < j->transform.in; k++)
		p->in[k] = c->in[k][i];
	for (int k = 0; k < j->transform.out; k++)
		p->image[k] = c->image[k][i];
	p->outside = outside;
	p->name_size = 0;
	p->name = 0;
}

static void runs_take_block(const struct job *j, struct chunk *c)
{
	const struct run_reader *r = j->data;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	double *const image[4] = { c->image[0], c->image[1], c->image[2], c->image[3] };
	unsigned char outside[POINTS_BLOCK];
	struct block_head head = { 0 };

	if (c->block_lines == 0)
		return;
	const struct line *last = &c->line[c->block_lines - 1];
	const size_t bytes = (size_t)(last->s + last->size - c->line[0].s);
	const size_t most = sizeof head + c->block_lines * sizeof(struct run_point);
	char *const out = chunk_reserve(c, most + (r->names ? bytes + NAMES_UNIT : 0));
	struct run_point *const point = (void *)(out + sizeof head);
	char *const names = out + most;

	points_map(&j->transform, j->precision, in, image, c->block_points);
	frustum_outside_all(&j->frustum, in, outside, c->block_points);
	for (size_t i = 0, p = 0; i < c->block_lines; i++) {
		struct run_point *to = &point[head.points];

		if (c->line[i].kind == LINE_POINT) {
			set_point(j, c, p, outside[p], to);
			if (r->names)
				add_name(j, &c->line[i], names, &head, to);
			p++;
		} else if (ends_run(j, &c->line[i])) {
			*to = (struct run_point){ .outside = OUT_NAN };
		} else {
			continue;
		}
		head.points++;
	}
	memcpy(out, &head, sizeof head);
	memmove(&point[head.points], names, head.names);
	c->size += sizeof head + head.points * sizeof *point + names_stride(head.names);
}

/* Delivers the run so far. */
static void end_run(struct run_reader *r)
{
	const struct run run = { r->point, r->n, r->text };

	if (r->n > 0)
		r->take(r->data, &run);
	r->n = r->text_size = 0;
}

/* Adds n points, with no end of a run among them, to the run so far. */
static void extend_run(struct run_reader *r, const struct run_point *point, size_t n,
    const char *names)
{
	if (n == 0)
		return;
	const size_t from = point[0].name,
		     size = point[n - 1].name + point[n - 1].name_size - from;

	GROW(r->point, r->n, n);
	memcpy(r->point + r->n, point, n * sizeof *point);
	if (r->names) {
		GROW(r->text, r->text_size, size + 1);
		memcpy(r->text + r->text_size, names + from, size);
		for (size_t i = 0; i < n; i++)
			r->point[r->n + i].name += r->text_size - from;
		r->text_size += size;
	}
	r->n += n;
}

static void runs_collect_chunk(const struct job *j, const struct chunk *c)
{
	struct run_reader *r = j->data;

	for (const char *at = c->out, *end = at + c->size; at < end;) {
		const struct block_head *head = (const void *)at;
		const struct run_point *point = (const void *)(at + sizeof *head);
		const char *names = (const char *)(point + head->points);
		size_t from = 0;

		for (size_t i = 0; i < head->points; i++) {
			if (point[i].outside != OUT_NAN)
				continue;
			extend_run(r, point + from, i - from, names);
			end_run(r);
			from = i + 1;
		}
		extend_run(r, point + from, head->points - from, names);
		at = names + names_stride(head->names);
	}
	if (c->piece.state >= PIECE_LAST)
		end_run(r);
	if (r->flush != NULL)
		r->flush(r->data);
}

static void runs_flush(const struct job *j)
{
	struct run_reader *r = j->data;

	end_run(r);
	if (r->flush != NULL)
		r->flush(r->data);
}

void runs_prepare(struct run_reader *r, struct job *j)
{
	r->n = r->text_size = 0;
	j->take_block = runs_take_block;
	j->collect_chunk = runs_collect_chunk;
	j->flush = runs_flush;
	j->data = r;
}
