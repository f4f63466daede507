/* SPDX-License-Identifier: MIT */
/* The lines of a block, and the points on them. */
#include <string.h>

#include "../lines/choose.h"
#include "job.h"

/* What of a block has been read. */
struct block_in {
	struct job *job;
	struct chunk *chunk;
	size_t lines, points;
};

/* Reads a line as line_read does, and takes its point. Returns false where
 * a bad line ends the chunk. */
static bool read_line(struct block_in *b, struct span text, bool newline)
{
	struct chunk *c = b->chunk;
	struct line *line = &c->line[b->lines];
	char reason[REASON_MAX];
	double v[4];

	line_read(&b->job->layout, text, &c->first, line, v, reason);
	line->newline = newline;
	c->refused = line->kind == LINE_REFUSED;
	if (line_is_bad(line) && !chunk_complain(b->job, c, c->n_lines, reason))
		return false;
	if (line->kind == LINE_POINT) {
		for (int i = 0; i < b->job->layout.reads; i++)
			c->in[i][b->points] = v[i];
		b->points++;
	}
	b->lines++;
	c->n_lines++;
	return true;
}

static bool read_next(struct block_in *b)
{
	struct chunk *c = b->chunk;
	const char *newline = memchr(c->text, '\n', (size_t)(c->end - c->text));
	struct span text = { c->text, newline != NULL ? newline : c->end };

	c->text = newline != NULL ? newline + 1 : c->end;
	return read_line(b, text, newline != NULL);
}

/* Takes n lines that were walked, with their numbers v, but those of left one by
 * one. */
static bool block_take(struct block_in *b, size_t n, uint64_t left,
    double v[4][PLAIN_BATCH])
{
	struct chunk *c = b->chunk;
	int reads = b->job->layout.reads;

	for (size_t i = 0; i < n;) {
		size_t end = left >> i == 0 ?
		    n :
		    i + (size_t)__builtin_ctzll(left >> i);

		for (int k = 0; k < reads; k++)
			memcpy(&c->in[k][b->points], &v[k][i],
			    (end - i) * sizeof v[k][i]);
		b->points += end - i;
		b->lines += end - i;
		c->n_lines += end - i;
		i = end + 1;
		if (end < n &&
		    !read_line(b, line_text(&c->line[b->lines]), true))
			return false;
	}
	return true;
}

/* Reads some of the next lines by way of the stretch. */
static bool read_walked(struct block_in *b, const struct walk *walk)
{
	struct chunk *c = b->chunk;
	size_t n = POINTS_BLOCK - b->lines;
	struct plain_places at[4];
	double v[4][PLAIN_BATCH];
	uint64_t left;

	n = walk_lines(&c->stretch, walk, n < PLAIN_BATCH ? n : PLAIN_BATCH,
	    &c->line[b->lines], at, &left);
	left = walk_numbers(walk, &c->line[b->lines], n, at, left, c->end, v);
	const struct layout *l = &b->job->layout;

	for (size_t i = 0; i < n && l->append; i++) {
		struct span text = line_text(&c->line[b->lines + i]);

		if (c->line[b->lines + i].object ? choose_may_clash(l, text) :
						   l->fields > 0 &&
			    choose_count(cut_line(l->in, text)) != l->fields)
			left |= 1ull << i;
	}
	c->text = c->stretch.text + c->stretch.at;
	return block_take(b, n, left, v);
}

size_t block_read(struct job *j, struct chunk *c, size_t *points)
{
	struct block_in b = { j, c, 0, 0 };
	struct stretch *s = &c->stretch;
	bool more = true, planned = false, walks = false;
	struct walk walk;

	while (more && b.lines < POINTS_BLOCK && c->text < c->end) {
		/* a header says where the columns are; the row behind it is
		 * compared with it */
		if (!planned && !c->first) {
			planned = true;
			walks = plain_reader() != NULL &&
			    walk_plan(&j->layout, &walk);
		}
		if (walks &&
		    (s->at < s->end || stretch_open(s, &walk, c->text, c->end)))
			more = read_walked(&b, &walk);
		else
			more = read_next(&b);
	}
	*points = b.points;
	return b.lines;
}
