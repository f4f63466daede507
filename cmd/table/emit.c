/* SPDX-License-Identifier: MIT */
#include "emit.h"

#include <math.h>

#include "../../core/derive/frustum.h"

const struct flags *flags_word(struct flag_words *words, unsigned outside)
{
	static const char *const names[] = { "left", "right", "bottom", "top", "near",
		"far", "behind", "nan" };
	struct flags *w = &words->word[outside];
	char *at = w->s;

	if (w->size > 0)
		return w;
	for (int k = 0; k < 8; k++)
		if (outside >> k & 1) {
			if (at > w->s)
				*at++ = '+';
			at = stpcpy(at, names[k]);
		}
	if (at == w->s)
		at = stpcpy(at, "in");
	w->size = (size_t)(at - w->s);
	return w;
}

/* How the lines of a layout are written. */
struct emit {
	const struct layout *l;
	bool same;     /* the output has the format of the input */
	bool in_place; /* most lines can be written in place */
	bool adds;     /* values are added to those that were read */
	bool three;    /* three numbers are read, and replaced in place */
};

static struct emit emit_of(const struct layout *l)
{
	const struct output *o = &l->output;
	const bool same = same_dialect(l->in, l->out);
	const bool adds = o->append || o->flags || l->reads < l->writes;
	const bool in_place = same && (o->append || l->reads <= l->writes) &&
	    !(l->plan.in_space != 0 && l->in.format == FORMAT_JSON);

	return (struct emit){ .l = l,
		.same = same,
		.in_place = in_place,
		.adds = adds,
		.three = in_place && !adds && l->reads == 3 };
}

size_t emit_room(const struct layout *l, size_t lines, size_t bytes)
{
	/* beside a number its separator and name; beside the word of --flags its name,
	 * brackets and newline */
	const size_t name = 2 * NAME_ROOM + 8;

	return bytes +
	    lines *
	    ((size_t)l->writes * (NUMBER_MAX + name) + FLAG_MAX + name + LINE_MARGIN);
}

static inline char *put_flags_word(const struct layout *l, const struct flags *w,
    char *out)
{
	bool quoted = l->out.format == FORMAT_JSON;

	*out = '"';
	memcpy(out + quoted, w->s, sizeof w->s);
	out += quoted + w->size;
	*out = '"';
	return out + quoted;
}

static inline char *put_coordinate(const struct layout *l, struct image_numbers n,
    int k, char *out)
{
	const struct number_text *text = &n.text[(size_t)k * n.text_stride];
	double v = n.v[(size_t)k * n.stride];

	if (__builtin_expect(text->layout == 0, 0) && isnan(v))
		return stpcpy(out, format_of(l->out)->nan_text);
	return number_text_put(out, text, v, l->output.single, l->output.style[k]);
}

/* Writes the numbers from k on and the word unless it is NULL, after separators. */
static inline char *put_added(const struct layout *l, struct image_numbers n, int k,
    char separator, const struct flags *flags, char *out)
{
	for (; k < l->writes; k++) {
		*out++ = separator;
		out = put_coordinate(l, n, k, out);
	}
	if (flags != NULL) {
		*out++ = separator;
		out = put_flags_word(l, flags, out);
	}
	return out;
}

/* Copies the n bytes at s, which precede a coordinate or end the line. Copies the first
 * bytes without a branch, as n varies where columns are aligned by blanks. */
static inline char *put_gap(const char *s, size_t n, char *out)
{
	memcpy(out, s, LINE_MARGIN);
	if (n > LINE_MARGIN)
		memcpy(out, s, n);
	return out + n;
}

/* Returns the separator before added values: of text a blank as before the last
 * coordinate, or a space if none is there. */
static inline char added_separator(const struct layout *l, const struct line *line)
{
	const uint32_t from = line->at[l->reads - 1].from;

	return !format_of(l->out)->blanks ? l->out.separator :
	    from > 0                      ? line->s[from - 1] :
					    ' ';
}

/* The general way. */

struct splice {
	const struct layout *l;
	const struct line *line;
	struct image_numbers n; /* n.v is NULL in a header: names are written */
	const struct flags *flags;
	char separator;   /* before each value that is added */
	bool members;     /* values have names */
	const char *done; /* bytes before it are copied or left out */
	char *out;        /* the end of the output */
	int fields;       /* written so far */
};

static void copy_to(struct splice *w, const char *s)
{
	if (s > w->done) {
		memcpy(w->out, w->done, (size_t)(s - w->done));
		w->out += s - w->done;
		w->done = s;
	}
}

static void put_output_name(struct splice *w, int k)
{
	char name[2 * NAME_ROOM];

	plan_name(w->l, k, name);
	if (w->members)
		*w->out++ = '"';
	w->out = stpcpy(w->out, name);
	if (w->members)
		w->out = stpcpy(w->out, "\"");
}

/* Writes value k: a number or, at COORDINATES_MAX, the word; of a header its name. */
static void put_value(struct splice *w, int k)
{
	if (w->n.v == NULL)
		put_output_name(w, k);
	else if (k < COORDINATES_MAX)
		w->out = put_coordinate(w->l, w->n, k, w->out);
	else
		w->out = put_flags_word(w->l, w->flags, w->out);
}

/* Writes the values from k on, with the names that members have. */
static void put_values(struct splice *w, int k)
{
	for (; k <= COORDINATES_MAX; k++) {
		if (k == COORDINATES_MAX ? !w->l->output.flags : k >= w->l->writes)
			continue;
		if (w->fields++ > 0)
			*w->out++ = w->separator;
		if (w->members) {
			put_output_name(w, k);
			*w->out++ = ':';
		}
		put_value(w, k);
	}
}

/* Returns the coordinate that is the field, or -1. */
static int coordinate_of(const struct splice *w, const struct field *f)
{
	for (int i = 0; i < w->l->reads; i++)
		if (line_field(w->line, i).s == f->value.s)
			return i;
	return -1;
}

/* Writes value k in the place of the field f. In a header f, which is a name, stays
 * unless it is one of the space that is read. */
static void replace_field(struct splice *w, const struct field *f, int k)
{
	const bool in_space = w->l->plan.in_space >> k & 1;

	if (w->members && in_space) {
		copy_to(w, f->name.s);
		put_output_name(w, k);
		w->done = f->name.end;
	}
	if (w->n.v == NULL && !in_space)
		return;
	copy_to(w, f->value.s);
	put_value(w, k);
	w->done = f->value.end;
}

/* Leaves out the field f and the separator before it, or after it if it is the
 * first. */
static void skip_field(struct splice *w, const struct field *f)
{
	const bool first = w->fields == 0;

	copy_to(w, first ? f->whole.s : f->previous_end);
	w->done = first && f->next != NULL ? f->next : f->whole.end;
}

/* Replaces the coordinates; added values follow the last of them. */
static void replace_values(struct splice *w, struct cursor c)
{
	const struct layout *l = w->l;
	const int last = (l->reads < l->writes ? l->reads : l->writes) - 1;
	struct field f;

	while (cursor_next(&c, &f)) {
		const int i = coordinate_of(w, &f);

		if (i >= l->writes) {
			skip_field(w, &f);
			continue;
		}
		w->fields++;
		if (i >= 0)
			replace_field(w, &f, i);
		if (i >= 0 && i == last) {
			copy_to(w, trimmed(c.in, f.whole).end);
			put_values(w, l->reads);
		}
	}
}

/* Adds all values at the end of the line, before ] or } and a carriage return. Blanks
 * at its end are part of a field of csv. */
static void append_values(struct splice *w, struct cursor c)
{
	const struct span text = trimmed(w->l->in, line_text(w->line));
	struct field f;

	w->fields = w->l->in.format != FORMAT_JSON || c.s != NULL;
	while (c.bracket != NULL && cursor_next(&c, &f))
		continue;
	if (c.bracket != NULL)
		copy_to(w, c.previous_end != NULL ? c.previous_end : c.bracket);
	else if (format_of(w->l->in)->blanks)
		copy_to(w, text.end);
	else
		copy_to(w, c.end - (c.end > w->line->s && c.end[-1] == '\r'));
	put_values(w, 0);
}

/* Writes the numbers alone. */
static char *put_point(const struct layout *l, struct image_numbers n,
    const struct flags *flags, char *out)
{
	const struct format_row *to = format_of(l->out);

	for (const char *s = to->open; *s != '\0'; s++)
		*out++ = *s;
	out = put_coordinate(l, n, 0, out);
	out = put_added(l, n, 1, l->out.separator, flags, out);
	*out = *to->close;
	return out + (*to->close != '\0');
}

/* Writes any line: a point; a bad line, with numbers that are nan; a header, if n.v is
 * NULL; a comment. */
static char *emit_line(const struct emit *e, const struct line *line,
    struct image_numbers n, const struct flags *flags, char *out)
{
	const struct layout *l = e->l;
	const bool header = line->kind == LINE_HEADER, copy = line->kind == LINE_COPY;
	struct span text = line_text(line);
	struct splice w = { .l = l,
		.line = line,
		.n = n,
		.flags = flags,
		.separator = l->out.separator,
		.members = line->object && e->same,
		.done = text.s,
		.out = out };

	if (line->kind == LINE_SILENT || (header && !e->same) ||
	    (copy && (!e->same || l->in.format == FORMAT_JSON)))
		return out;
	text.s += line->has_bom ? 3 : 0;
	if (copy) {
		copy_to(&w, text.end);
	} else if (line->kind == LINE_LOST && w.members) {
		*w.out++ = '{';
		put_values(&w, 0);
		*w.out++ = '}';
	} else if (!e->same || line->kind == LINE_LOST) {
		w.out = put_point(l, n, l->output.flags ? flags : NULL, w.out);
	} else {
		if (format_of(l->out)->blanks)
			w.separator = added_separator(l, line);
		if (l->output.append)
			append_values(&w, line_cursor(l->in, text));
		else
			replace_values(&w, line_cursor(l->in, text));
		copy_to(&w, text.end);
	}
	*w.out = '\n';
	return w.out + line->newline;
}

char *emit_names(const struct layout *l, char *out)
{
	struct splice w = { .l = l, .separator = l->out.separator, .out = out };

	put_values(&w, 0);
	*w.out = '\n';
	return w.out + 1;
}

/* The special ways for points, which most lines are. cmd/test/emit_test.c compares
 * their bytes with those of the general way, and `emit_test gain` prints how many times
 * as long the general way takes. */

/* Returns whether the n coordinates are on the line in the order x, y, z, w. */
static inline bool is_in_order(const struct line *line, int n)
{
	for (int k = 1; k < n; k++)
		if (line->at[k].from < line->at[k - 1].from)
			return false;
	return true;
}

/* Returns whether values can follow the last coordinate: without names and a quote
 * there, and by --append with no blanks at the end. */
static bool can_add_in_place(const struct layout *l, const struct line *line)
{
	const struct part *last = &line->at[l->reads - 1];
	const char *end = line->s + line->size;

	if (line->object)
		return false;
	if (l->output.append)
		return !is_blank(end[-1]) &&
		    !is_blank(end[-1 - (l->out.format == FORMAT_JSON)]);
	const char next = last->to < line->size ? line->s[last->to] : '\r';

	/* blanks may stand before a quote */
	return l->out.format != FORMAT_CSV || next == l->out.separator || next == '\r';
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
		done = line->size - (l->out.format == FORMAT_JSON);
		out = put_gap(line->s, done, out);
	}
	if (written < l->writes || flags != NULL)
		out = put_added(l, n, written, added_separator(l, line), flags, out);
	out = put_gap(line->s + done, line->size - done, out);
	*out = '\n';
	return out + line->newline;
}

/* Writes a line that is three numbers with a byte between them, and no more than a byte
 * at each end, as most are, in less time than write_in_place. Returns the end of the
 * line, or NULL if it is another. */
static inline char *put_three(const struct line *line, const struct image_numbers n,
    char *out)
{
	const struct number_text *t = n.text, *u = t + n.text_stride,
				 *v = u + n.text_stride;
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

static inline char *emit_point(const struct emit *e, const struct line *line,
    struct image_numbers n, const struct flags *flags, char *out)
{
	const struct layout *l = e->l;
	int order[4];

	if (e->three) {
		char *end = put_three(line, n, out);

		if (end != NULL)
			return end;
	}
	if (!e->same) {
		out = put_point(l, n, flags, out);
		*out = '\n';
		return out + line->newline;
	}
	const bool in_order = is_in_order(line, l->reads);

	if (!e->in_place ||
	    (e->adds && !((in_order || l->output.append) && can_add_in_place(l, line))))
		return emit_line(e, line, n, flags, out);
	if (l->output.append)
		return write_in_place(l, line, true, NULL, n, flags, out);
	if (in_order)
		return write_in_place(l, line, false, NULL, n, flags, out);
	line_order(line, l->reads, order);
	return write_in_place(l, line, false, order, n, flags, out);
}

/* The texts of a batch of images. */
struct batch {
	/* enough images for vector loops, few enough for the first-level cache */
	size_t first;
	struct number_text text[COORDINATES_MAX][NUMBER_BATCH];
};

/* Makes the texts of the batch of images that includes image p, unless they are
 * made. */
static inline void make_texts(struct batch *batch, const struct layout *l,
    const struct emit_block *b, size_t p)
{
	const size_t from = p - p % NUMBER_BATCH, rest = b->points - from;

	if (batch->first == from)
		return;
	for (int k = 0; k < l->writes; k++)
		number_texts(&b->image[k][from],
		    rest < NUMBER_BATCH ? rest : NUMBER_BATCH, l->output.single,
		    l->output.style[k], batch->text[k]);
	batch->first = from;
}

char *emit_lines(const struct layout *l, const struct emit_block *b, char *out)
{
	static const double nan = (double)NAN;
	static const struct number_text none = { .layout = 0 };
	const struct image_numbers bad = { &nan, &none, 0, 0 }, names = { 0 };
	const struct emit e = emit_of(l);
	const struct flags *flags = NULL;
	struct batch batch; /* no initializer, as to clear the texts takes time */

	batch.first = SIZE_MAX;
	for (size_t i = 0, p = 0; i < b->lines; i++) {
		const struct line *line = &b->line[i];

		if (line->kind != LINE_POINT) {
			if (!b->visible || !line_is_bad(line))
				out = emit_line(&e, line,
				    line_is_bad(line) ? bad : names,
				    flags_word(b->words, OUT_NAN), out);
			continue;
		}
		if (!b->visible || b->outside[p] == 0) {
			make_texts(&batch, l, b, p);
			if (l->output.flags)
				flags = flags_word(b->words, b->outside[p]);
			const struct image_numbers n = { &b->image[0][p],
				&batch.text[0][p % NUMBER_BATCH], POINTS_BLOCK,
				NUMBER_BATCH };

			out = b->general ? emit_line(&e, line, n, flags, out) :
					   emit_point(&e, line, n, flags, out);
		}
		p++;
	}
	return out;
}
