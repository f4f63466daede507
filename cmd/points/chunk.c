#include "chunk.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "binary.h"
#include "../talk.h"

struct chunk *chunk_new(void)
{
	struct chunk *c = need(NULL, sizeof *c);

	memset(c, 0, sizeof *c);
	return c;
}

void chunk_free(struct chunk *c)
{
	free(c->out);
	free(c->complaints);
	free(c);
}

char *chunk_reserve(struct chunk *c, size_t more)
{
	if (c->size + more > c->room) {
		c->room = c->room / 2 * 3 + more;
		c->out = need(c->out, c->room);
	}
	return c->out + c->size;
}

void chunk_complain(struct chunk *c, size_t line, const char *reason)
{
	size_t n = c->n_complaints++;

	/* grown at powers of two */
	if ((n & (n - 1)) == 0)
		c->complaints = need(c->complaints,
		    (2 * n + 1) * sizeof *c->complaints);
	c->complaints[n].line = line;
	snprintf(c->complaints[n].reason, REASON_MAX, "%s", reason);
}

/* Reads up to a block of lines, their points into columns. A bad line ends
 * the chunk unless the job keeps going. Returns how many lines. */
static size_t read_lines(struct job *j, struct chunk *c, size_t *points)
{
	char reason[REASON_MAX];
	size_t n = 0;
	double v[4];

	for (*points = 0; n < POINTS_BLOCK && c->text < c->end; c->lines++) {
		const char *newline = memchr(c->text, '\n',
		    (size_t)(c->end - c->text));
		struct line *r = &c->records[n];
		struct span line = { c->text,
			newline != NULL ? newline : c->end };

		line_read(&j->layout, line, c->end, &c->header, r, v, reason);
		r->newline = newline != NULL;
		c->text = newline != NULL ? newline + 1 : c->end;
		if (r->kind == LINE_BAD) {
			chunk_complain(c, c->lines, reason);
			if (!j->keep_going) {
				c->text = c->end;
				break;
			}
		}
		if (r->kind == LINE_POINT) {
			for (int i = 0; i < j->layout.reads; i++)
				c->in[i][*points] = v[i];
			++*points;
		}
		n++;
	}
	return n;
}

/* Exactly, for any precision; single's numbers are floats. */
static void cast_rays(const struct job *j, struct chunk *c, size_t n)
{
	bool single = j->accuracy.precision == PRECISION_SINGLE;

	for (size_t i = 0; i < n; i++) {
		double at[2] = { c->in[0][i], c->in[1][i] }, ray[2][3];

		c->single[i] = single;
		ray_exact(&j->ray, at, ray[0], ray[1]);
		for (int k = 0; k < 6; k++) {
			double v = ray[k / 3][k % 3];

			c->image[k][i] = single ? (double)(float)v : v;
		}
	}
}

static void carry(const struct job *j, struct chunk *c, size_t n)
{
	const double *const in[4] = { c->in[0], c->in[1], c->in[2], c->in[3] };
	double *const out[4] = { c->image[0], c->image[1], c->image[2],
		c->image[3] };

	if (j->rays)
		cast_rays(j, c, n);
	else
		points_carry(&j->transform, &j->accuracy, in, out, c->single,
		    n);
}

enum { WORD_MAX = 48 };

/* "in", or the planes that the point is outside of, and "ill". */
static const char *flag_word(unsigned out, bool ill, char word[WORD_MAX])
{
	static const char *const names[] = { "left", "right", "bottom", "top",
		"near", "far", "behind", "nan" };
	char *at = word;

	for (int k = 0; k < 8; k++)
		if (out >> k & 1)
			at += sprintf(at, at > word ? "+%s" : "%s", names[k]);
	if (out == 0)
		at = stpcpy(at, "in");
	if (ill)
		stpcpy(at, "+ill");
	return word;
}

/* The word after point p, or NULL; *hidden where it is not to be printed. */
static const char *judge(const struct job *j, const struct chunk *c, size_t p,
    char word[WORD_MAX], bool *hidden)
{
	double in[4];

	*hidden = false;
	if (!j->flags && !j->visible)
		return NULL;
	for (int i = 0; i < 4; i++)
		in[i] = c->in[i][p];
	unsigned out = frustum_out(&j->frustum, in);

	*hidden = j->visible && out != 0;
	return j->flags ?
	    flag_word(out, out < OUT_BEHIND && point_is_ill(&j->transform, in),
		word) :
	    NULL;
}

/* Whether it was complained of; lines are asked for in order. */
static bool was_refused(struct chunk *c, size_t line)
{
	while (c->told < c->n_complaints && c->complaints[c->told].line < line)
		c->told++;
	return c->told < c->n_complaints && c->complaints[c->told].line == line;
}

/* What has no image is nan throughout, also where it is infinite, if only as
 * the float that it is written as. */
void chunk_mark(const struct job *j, struct chunk *c, size_t p, size_t line)
{
	bool nan = false, narrow = j->layout.out == FORMAT_F32;

	for (int k = 0; k < j->layout.writes; k++) {
		double v = c->image[k][p];

		if (!isfinite(v) || (narrow && !isfinite((float)v))) {
			c->image[k][p] = (double)NAN;
			nan = true;
		}
	}
	if (nan && !was_refused(c, line) && c->imageless++ == 0)
		c->first_imageless = line;
}

/* Point p, which stood in r. */
static void write_point(const struct job *j, struct chunk *c, struct line *r,
    size_t p, size_t line)
{
	double v[COORDINATES_MAX];
	char word[WORD_MAX];
	bool hidden;
	const char *flags = judge(j, c, p, word, &hidden);

	chunk_mark(j, c, p, line);
	for (int k = 0; k < j->layout.writes; k++)
		v[k] = c->image[k][p];
	if (hidden)
		return;
	if (is_binary(j->layout.out)) {
		binary_write(j, c, p, v);
		return;
	}
	char *at = chunk_reserve(c, line_room(&j->layout, r));

	r->single = c->single[p];
	c->size += (size_t)(line_write(&j->layout, r, v, flags, at) - at);
}

/* A line that is no point: a comment, or a bad one as a row of nan. */
static void write_other(const struct job *j, struct chunk *c,
    const struct line *r)
{
	const double nan = (double)NAN;
	const double v[COORDINATES_MAX] = { nan, nan, nan, nan, nan, nan };
	bool bad = r->kind == LINE_BAD;

	if (j->take != NULL || (bad && j->visible))
		return;
	if (is_binary(j->layout.out)) {
		if (bad)
			binary_write(j, c, 0, v);
		return;
	}
	char *at = chunk_reserve(c, line_room(&j->layout, r));

	c->size += (size_t)(line_write(&j->layout, r, v,
				bad && j->flags ? "nan" : NULL, at) -
	    at);
}

/* The source ends within a binary point. */
static void cut_short(const struct job *j, struct chunk *c)
{
	struct line r = { .kind = LINE_BAD, .newline = true };
	char reason[REASON_MAX];

	snprintf(reason, sizeof reason,
	    "ends within a point; a point is %zu "
	    "bytes",
	    point_size(&j->layout, j->layout.in));
	chunk_complain(c, c->lines, reason);
	r.line.s = r.line.end = c->text = c->end;
	if (j->keep_going)
		write_other(j, c, &r);
}

void chunk_do(struct job *j, struct chunk *c)
{
	struct line binary = { .kind = LINE_POINT, .newline = true };
	size_t size = point_size(&j->layout, j->layout.in);
	bool lines = !is_binary(j->layout.in);
	bool blocks = !lines && j->layout.out == FORMAT_F64 &&
	    j->take == NULL && !j->visible;

	c->size = c->n_complaints = c->told = c->imageless = c->lines = 0;
	while (c->text < c->end) {
		size_t points, p = 0, first = c->lines;
		const char *text = c->text;

		if (!lines && (size_t)(c->end - text) < size) {
			cut_short(j, c);
			break;
		}
		size_t n = lines ? read_lines(j, c, &points) :
				   binary_read(j, c, &points);

		carry(j, c, points);
		if (blocks) {
			binary_write_block(j, c, n, first);
			continue;
		}
		for (size_t i = 0; i < n; i++) {
			struct line *r = lines ? &c->records[i] : &binary;

			binary.line.s = text + i * size;
			binary.line.end = binary.line.s + size;
			if (r->kind != LINE_POINT)
				write_other(j, c, r);
			else if (j->take != NULL)
				j->take(j, c, r, p++, first + i);
			else
				write_point(j, c, r, p++, first + i);
		}
	}
}
