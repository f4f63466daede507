/* SPDX-License-Identifier: MIT */
/* The lines of a block, with images in the place of their points. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "job.h"

enum { BATCH = NUMBER_BATCH };

/* The texts of a batch of points, the first of which is point from: many enough to be
 * made by vectors, few enough to stay in the nearest cache. */
struct texts {
	size_t from;
	struct number_text text[COORDINATES_MAX][BATCH];
};

/* A block on its way out. */
struct block {
	const struct job *job;
	struct chunk *chunk;
	size_t points;
	bool in_place; /* numbers change where they stand */
	bool adds;     /* numbers or a word follow those that were read */
	int order[4];  /* in which coordinates stand on the line before */
	unsigned char
	    outside[POINTS_BLOCK]; /* the planes each point is outside of */
	struct texts texts;
};

/* Makes the texts of the batch of point p, unless they are there. */
static void need_texts(struct block *b, size_t p)
{
	const struct layout *l = &b->job->layout;
	struct texts *t = &b->texts;
	size_t from = p - p % BATCH, rest = b->points - from;

	if (t->from == from)
		return;
	for (int k = 0; k < l->writes; k++)
		number_texts(&b->chunk->image[k][from],
		    rest < BATCH ? rest : BATCH, l->single, l->style[k],
		    t->text[k]);
	t->from = from;
}

/* Returns "in", or the planes that the point is outside of, as left+near. */
static struct word make_word(unsigned outside)
{
	static const struct word names[] = { { "left", 4 }, { "right", 5 },
		{ "bottom", 6 }, { "top", 3 }, { "near", 4 }, { "far", 3 },
		{ "behind", 6 }, { "nan", 3 } };
	struct word w = { "in", 2 };

	for (int k = 0; k < 8; k++) {
		if ((outside >> k & 1) == 0)
			continue;
		if (outside & ((1u << k) - 1))
			w.s[w.size++] = '+';
		else
			w.size = 0;
		memcpy(w.s + w.size, names[k].s, names[k].size);
		w.size += names[k].size;
	}
	return w;
}

/* The chunk keeps its words, as there are few and each is needed often. */
const struct word *word_for(struct chunk *c, unsigned outside)
{
	struct word *w = &c->word[outside];

	if (w->size == 0)
		*w = make_word(outside);
	return w;
}

/* Returns whether the n coordinates of a line stand in their order. */
static inline bool is_in_order(const struct line *line, int n)
{
	for (int k = 1; k < n; k++)
		if (line->at[k].from < line->at[k - 1].from)
			return false;
	return true;
}

/* Finds the order in which they stand, most often that of the line before. */
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

/* Returns whether what is added behind the last of n numbers, which stand in their
 * order, has the usual separator before it, and no quote. */
static inline bool takes_more(const struct layout *l, const struct line *line,
    int n)
{
	uint32_t last = line->at[n - 1].to;

	if (format_of(l->out)->blanks)
		return line->at[n - 1].from - line->at[n - 2].to == 1;
	return !line->object &&
	    (!format_of(l->out)->header || last == line->size ||
		line->s[last] != '"');
}

/* Returns that separator. */
static inline char separator(const struct layout *l, const struct line *line,
    int n)
{
	return format_of(l->out)->blanks ? line->s[line->at[n - 2].to] :
					   l->out.separator;
}

static inline char *put_word(const struct layout *l, const struct word *w,
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
static inline char *block_put_number(const struct block *b, int k, size_t p,
    char *at)
{
	return line_put(&b->job->layout, k, &b->texts.text[k][p % BATCH],
	    b->chunk->image[k][p], at);
}

/* Copies the line from done up to what is next; as most gaps are of one byte, a byte
 * is copied even where there is none. */
static inline char *put_gap(const struct line *line, uint32_t done,
    uint32_t next, char *at)
{
	*at = line->s[done];
	if (next - done > 1)
		memcpy(at, line->s + done, next - done);
	return at + (next - done);
}

/* Writes what line_write would where numbers change in place, in an order of their
 * own or NULL, and what is added follows them, without a look at what cannot be. */
static inline __attribute__((always_inline)) char *put_in_place(struct block *b,
    const struct line *line, const int *order, size_t p, char *at)
{
	const struct layout *l = &b->job->layout;
	uint32_t done = 0;

	for (int i = 0; i < l->reads; i++) {
		int k = order != NULL ? order[i] : i;

		at = put_gap(line, done, line->at[k].from, at);
		at = block_put_number(b, k, p, at);
		done = line->at[k].to;
	}
	for (int k = l->reads; k < l->writes; k++) {
		*at++ = separator(l, line, l->reads);
		at = block_put_number(b, k, p, at);
	}
	if (l->flags) {
		*at++ = separator(l, line, l->reads);
		at = put_word(l, word_for(b->chunk, b->outside[p]), at);
	}
	at = put_gap(line, done, line->size, at);
	*at = '\n';
	return at + line->newline;
}

/* Writes the line of point p with its image. */
static char *block_put_image(struct block *b, const struct line *line, size_t p,
    char *at)
{
	const struct layout *l = &b->job->layout;

	need_texts(b, p);
	if (b->in_place && is_in_order(line, l->reads) &&
	    (!b->adds || takes_more(l, line, l->reads)))
		return put_in_place(b, line, NULL, p, at);
	if (b->in_place && !b->adds) {
		find_order(line, l->reads, b->order);
		return put_in_place(b, line, b->order, p, at);
	}
	const struct numbers n = { &b->chunk->image[0][p],
		&b->texts.text[0][p % BATCH], POINTS_BLOCK, BATCH };

	return line_write(l, line, &n,
	    l->flags ? word_for(b->chunk, b->outside[p]) : NULL, at);
}

/* Writes a line that is no point: a comment or a header as it is, a bad line as
 * nan in each coordinate. */
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

/* Writes a line, or the binary point that takes its place. If it is a point, that is
 * point p. */
static char *put_line(struct block *b, const struct line *line, size_t p,
    char *at)
{
	const struct job *j = b->job;
	bool point = line->kind == LINE_POINT, bad = line_is_bad(line);

	if (j->visible && (point ? b->outside[p] != 0 : bad))
		return at;
	if (is_binary(j->layout.out.format))
		return point || bad ?
		    binary_put(&j->layout, b->chunk, line, p, at) :
		    at;
	return point ? block_put_image(b, line, p, at) :
		       put_other(&j->layout, line, at);
}

/* Writes lines i to end - 1 of the chunk's, whose first point is p. Returns the point
 * after them. */
static size_t write_lines(struct block *b, size_t i, size_t end, size_t p)
{
	const struct layout *l = &b->job->layout;
	struct chunk *c = b->chunk;
	const struct line *last = &c->line[end - 1];
	size_t bytes = (size_t)(last->s + last->size - c->line[i].s);
	char *at = chunk_reserve(c,
	    is_binary(l->out.format) ? (end - i) * binary_written(l) :
				       lines_room(l, end - i, bytes));

	for (; i < end; i++) {
		at = put_line(b, &c->line[i], p, at);
		p += c->line[i].kind == LINE_POINT;
	}
	c->size = (size_t)(at - c->out);
	return p;
}

/* Makes nan of each coordinate of the image of point p that is not finite, as it is
 * written. Returns whether there is any. By precision exact a float is computed anew:
 * what is rounded to a double and then to a float may not be the nearest float. */
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

/* Marks and counts the points without image; number is that of the first line. A
 * search for any of them first, by vectors, saves 1 % of text. */
static void mark(const struct job *j, struct chunk *c, size_t n, size_t points,
    size_t number)
{
	double odd = j->layout.out.format == FORMAT_F32;
	size_t p = 0;

	for (int k = 0; k < j->layout.writes; k++)
		for (size_t i = 0; i < points; i++)
			odd = fabs(c->image[k][i]) <= DBL_MAX ? odd : 1;
	for (size_t i = 0; i < n && odd > 0; i++)
		if (c->line[i].kind == LINE_POINT && mark_point(j, c, p++) &&
		    c->imageless++ == 0)
			c->first_imageless = number + i;
}

void block_write(const struct job *j, struct chunk *c, size_t n, size_t points,
    size_t number)
{
	const struct layout *l = &j->layout;
	struct block b; /* of which its texts would take long to be cleared */
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	size_t p = 0;

	b.job = j;
	b.chunk = c;
	b.points = points;
	b.texts.from = SIZE_MAX;
	for (int k = 0; k < 4; k++)
		b.order[k] = k;
	b.adds = l->flags || l->reads < l->writes;
	b.in_place = same_dialect(l->in, l->out) && l->reads <= l->writes &&
	    !l->append;
	mark(j, c, n, points, number);
	if (l->flags || j->visible)
		frustum_out_all(&j->frustum, in, b.outside, points);
	for (size_t i = 0; i < n; i += BATCH)
		p = write_lines(&b, i, n - i < BATCH ? n : i + BATCH, p);
}
