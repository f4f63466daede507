#include "job.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "binary.h"
#include "block_read.h"

/* Rays are computed exactly, whatever the precision; for single they are
 * rounded to floats. */
static void cast_rays(const struct job *j, struct chunk *c, size_t n)
{
	bool single = j->accuracy.precision == PRECISION_SINGLE ||
	    j->layout.out == FORMAT_F32;

	for (size_t i = 0; i < n; i++) {
		double at[2] = { c->in[0][i], c->in[1][i] }, ray[2][3];

		c->single[i] = single;
		ray_exact(&j->ray, at, single, ray[0], ray[1]);
		for (int k = 0; k < 6; k++)
			c->image[k][i] = ray[k / 3][k % 3];
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

/* "in", or the planes that the point is outside of, as left+near. */
static const char *flag_word(unsigned out, char word[WORD_MAX])
{
	static const char *const names[] = { "left", "right", "bottom", "top",
		"near", "far", "behind", "nan" };
	char *at = word;

	for (int k = 0; k < 8; k++)
		if (out >> k & 1)
			at += sprintf(at, at > word ? "+%s" : "%s", names[k]);
	if (out == 0)
		strcpy(at, "in");
	return word;
}

/* Whether point p is to be written; in *flags the word after it, or NULL. */
static bool judge(const struct job *j, const struct chunk *c, size_t p,
    char word[WORD_MAX], const char **flags)
{
	double in[4];

	*flags = NULL;
	if (!j->flags && !j->visible)
		return true;
	for (int i = 0; i < 4; i++)
		in[i] = c->in[i][p];
	unsigned out = frustum_out(&j->frustum, in);

	if (j->flags)
		*flags = flag_word(out, word);
	return !j->visible || out == 0;
}

static void put_line(const struct job *j, struct chunk *c,
    const struct line *line, const double *v, const char *flags)
{
	char *at = chunk_reserve(c, line_room(&j->layout, line));

	c->size += (size_t)(line_write(&j->layout, line, v, flags, at) - at);
}

static void write_point(const struct job *j, struct chunk *c, struct line *line,
    size_t p)
{
	double v[COORDINATES_MAX];
	char word[WORD_MAX];
	const char *flags;

	if (!judge(j, c, p, word, &flags))
		return;
	for (int k = 0; k < j->layout.writes; k++)
		v[k] = c->image[k][p];
	if (is_binary(j->layout.out)) {
		binary_write(j, c, p, v);
		return;
	}
	line->single = c->single[p];
	put_line(j, c, line, v, flags);
}

/* Writes a line that is no point: a comment or a header as it is, a bad line as
 * nan in each coordinate. */
static void write_other(const struct job *j, struct chunk *c,
    const struct line *line)
{
	const double nan = (double)NAN;
	const double v[COORDINATES_MAX] = { nan, nan, nan, nan, nan, nan };
	bool bad = line->kind == LINE_BAD;

	if (j->take != NULL || (bad && j->visible))
		return;
	if (!is_binary(j->layout.out))
		put_line(j, c, line, v, bad && j->flags ? "nan" : NULL);
	else if (bad)
		binary_write(j, c, 0, v);
}

/* The source ends within a binary point: that counts as a bad line. */
static void cut_short(const struct job *j, struct chunk *c, size_t size)
{
	struct line line = { .kind = LINE_BAD, .s = c->end, .newline = true };
	char reason[REASON_MAX];

	snprintf(reason, sizeof reason,
	    "ends within a point; a point is %zu bytes", size);
	chunk_complain(c, c->n_lines, reason);
	c->text = c->end;
	if (j->keep_going)
		write_other(j, c, &line);
}

/* Does the rest of the job line by line on a block of n, whose images have been
 * computed. number is that of the first line; where points are binary, the
 * first begins at text. */
static void do_lines(const struct job *j, struct chunk *c, size_t n,
    size_t number, const char *text)
{
	bool binary = is_binary(j->layout.in);
	size_t size = point_size(j->layout.in, j->layout.reads), p = 0;
	struct line point = { .kind = LINE_POINT,
		.size = (uint32_t)size,
		.newline = true };

	for (size_t i = 0; i < n; i++) {
		struct line *line = binary ? &point : &c->line[i];

		if (binary)
			point.s = text + i * size;
		if (line->kind != LINE_POINT) {
			write_other(j, c, line);
		} else if (j->take != NULL) {
			j->take(j, c, line, p++, number + i);
		} else {
			chunk_mark(c, &j->layout, p, number + i);
			write_point(j, c, line, p++);
		}
	}
}

void job_do(struct job *j, struct chunk *c)
{
	bool binary = is_binary(j->layout.in);
	size_t size = point_size(j->layout.in, j->layout.reads);
	/* a block of images goes out as it is: every point becomes as many
	 * bytes, and no command wants to see it */
	bool whole = binary && j->layout.out == FORMAT_F64 && j->take == NULL &&
	    !j->visible;

	chunk_clear(c);
	while (c->text < c->end) {
		size_t n, points, number = c->n_lines;
		const char *text = c->text;

		if (binary && (size_t)(c->end - text) < size) {
			cut_short(j, c, size);
			break;
		}
		if (binary)
			n = points = binary_read(j, c);
		else
			n = block_read(j, c, &points);
		carry(j, c, points);
		if (whole)
			binary_write_block(j, c, n, number);
		else
			do_lines(j, c, n, number, text);
	}
}
