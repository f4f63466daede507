/* SPDX-License-Identifier: MIT */
#include "block_write.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "binary.h"

enum { BATCH = NUMBER_BATCH };

/* The texts of the points from from on, made many at a time, but few enough to stay
 * in the nearest cache. */
struct texts {
	size_t from;
	struct number_text text[COORDINATES_MAX][BATCH];
};

/* A block on its way out. */
struct block {
	const struct job *job;
	struct chunk *chunk;
	size_t points;
	bool in_order;                       /* its lines are for put_in_order */
	unsigned char outside[POINTS_BLOCK]; /* of which planes each is */
	struct texts texts;
};

/* Those of point p and of its neighbours, unless there are. */
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

/* "in", or the planes that the point is outside of, as left+near. */
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

/* Kept, as there are few and each is needed often. */
const struct word *word_for(struct chunk *c, unsigned outside)
{
	struct word *w = &c->word[outside];

	if (w->size == 0)
		*w = make_word(outside);
	return w;
}

/* Whether point p is to be written. */
static bool is_wanted(const struct block *b, size_t p)
{
	return !b->job->visible || b->outside[p] == 0;
}

static char *put_point(struct block *b, const struct line *line, size_t p,
    char *at)
{
	struct chunk *c = b->chunk;
	const struct numbers n = { &c->image[0][p],
		&b->texts.text[0][p % BATCH], POINTS_BLOCK, BATCH };

	return line_write(&b->job->layout, line, &n,
	    b->job->flags ? word_for(c, b->outside[p]) : NULL, at);
}

/* Whether in all lines that are points only numbers change, in their order, and what
 * is added, numbers or a word, stands behind them. */
static bool is_in_order(const struct layout *l)
{
	const struct columns *c = &l->columns;

	bool members = l->in.format == FORMAT_JSON && c->name[0] != NULL;

	for (int k = 1; k < c->n && !members; k++)
		if (c->field[k - 1] >= c->field[k])
			return false;
	return same_dialect(l->in, l->out) && l->reads <= l->writes;
}

/* Whether what is added after the last of n numbers has the usual separator before
 * it, and no quote. */
static inline bool takes_more(const struct layout *l, const struct line *line,
    int n)
{
	uint32_t last = line->at[n - 1].to;

	return l->out.format == FORMAT_JSON ||
	    (l->out.format == FORMAT_TEXT ?
		    line->at[n - 1].from - line->at[n - 2].to == 1 :
		    last == line->size || line->s[last] != '"');
}

/* What it is then. */
static inline char separator(const struct layout *l, const struct line *line,
    int n)
{
	return l->out.format == FORMAT_TEXT ? line->s[line->at[n - 2].to] :
					      l->out.separator;
}

static inline char *put_word(const struct layout *l, const struct line *line,
    int n, const struct word *w, char *at)
{
	bool quoted = l->out.format == FORMAT_JSON;

	*at++ = separator(l, line, n);
	*at = '"';
	memcpy(at + quoted, w->s, 16);
	if (w->size > 16)
		memcpy(at + quoted, w->s, sizeof w->s);
	at += quoted + w->size;
	*at = '"';
	return at + quoted;
}

/* Copies what stands before coordinate k, done being where the one before it
 * ended, and writes its image. As most gaps are of one byte, a byte is copied even
 * where there is none. */
static inline char *replace(const struct block *b, const struct line *line,
    int k, uint32_t done, size_t p, char *at)
{
	const struct layout *l = &b->job->layout;
	const char *gap = line->s + done;
	uint32_t size = line->at[k].from - done;

	*at = *gap;
	if (size > 1)
		memcpy(at, gap, size);
	return number_put(at + size, &b->texts.text[k][p % BATCH],
	    b->chunk->image[k][p], l->single, l->style[k]);
}

static inline char *put_rest(const struct line *line, uint32_t done, char *at)
{
	uint32_t rest = line->size - done;

	if (rest > 1)
		memcpy(at, line->s + done, rest);
	else if (rest == 1) /* the bracket of JSON */
		*at = line->s[done];
	at += rest;
	*at = '\n';
	return at + line->newline;
}

/* What line_write does then, without a look at what cannot be. */
static char *put_in_order(struct block *b, const struct line *line, size_t p,
    char *at)
{
	const struct layout *l = &b->job->layout;
	uint32_t done = 0;

	for (int k = 0; k < l->reads; done = line->at[k++].to)
		at = replace(b, line, k, done, p, at);
	for (int k = l->reads; k < l->writes; k++) {
		*at++ = separator(l, line, l->reads);
		at = number_put(at, &b->texts.text[k][p % BATCH],
		    b->chunk->image[k][p], l->single, l->style[k]);
	}
	if (b->job->flags)
		at = put_word(l, line, l->reads,
		    word_for(b->chunk, b->outside[p]), at);
	return put_rest(line, done, at);
}

/* Whether in the object only numbers change, in their order. */
static bool is_plain_object(const struct job *j, const struct line *line)
{
	for (int k = 1; k < j->layout.reads; k++)
		if (line->at[k].from < line->at[k - 1].from)
			return false;
	return !j->flags && j->layout.reads == j->layout.writes;
}

/* Writes the line of point p with its image, if it is wanted. */
static char *put_image(struct block *b, const struct line *line, size_t p,
    char *at)
{
	const struct job *j = b->job;
	const struct layout *l = &j->layout;

	if (!is_wanted(b, p))
		return at;
	need_texts(b, p);
	if (line->object && !is_plain_object(j, line))
		return put_point(b, line, p, at);
	return b->in_order && takes_more(l, line, l->reads) ?
	    put_in_order(b, line, p, at) :
	    put_point(b, line, p, at);
}

/* Writes a line that is no point: a comment or a header as it is, a bad line as
 * nan in each coordinate. */
static char *put_other(const struct job *j, const struct line *line, char *at)
{
	static const double nan = (double)NAN;
	static const struct number_text none = { .layout = 0 };
	static const struct word flag = { "nan", 3 };
	const struct numbers n = { &nan, &none, 0, 0 };
	bool bad = line_is_bad(line);

	if (bad && j->visible)
		return at;
	return line_write(&j->layout, line, &n, bad && j->flags ? &flag : NULL,
	    at);
}

/* Lines i to end - 1 of the chunk's, whose first point is p. Returns the point
 * after them. */
static size_t write_lines(struct block *b, size_t i, size_t end, size_t p)
{
	struct chunk *c = b->chunk;
	const struct line *last = &c->line[end - 1];
	size_t bytes = (size_t)(last->s + last->size - c->line[i].s);
	char *at = chunk_reserve(c,
	    lines_room(&b->job->layout, end - i, bytes));

	for (; i < end; i++)
		at = c->line[i].kind == LINE_POINT ?
		    put_image(b, &c->line[i], p++, at) :
		    put_other(b->job, &c->line[i], at);
	c->size = (size_t)(at - c->out);
	return p;
}

/* Points i to end - 1, each on a line of its own; no bytes of theirs are kept. */
static void write_points(struct block *b, size_t i, size_t end)
{
	const struct line line = { "", .kind = LINE_POINT, .newline = true };
	struct chunk *c = b->chunk;
	char *at = chunk_reserve(c, lines_room(&b->job->layout, end - i, 0));

	for (; i < end; i++)
		at = put_image(b, &line, i, at);
	c->size = (size_t)(at - c->out);
}

static void write_binary(struct block *b, const struct line *line, size_t p)
{
	const double nan = (double)NAN;
	double v[COORDINATES_MAX] = { nan, nan, nan, nan, nan, nan };

	if (line != NULL && line->kind != LINE_POINT) {
		if (line_is_bad(line) && !b->job->visible)
			binary_write(b->job, b->chunk, 0, v);
		return;
	}
	if (!is_wanted(b, p))
		return;
	for (int k = 0; k < b->job->layout.writes; k++)
		v[k] = b->chunk->image[k][p];
	binary_write(b->job, b->chunk, p, v);
}

/* Whether all images are finite, as they are written. The bits of a double without
 * its sign are those of a larger integer if it is larger, or nan: if they are above
 * those of most, the sum has the top bit set. */
static bool all_finite(const struct chunk *c, const struct layout *l, size_t n)
{
	const double most = l->out.format == FORMAT_F32 ? (double)FLT_MAX :
							  DBL_MAX;
	const uint64_t top = 1ull << 63;
	uint64_t limit, bits, any = 0;

	memcpy(&limit, &most, sizeof limit);
	for (int k = 0; k < l->writes; k++)
		for (size_t i = 0; i < n; i++) {
			memcpy(&bits, &c->image[k][i], sizeof bits);
			any |= (bits & ~top) + (top - 1 - limit);
		}
	return (any & top) == 0;
}

/* Marks the points without image; number is that of the first line. Returns
 * whether there is none. */
static bool mark(struct block *b, size_t n, size_t number)
{
	const struct layout *l = &b->job->layout;
	struct chunk *c = b->chunk;
	bool lines = !is_binary(l->in.format);
	size_t p = 0;

	if (all_finite(c, l, b->points))
		return true;
	for (size_t i = 0; i < n; i++)
		if (!lines || c->line[i].kind == LINE_POINT)
			binary_mark(b->job, c, p++, number + i);
	return false;
}

void block_write(const struct job *j, struct chunk *c, size_t n, size_t points,
    size_t number)
{
	bool lines = !is_binary(j->layout.in.format);
	struct block b; /* of which its texts would take long to be cleared */
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	size_t p = 0;

	b.job = j;
	b.chunk = c;
	b.points = points;
	b.texts.from = SIZE_MAX;
	bool finite = mark(&b, n, number);

	/* to JSON, nan goes as null */
	b.in_order = is_in_order(&j->layout) &&
	    (finite || j->layout.out.format != FORMAT_JSON);
	if (j->flags || j->visible)
		frustum_out_all(&j->frustum, in, b.outside, points);
	for (size_t i = 0; i < n; i += BATCH) {
		size_t end = n - i < BATCH ? n : i + BATCH;

		if (is_binary(j->layout.out.format))
			for (size_t k = i; k < end; k++) {
				const struct line *line = lines ? &c->line[k] :
								  NULL;

				write_binary(&b, line, p);
				p += !lines || line->kind == LINE_POINT;
			}
		else if (lines)
			p = write_lines(&b, i, end, p);
		else
			write_points(&b, i, end);
	}
}

void block_write_nan(const struct job *j, struct chunk *c)
{
	const struct line line = { "", .kind = LINE_LOST, .newline = true };
	struct block b = { .job = j, .chunk = c };

	if (j->take != NULL)
		return;
	if (is_binary(j->layout.out.format)) {
		write_binary(&b, &line, 0);
		return;
	}
	char *at = chunk_reserve(c, lines_room(&j->layout, 1, 0));

	c->size = (size_t)(put_other(j, &line, at) - c->out);
}
