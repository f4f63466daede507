/* SPDX-License-Identifier: MIT */
#include "writer.h"

#include <math.h>

#include "../lines/splice.h"
#include "binary.h"

struct writer {
	struct chunk *chunk;
	const struct layout *layout;
	const unsigned char *outside;
	bool in_place;    /* write_in_place may write the images */
	bool adds_values; /* values are added after those that were read */
	bool three;       /* three numbers are read, and replaced in place */
	int order[4];     /* of the coordinates on the previous line */

	/* enough images for vector loops, few enough for the first-level cache */
	size_t first_of_batch;
	struct number_text text[COORDINATES_MAX][NUMBER_BATCH];
};

/* Returns whether the n coordinates are on the line in the order x, y, z, w. */
static inline bool is_in_order(const struct line *line, int n)
{
	for (int k = 1; k < n; k++)
		if (line->at[k].from < line->at[k - 1].from)
			return false;
	return true;
}

/* Sorts order[], a list of the coordinates 0 to n - 1, by their places on the line. */
static void find_order(const struct line *line, int n, int order[4])
{
	for (int i = 1; i < n; i++)
		for (int k = i;
		     k > 0 && line->at[order[k - 1]].from > line->at[order[k]].from;
		     k--) {
			int after = order[k];

			order[k] = order[k - 1];
			order[k - 1] = after;
		}
}

/* Returns whether values can follow the last coordinate: without names and a quote
 * there, in text with one byte between, and by --append with no blanks at the end. */
static bool can_add_in_place(const struct layout *l, const struct line *line)
{
	const struct part *last = &line->at[l->reads - 1];
	const char *end = line->s + line->size;

	if (l->output.append &&
	    (is_blank(end[-1]) ||
		is_blank(end[-1 - (*format_of(l->out)->close != '\0')])))
		return false;
	if (format_of(l->out)->blanks)
		return last->from - line->at[l->reads - 2].to == 1;
	return !line->object &&
	    (!format_of(l->out)->header || last->to == line->size ||
		line->s[last->to] != '"');
}

/* Adds all values at the line's end (append), or replaces the coordinates, in the order
 * order[] (NULL: x, y, z, w), and adds the others. Returns the end. */
static inline __attribute__((always_inline)) char *
write_in_place(const struct layout *l, const struct line *line, bool append,
    const int *order, const struct image_numbers n, const struct flags *flags,
    char *out)
{
	uint32_t done = 0;
	int written = append ? 0 : l->reads;

	for (int i = 0; i < written; i++) {
		int k = order != NULL ? order[i] : i;

		out = put_gap(line->s + done, line->at[k].from - done, out);
		out = put_coordinate(l, n, k, out);
		done = line->at[k].to;
	}
	if (append) {
		done = line->size - (*format_of(l->out)->close != '\0');
		out = put_gap(line->s, done, out);
	}
	if (written < l->writes || flags != NULL) {
		bool blanks = format_of(l->out)->blanks;
		char c = blanks ? line->s[line->at[l->reads - 2].to] : l->out.separator;

		out = put_added(l, n, written, c, flags, out);
	}
	out = put_gap(line->s + done, line->size - done, out);
	*out = '\n';
	return out + line->newline;
}

/* Makes the texts of the batch of images that includes image p, unless w has them. */
static void writer_make_texts(struct writer *w, size_t p)
{
	const struct output *o = &w->layout->output;
	size_t from = p - p % NUMBER_BATCH, rest = w->chunk->block_points - from;

	if (w->first_of_batch == from)
		return;
	for (int k = 0; k < w->layout->writes; k++)
		number_texts(&w->chunk->image[k][from],
		    rest < NUMBER_BATCH ? rest : NUMBER_BATCH, o->single, o->style[k],
		    w->text[k]);
	w->first_of_batch = from;
}

static inline struct image_numbers image_of(const struct writer *w, size_t p)
{
	return (struct image_numbers){ &w->chunk->image[0][p],
		&w->text[0][p % NUMBER_BATCH], POINTS_BLOCK, NUMBER_BATCH };
}

/* Writes a line that is three numbers with a byte between them, and no more than a byte
 * at each end, as most are. Returns the end of the line, or NULL if it is another. */
static inline char *put_three(const struct writer *w, const struct line *line, size_t p,
    char *out)
{
	const struct number_text *t = &w->text[0][p % NUMBER_BATCH];
	const struct number_text *u = t + NUMBER_BATCH, *v = u + NUMBER_BATCH;
	const struct part *at = line->at;

	if ((t->layout == 0) | (u->layout == 0) | (v->layout == 0) | (at[0].from > 1) |
	    (at[1].from != at[0].to + 1) | (at[2].from != at[1].to + 1) |
	    (line->size > at[2].to + 1))
		return NULL;
	*out = *line->s;
	out = number_text_copy(out + at[0].from, t);
	*out++ = line->s[at[0].to];
	out = number_text_copy(out, u);
	*out++ = line->s[at[1].to];
	out = number_text_copy(out, v);
	*out = line->s[at[2].to];
	out += line->size - at[2].to;
	*out = '\n';
	return out + line->newline;
}

/* Writes the line of point p with the point's image. Returns the end of the line. Each
 * branch calls image_of, as a single call takes 3 % more time in the format text. */
static char *put_image(struct writer *w, const struct line *line, size_t p, char *at)
{
	const struct layout *l = w->layout;
	const struct flags *flags = l->output.flags ?
	    flags_word(&w->chunk->words, w->outside[p]) :
	    NULL;

	writer_make_texts(w, p);
	if (w->three) {
		char *end = put_three(w, line, p, at);

		if (end != NULL)
			return end;
	}
	if (w->in_place && is_in_order(line, l->reads) &&
	    (!w->adds_values || can_add_in_place(l, line)))
		return l->output.append ?
		    write_in_place(l, line, true, NULL, image_of(w, p), flags, at) :
		    write_in_place(l, line, false, NULL, image_of(w, p), flags, at);
	if (!w->in_place || w->adds_values) {
		const struct image_numbers n = image_of(w, p);

		return splice_line(l, line, &n, flags, at);
	}
	find_order(line, l->reads, w->order);
	return write_in_place(l, line, false, w->order, image_of(w, p), flags, at);
}

void writer_put_block(const struct job *j, struct chunk *c,
    const unsigned char *outside)
{
	static const double nan = (double)NAN;
	static const struct number_text none = { .layout = 0 };
	const struct image_numbers bad = { &nan, &none, 0, 0 };
	const struct layout *l = &j->layout;
	const bool binary = format_is_binary(l->out.format);
	const size_t n = c->block_lines;
	const char *end = c->line[n - 1].s + c->line[n - 1].size;
	char *at = chunk_reserve(c, splice_room(l, n, (size_t)(end - c->line[0].s)));
	struct writer w; /* no initializer, as to clear the texts takes time */

	w.chunk = c;
	w.layout = l;
	w.outside = outside;
	w.first_of_batch = SIZE_MAX;
	for (int k = 0; k < 4; k++)
		w.order[k] = k;
	w.adds_values = l->output.append || l->output.flags || l->reads < l->writes;
	w.in_place = same_dialect(l->in, l->out) &&
	    (l->output.append || l->reads <= l->writes);
	w.three = w.in_place && !w.adds_values && l->reads == 3;
	for (size_t i = 0, p = 0; i < n; i++) {
		const struct line *line = &c->line[i];
		const bool point = line->kind == LINE_POINT;

		if (point                 ? !j->visible || outside[p] == 0 :
			line_is_bad(line) ? !j->visible :
					    !binary)
			at = binary ? binary_put_record(l, c, line, p, at) :
			    point   ? put_image(&w, line, p, at) :
				      splice_line(l, line, &bad,
					  flags_word(&c->words, OUT_NAN), at);
		p += point;
	}
	c->size = (size_t)(at - c->out);
}
