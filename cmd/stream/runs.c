/* SPDX-License-Identifier: MIT */
#include "runs.h"

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

/* Returns a piece of a line that stands beside a coordinate, without the blanks and
 * separators around it, the coordinate's quotes of csv and, behind the last of JSON,
 * the bracket that closes the line. */
static struct span bare_piece(struct dialect in, struct span piece, bool behind,
    bool before)
{
	const bool quotes = in.format == FORMAT_CSV, table = !format_of(in)->blanks;

	piece = trimmed(in, piece);
	if (behind && quotes && piece.s < piece.end && *piece.s == '"')
		piece.s = skip_blanks(in, piece.s + 1, piece.end);
	if (behind && table && piece.s < piece.end && *piece.s == in.separator)
		piece.s++;
	if (before && quotes && piece.s < piece.end && piece.end[-1] == '"')
		piece = trimmed(in, (struct span){ piece.s, piece.end - 1 });
	if (before && table && piece.s < piece.end && piece.end[-1] == in.separator)
		piece.end--;
	if (!before && in.format == FORMAT_JSON)
		piece.end -= piece.end > piece.s;
	return trimmed(in, piece);
}

/* Adds the name of a point, as struct run describes it. */
static void add_name(const struct job *j, const struct line *line, char *names,
    struct block_head *head, struct run_point *p)
{
	const struct dialect in = j->layout.in;
	const struct span text = line_text(line);
	const int n = j->layout.reads;
	const bool begins = in.format != FORMAT_JSON && in.format != FORMAT_OBJ;
	char *const name = names + head->names, *at = name;
	const char *from = skip_bom(text.s, text.end);
	int order[4];

	line_order(line, n, order);
	for (int k = 0; k <= n; k++) {
		const struct span at_k = k < n ? line_field(line, order[k]) :
						 (struct span){ text.end, text.end };
		const struct span piece = bare_piece(in, (struct span){ from, at_k.s },
		    k > 0, k < n);

		from = at_k.end;
		if (piece.s == piece.end || (k < n && !begins))
			continue;
		if (at > name)
			*at++ = ' ';
		memcpy(at, piece.s, span_size(piece));
		at += span_size(piece);
	}
	p->name = head->names;
	p->name_size = (uint32_t)(at - name);
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
