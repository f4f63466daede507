/* SPDX-License-Identifier: MIT */
/* A chunk is done in blocks: lines are read, their points transformed, and the lines
 * written with the images. */
#include "job.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "../lines/choose.h"

/* Reads the next line of the block with line_read. Returns false where a bad line
 * ends the chunk. */
static bool block_read_line(struct job *j, struct chunk *c, struct span text,
    bool newline)
{
	struct line *line = &c->line[c->block_lines];
	char reason[REASON_MAX];
	double v[4];

	line_read(&j->layout, text, &c->first, line, v, reason);
	line->newline = newline;
	c->refused = line->kind == LINE_REFUSED;
	if (line_is_bad(line) && !chunk_complain(j, c, reason))
		return false;
	if (line->kind == LINE_POINT) {
		for (int i = 0; i < j->layout.reads; i++)
			c->in[i][c->block_points] = v[i];
		c->block_points++;
	}
	c->block_lines++;
	return true;
}

static bool block_read_next(struct job *j, struct chunk *c)
{
	const char *newline = memchr(c->text, '\n', (size_t)(c->end - c->text));
	struct span text = { c->text, newline != NULL ? newline : c->end };

	c->text = newline != NULL ? newline + 1 : c->end;
	return block_read_line(j, c, text, newline != NULL);
}

/* Adds n walked lines to the block, with their numbers v. Line i is read with
 * line_read if bit i of rest is set. Returns false where a bad line ends the chunk. */
static bool block_add(struct job *j, struct chunk *c, size_t n, uint64_t rest,
    double v[4][PLAIN_BATCH])
{
	for (size_t i = 0; i < n; i++) {
		size_t end = rest >> i == 0 ?
		    n :
		    i + (size_t)__builtin_ctzll(rest >> i);

		for (int k = 0; k < j->layout.reads; k++)
			memcpy(&c->in[k][c->block_points], &v[k][i],
			    (end - i) * sizeof v[k][i]);
		c->block_points += end - i;
		c->block_lines += end - i;
		i = end;
		if (end < n &&
		    !block_read_line(j, c, line_text(&c->line[c->block_lines]),
			true))
			return false;
	}
	return true;
}

/* Reads some of the next lines of the stretch. */
static bool block_walk(struct job *j, struct chunk *c, const struct walk *walk)
{
	struct line *line = &c->line[c->block_lines];
	size_t n = POINTS_BLOCK - c->block_lines;
	const struct layout *l = &j->layout;
	struct plain_places at[4];
	double v[4][PLAIN_BATCH];
	uint64_t rest;

	n = walk_lines(&c->stretch, walk, n < PLAIN_BATCH ? n : PLAIN_BATCH,
	    line, at, &rest);
	rest = walk_numbers(walk, line, n, at, rest, c->end, v);
	for (size_t i = 0; i < n && l->append; i++) {
		struct span text = line_text(&line[i]);

		if (line[i].object ? choose_may_clash(l, text) :
				     l->fields > 0 &&
			    choose_count(cut_line(l->in, text)) != l->fields)
			rest |= 1ull << i;
	}
	c->text = c->stretch.text + c->stretch.at;
	return block_add(j, c, n, rest, v);
}

/* Reads up to POINTS_BLOCK lines, and their points into the chunk's columns. A bad
 * line ends the chunk unless the job keeps going. */
static void block_read(struct job *j, struct chunk *c)
{
	struct stretch *s = &c->stretch;
	bool more = true, planned = false, walks = false;
	struct walk walk;

	while (more && c->block_lines < POINTS_BLOCK && c->text < c->end) {
		/* a header, which is line_read's, says where the columns are */
		if (!planned && !c->first) {
			planned = true;
			walks = plain_reader() != NULL &&
			    walk_plan(&j->layout, &walk);
		}
		if (walks &&
		    (s->at < s->end || stretch_open(s, &walk, c->text, c->end)))
			more = block_walk(j, c, &walk);
		else
			more = block_read_next(j, c);
	}
}

/* Transforms the block's points. Rays are exact in every precision; single rounds
 * them to floats. */
static void block_transform(const struct job *j, struct chunk *c)
{
	bool single = j->precision == PRECISION_SINGLE ||
	    j->layout.out.format == FORMAT_F32;
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	double *const out[6] = { c->image[0], c->image[1], c->image[2],
		c->image[3], c->image[4], c->image[5] };

	if (j->rays)
		rays_cast(&j->ray, single, in, out, out + 3, c->block_points);
	else
		points_map(&j->transform, j->precision, in, out,
		    c->block_points);
}

/* Replaces each coordinate of the image of point p by nan if it is not finite as it is
 * written. Returns whether any is nan. In precision exact a float is computed anew:
 * a double that is rounded to a float may not be the nearest float. */
static bool mark_point(const struct job *j, struct chunk *c, size_t p)
{
	bool nan = false, narrow = j->layout.out.format == FORMAT_F32;
	double in[4];

	for (int i = 0; i < 4; i++)
		in[i] = c->in[i][p];
	for (int k = 0; k < j->layout.writes; k++) {
		double *v = &c->image[k][p];

		if (narrow && !isnan(*v) && !j->rays &&
		    j->precision == PRECISION_EXACT)
			*v = (double)point_single(&j->transform, in, k, *v);
		if (!isfinite(narrow ? (double)(float)*v : *v)) {
			*v = (double)NAN;
			nan = true;
		}
	}
	return nan;
}

/* Marks and counts the points without image. Vectors search the block for any of
 * them before each point is looked at. */
static void block_mark(const struct job *j, struct chunk *c)
{
	double odd = j->layout.out.format == FORMAT_F32;

	for (int k = 0; k < j->layout.writes; k++)
		for (size_t i = 0; i < c->block_points; i++)
			odd = fabs(c->image[k][i]) <= DBL_MAX ? odd : 1;
	for (size_t i = 0, p = 0; i < c->block_lines && odd > 0; i++)
		if (c->line[i].kind == LINE_POINT && mark_point(j, c, p++) &&
		    c->imageless++ == 0)
			c->first_imageless = c->n_lines + i;
}

/* The state of block_write. */
struct writer {
	const struct job *job;
	struct chunk *chunk;
	bool
	    in_place; /* images take the places of points, or follow the line */
	bool adds;    /* values follow those that were read */
	int order[4]; /* the coordinates in their order on the line before */
	unsigned char outside[POINTS_BLOCK]; /* planes, for each point */

	/* The texts of a batch of points: enough of them for vectors, few enough
	 * for the first cache. */
	size_t batch; /* its first point */
	struct number_text text[COORDINATES_MAX][NUMBER_BATCH];
};

/* Makes the texts of the batch of point p, unless they are there. */
static void make_texts(struct writer *w, size_t p)
{
	const struct layout *l = &w->job->layout;
	size_t from = p - p % NUMBER_BATCH;
	size_t rest = w->chunk->block_points - from;

	if (w->batch == from)
		return;
	for (int k = 0; k < l->writes; k++)
		number_texts(&w->chunk->image[k][from],
		    rest < NUMBER_BATCH ? rest : NUMBER_BATCH, l->single,
		    l->style[k], w->text[k]);
	w->batch = from;
}

/* Returns whether the n coordinates of a line are in their order. */
static inline bool is_in_order(const struct line *line, int n)
{
	for (int k = 1; k < n; k++)
		if (line->at[k].from < line->at[k - 1].from)
			return false;
	return true;
}

/* Sorts the coordinates by their places on the line. */
static void find_order(const struct line *line, int n, int order[4])
{
	for (int i = 1; i < n; i++)
		for (int k = i; k > 0 &&
		     line->at[order[k - 1]].from > line->at[order[k]].from;
		     k--) {
			int after = order[k];

			order[k] = order[k - 1];
			order[k - 1] = after;
		}
}

/* Returns the end of a line's text without a closing bracket. */
static inline uint32_t end_of_fields(const struct layout *l,
    const struct line *line)
{
	return line->size - (*format_of(l->out)->close != '\0');
}

/* Returns whether put_in_place can add values to a line whose n coordinates are in
 * their order: one byte separates them, neither quotes nor, by --append, blanks end
 * the fields. */
static inline bool takes_more(const struct layout *l, const struct line *line,
    int n)
{
	uint32_t last = line->at[n - 1].to;

	if (l->append &&
	    (is_blank(line->s[line->size - 1]) ||
		is_blank(line->s[end_of_fields(l, line) - 1])))
		return false;
	if (format_of(l->out)->blanks)
		return line->at[n - 1].from - line->at[n - 2].to == 1;
	return !line->object &&
	    (!format_of(l->out)->header || last == line->size ||
		line->s[last] != '"');
}

/* Returns the separator before each value that is added. */
static inline char separator(const struct layout *l, const struct line *line,
    int n)
{
	return format_of(l->out)->blanks ? line->s[line->at[n - 2].to] :
					   l->out.separator;
}

static inline char *put_flags(const struct layout *l, const struct word *w,
    char *at)
{
	bool quoted = *format_of(l->out)->open != '\0';

	*at = '"';
	memcpy(at + quoted, w->s, sizeof w->s);
	at += quoted + w->size;
	*at = '"';
	return at + quoted;
}

/* Writes coordinate k of the image of point p. */
static inline char *put_coordinate(const struct writer *w, int k, size_t p,
    char *at)
{
	return line_put(&w->job->layout, k, &w->text[k][p % NUMBER_BATCH],
	    w->chunk->image[k][p], at);
}

/* Copies the line's bytes from done to next. Most gaps have one byte, so that one is
 * copied in any case. */
static inline char *put_gap(const struct line *line, uint32_t done,
    uint32_t next, char *at)
{
	*at = line->s[done];
	if (next - done > 1)
		memcpy(at, line->s + done, next - done);
	return at + (next - done);
}

/* Writes the same as line_write, for lines that keep their form. order is that of the
 * coordinates on the line, or NULL if they are in their order. */
static inline __attribute__((always_inline)) char *
put_in_place(struct writer *w, const struct line *line, const int *order,
    size_t p, char *at)
{
	const struct layout *l = &w->job->layout;
	uint32_t done = 0;
	int written = l->append ? 0 : l->reads;

	for (int i = 0; i < written; i++) {
		int k = order != NULL ? order[i] : i;

		at = put_gap(line, done, line->at[k].from, at);
		at = put_coordinate(w, k, p, at);
		done = line->at[k].to;
	}
	if (l->append) {
		done = end_of_fields(l, line);
		at = put_gap(line, 0, done, at);
	}
	for (int k = written; k < l->writes; k++) {
		*at++ = separator(l, line, l->reads);
		at = put_coordinate(w, k, p, at);
	}
	if (l->flags) {
		*at++ = separator(l, line, l->reads);
		at = put_flags(l, chunk_word(w->chunk, w->outside[p]), at);
	}
	at = put_gap(line, done, line->size, at);
	*at = '\n';
	return at + line->newline;
}

/* Writes the line of point p with its image. */
static char *put_image(struct writer *w, const struct line *line, size_t p,
    char *at)
{
	const struct layout *l = &w->job->layout;

	make_texts(w, p);
	if (w->in_place && is_in_order(line, l->reads) &&
	    (!w->adds || takes_more(l, line, l->reads)))
		return put_in_place(w, line, NULL, p, at);
	if (w->in_place && !w->adds) {
		find_order(line, l->reads, w->order);
		return put_in_place(w, line, w->order, p, at);
	}
	const struct numbers n = { &w->chunk->image[0][p],
		&w->text[0][p % NUMBER_BATCH], POINTS_BLOCK, NUMBER_BATCH };

	return line_write(l, line, &n,
	    l->flags ? chunk_word(w->chunk, w->outside[p]) : NULL, at);
}

/* Writes a line that is no point: comments and headers as line_write does, a bad line
 * with nan for each coordinate. */
static char *put_other(const struct layout *l, const struct line *line,
    char *at)
{
	static const double nan = (double)NAN;
	static const struct number_text none = { .layout = 0 };
	static const struct word flag = { "nan", 3 };
	const struct numbers n = { &nan, &none, 0, 0 };

	return line_write(l, line, &n,
	    line_is_bad(line) && l->flags ? &flag : NULL, at);
}

/* Writes a line or a binary point, which is point p if it is any. */
static char *put_line(struct writer *w, const struct line *line, size_t p,
    char *at)
{
	const struct job *j = w->job;
	bool point = line->kind == LINE_POINT, bad = line_is_bad(line);

	if (j->visible && (point ? w->outside[p] != 0 : bad))
		return at;
	if (is_binary(j->layout.out.format))
		return point || bad ?
		    binary_put(&j->layout, w->chunk, line, p, at) :
		    at;
	return point ? put_image(w, line, p, at) :
		       put_other(&j->layout, line, at);
}

/* Reserves room for a batch of lines, the first of which is line i. Returns where they
 * are written. */
static char *reserve_lines(const struct layout *l, struct chunk *c, size_t i)
{
	size_t rest = c->block_lines - i;
	size_t n = rest < NUMBER_BATCH ? rest : NUMBER_BATCH;
	const struct line *first = &c->line[i], *last = &first[n - 1];
	size_t bytes = (size_t)(last->s + last->size - first->s);

	return chunk_reserve(c,
	    is_binary(l->out.format) ? n * binary_written(l) :
				       lines_room(l, n, bytes));
}

/* Appends the block's lines, with the images of its points, to the chunk's out. */
static void block_write(const struct job *j, struct chunk *c)
{
	const struct layout *l = &j->layout;
	struct writer w; /* no initializer, which would clear the texts */
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	char *at = NULL;

	w.job = j;
	w.chunk = c;
	w.batch = SIZE_MAX;
	for (int k = 0; k < 4; k++)
		w.order[k] = k;
	w.adds = l->append || l->flags || l->reads < l->writes;
	w.in_place = same_dialect(l->in, l->out) &&
	    (l->append || l->reads <= l->writes);
	block_mark(j, c);
	if (l->flags || j->visible)
		frustum_out_all(&j->frustum, in, w.outside, c->block_points);
	for (size_t i = 0, p = 0; i < c->block_lines; i++) {
		if (i % NUMBER_BATCH == 0)
			at = reserve_lines(l, c, i);
		at = put_line(&w, &c->line[i], p, at);
		c->size = (size_t)(at - c->out);
		p += c->line[i].kind == LINE_POINT;
	}
}

void job_do(struct job *j, struct chunk *c)
{
	bool binary = is_binary(j->layout.in.format);
	bool whole = binary_is_whole(j);

	c->n_lines = c->size = c->n_complaints = c->imageless = 0;
	c->refused = false;
	c->text = c->stretch.readable = c->piece.text;
	c->end = c->text + c->piece.whole;
	c->stretch.at = c->stretch.end = 0;
	for (; c->text < c->end; c->n_lines += c->block_lines) {
		const char *text = c->text;

		c->block_lines = c->block_points = 0;
		/* after one point without image there will be others */
		if (whole && c->imageless == 0 && binary_carry(j, c))
			continue;
		if (binary)
			binary_read(j, c);
		else
			block_read(j, c);
		if (j->take != NULL) {
			j->take(j, c);
			continue;
		}
		block_transform(j, c);
		if (!(whole && c->block_lines == c->block_points &&
			binary_join(j, c, text)))
			block_write(j, c);
	}
}
