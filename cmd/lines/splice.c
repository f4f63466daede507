/* SPDX-License-Identifier: MIT */
/* A line on its way out: numbers take the place of others, or stand behind them. */
#include <math.h>
#include <string.h>

#include "../../core/points/kernel/little.h"
#include "../json/text.h"
#include "choose.h"
#include "header.h"

/* The number of the word in the order of what is written. */
enum { FLAGS = COORDINATES_MAX };

struct splice {
	const struct layout *l;
	const struct line *line;
	struct span at[4];             /* the coordinates; s is NULL: missing */
	const struct numbers *numbers; /* NULL: the line is a header */
	const struct word *flags;      /* NULL: none is written */
	struct span separator;         /* before what is added */
	const char *done;              /* the line up to here is dealt with */
	char *out;
	unsigned put;  /* the values that were written, as bits */
	size_t fields; /* how many fields are in out */
};

size_t lines_room(const struct layout *l, size_t lines, size_t bytes)
{
	/* In another format a byte of a field may become six, as \u0001 in
	 * JSON. Six for the separator after it are enough for a comma and two
	 * quotes. Then for each value a separator, and a name in an object. */
	return (same_dialect(l->in, l->out) ? bytes : 6 * bytes) +
	    lines *
	    ((size_t)l->writes * (NUMBER_MAX + ADDED_ROOM) + ADDED_ROOM + 2 +
		WORD_MAX + 2 + 1);
}

char *line_put_rare(const struct layout *l, int k, double v, char *out)
{
	const char *unknown = format_of(l->out)->unknown;

	if (isnan(v))
		return stpcpy(out, unknown);
	return l->single ? number_write_float(out, (float)v, l->style[k]) :
			   number_write(out, v, l->style[k]);
}

static char *splice_text(char *out, const char *s, const char *end)
{
	memcpy(out, s, (size_t)(end - s));
	return out + (end - s);
}

/* Copies the line up to s. */
static void splice_to(struct splice *w, const char *s)
{
	if (s > w->done) {
		w->out = splice_text(w->out, w->done, s);
		w->done = s;
	}
}

/* Returns what value k is called: a coordinate that is read, one that is added, or
 * the word. */
static const char *value_name(const struct splice *w, int k)
{
	if (w->l->append)
		return w->l->added[k];
	if (k < w->l->reads && w->line->object && w->line->kind == LINE_BAD)
		return layout_path(w->l, k);
	return layout_added_name(w->l, k);
}

static bool is_written(const struct splice *w, int k)
{
	return k == FLAGS ? w->flags != NULL : k < w->l->writes;
}

static char *put_word(const struct layout *l, const struct word *w, char *out)
{
	bool quoted = *format_of(l->out)->open != '\0';

	*out = '"';
	out = splice_text(out + quoted, w->s, w->s + w->size);
	*out = '"';
	return out + quoted;
}

static char *put_value(const struct splice *w, int k, char *out)
{
	const struct layout *l = w->l;

	if (w->numbers == NULL)
		return k < l->reads && w->at[k].s < w->at[k].end ?
		    format_convert(l->in, l->out, w->at[k], out) :
		    stpcpy(out, value_name(w, k));
	if (k < FLAGS)
		return line_put(l, k,
		    &w->numbers->text[(size_t)k * w->numbers->text_step],
		    w->numbers->v[(size_t)k * w->numbers->step], out);
	return put_word(l, w->flags, out);
}

/* Writes every value from k on that was not written yet: behind a separator, but for
 * the first of the line, and in an object behind its name. */
static void put_others(struct splice *w, int k, bool members)
{
	size_t gap = (size_t)(w->separator.end - w->separator.s);
	char *out = w->out;

	for (; k <= FLAGS; k++) {
		if (!is_written(w, k) || (w->put >> k & 1) != 0)
			continue;
		if (w->fields++ > 0) {
			*out = *w->separator.s;
			if (gap > 1)
				memcpy(out, w->separator.s, gap);
			out += gap;
		}
		if (members) {
			*out++ = '"';
			out = stpcpy(out, value_name(w, k));
			*out++ = '"';
			*out++ = ':';
		}
		out = put_value(w, k, out);
		w->put |= 1u << k;
	}
	w->out = out;
}

/* Returns the coordinate that begins from s up to end, or -1. */
static int coordinate_in(const struct splice *w, const char *s, const char *end)
{
	for (int i = 0; i < w->l->reads; i++)
		if (w->at[i].s >= s && w->at[i].s <= end)
			return i;
	return -1;
}

/* Returns which value stands in the field, or -1: a coordinate, or in an object one
 * that is added and has its name. */
static int value_of(const struct splice *w, const struct field *f, bool outer)
{
	int i = coordinate_in(w, f->whole.s, f->value.s);

	if (f->name.s == NULL || !outer)
		return i;
	for (int k = w->l->reads; k <= FLAGS && i < 0; k++) {
		if (!is_written(w, k))
			continue;
		const char *name = value_name(w, k);
		struct span added = { name, name + strlen(name) };

		if (json_is_name(f->name, added, false))
			return k;
	}
	return i;
}

/* Returns the separator that is repeated behind the field f: in text the one before
 * it, or behind it if it is the first. */
static struct span separator_at(const struct layout *l, const struct field *f)
{
	struct span one = { &l->in.separator, &l->in.separator + 1 };
	struct span found = { f->from, f->value.s };

	if (!format_of(l->in)->blanks)
		return one;
	if (f->from == NULL)
		found = (struct span){ f->whole.end, f->next };
	return found.s < found.end && found.end - found.s <= ADDED_ROOM ?
	    found :
	    one;
}

/* Goes through the fields of a line, or of a value in it: writes each value in the
 * place of the one that was read, and leaves out coordinates that are not written,
 * and members that have the name of one that was added. */
static void splice_fields(struct splice *w, struct cut c, bool outer, int last)
{
	struct field f;
	int found = 0;

	while (cut_next(&c, &f)) {
		int k = value_of(w, &f, outer);

		if (k >= 0 && (!is_written(w, k) || (w->put >> k & 1) != 0)) {
			struct span gone = cut_out(&f);

			splice_to(w, gone.s);
			w->done = gone.end > w->done ? gone.end : w->done;
			found++;
			continue;
		}
		w->fields += outer;
		if (k < 0) {
			if (c.bracket != NULL &&
			    coordinate_in(w, f.value.s, f.value.end) >= 0)
				splice_fields(w, cut_value(f.value, c.end),
				    false, -1);
			continue;
		}
		if (k < w->l->reads && outer)
			w->separator = separator_at(w->l, &f);
		w->put |= 1u << k;
		if (w->numbers != NULL) {
			struct span at = k < w->l->reads ? w->at[k] : f.value;

			splice_to(w, at.s);
			w->out = put_value(w, k, w->out);
			w->done = at.end;
		}
		if (k == last) {
			splice_to(w, trimmed(c.in, f.whole).end);
			put_others(w, w->l->reads, false);
		}
		if (outer && last >= 0 && ++found == w->l->reads)
			return; /* nothing is to be done behind them */
	}
	if (outer) {
		if (c.from != NULL || c.bracket != NULL)
			splice_to(w, c.from != NULL ? c.from : c.bracket);
		put_others(w, 0, c.members);
	}
}

/* Returns the cut of the line, past its leading blanks, or of the names in a header. */
static struct cut cut_of(const struct layout *l, const struct line *line)
{
	struct span text = line_text(line);

	text.s += line->mark ? 3 : 0;
	if (line->kind == LINE_HEADER)
		text = header_names(l->in, text);
	text.s = skip_blanks(l->in, text.s, text.end);
	struct cut c = cut_line(l->in, text);

	c.words = line->words;
	return c;
}

static void splice_places(struct splice *w)
{
	for (int i = 0; i < w->l->reads; i++)
		if (!is_missing(w->line->at[i]))
			w->at[i] = line_at(w->line, i);
}

static void splice(struct splice *w)
{
	const struct layout *l = w->l;
	int last = (l->reads < l->writes ? l->reads : l->writes) - 1;
	struct cut c = cut_of(l, w->line);

	for (int i = 0; i < l->reads; i++)
		if (w->at[i].s == NULL || c.members)
			last = -1; /* what is added stands at the end */
	w->done = w->line->s;
	splice_fields(w, c, true, last);
	splice_to(w, w->line->s + w->line->size);
}

/* Writes the line whole, and the values before its end or its closing bracket. */
static void append(struct splice *w)
{
	const struct layout *l = w->l;
	const struct format_row *in = format_of(l->in);
	struct span line = line_text(w->line), s = line;
	struct cut c = cut_of(l, w->line);
	struct field f;

	if (in->header) /* the blanks at the end are of the last field */
		s.end -= s.end > s.s && s.end[-1] == '\r';
	else
		s = trimmed(l->in, s);
	if (*in->close != '\0')
		s = trimmed(l->in, (struct span){ s.s, s.end - 1 });
	w->fields = *in->close == '\0' || s.end - s.s > 1;
	while (in->blanks && cut_next(&c, &f))
		if (coordinate_in(w, f.whole.s, f.value.s) >= 0)
			w->separator = separator_at(l, &f);
	w->done = line.s;
	splice_to(w, s.end);
	put_others(w, 0, w->line->object);
	splice_to(w, line.end);
}

/* Writes the numbers of a binary record that are no coordinates. */
static char *put_rest_of_record(const struct layout *l, const struct line *line,
    char *out)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	const bool single = l->in.format == FORMAT_F32;

	for (int i = 0; i < l->record && line->size == layout_record(l); i++) {
		const char *s = line->s + point_size(l->in.format, i);
		double v = single ? (double)little_float(s) : little_double(s);
		bool coordinate = false;

		for (int k = 0; k < l->reads; k++)
			coordinate |= layout_field(l, k) == i;
		if (coordinate)
			continue;
		*out++ = l->out.separator;
		out = !isfinite(v) ? stpcpy(out, format_of(l->out)->unknown) :
		    single ? number_write_float(out, (float)v, shortest) :
			     number_write(out, v, shortest);
	}
	return out;
}

/* Writes each field of the cut that holds no coordinate, or by --append each one,
 * behind a separator of the format out but for the first of the line. */
static char *put_fields(struct splice *w, struct cut c, char *out)
{
	const struct layout *l = w->l;
	/* csv's empty fields become "" in JSON, so that the fields after them keep
	 * their place in the array */
	bool empty = format_of(l->in)->header && !format_of(l->out)->blanks;
	struct field f;

	while (cut_next(&c, &f)) {
		if ((f.whole.s == f.whole.end && !empty) ||
		    (!l->append &&
			coordinate_in(w, f.whole.s, f.whole.end) >= 0))
			continue;
		if (w->fields++ > 0)
			*out++ = l->out.separator;
		out = format_convert(l->in, l->out, f.whole, out);
	}
	return out;
}

/* Writes all fields of a line that hold no coordinate. */
static char *put_rest_of(struct splice *w, char *out)
{
	return w->line->kind == LINE_LOST || w->line->object ?
	    out :
	    put_fields(w, cut_of(w->l, w->line), out);
}

char *line_rest(const struct layout *l, const struct line *line, char *out)
{
	const struct format_row *in = format_of(l->in);

	if (is_binary(l->in.format))
		return put_rest_of_record(l, line, out);
	if (line->kind != LINE_POINT || line->object || l->columns.n > 0) {
		struct splice w = { .l = l, .line = line, .fields = 1 };

		splice_places(&w);
		return put_rest_of(&w, out);
	}
	/* nothing else stands before the coordinates */
	struct cut c = { .in = l->in,
		.end = line->s + line->size,
		.bracket = *in->open != '\0' ? line->s : NULL };

	cut_behind(&c, line_at(line, l->reads - 1).end);
	if (c.s == NULL)
		return out;
	if (in->blanks && format_of(l->out)->blanks) {
		struct span rest = trimmed(l->in, (struct span){ c.s, c.end });

		*out = ' ';
		return rest.s < rest.end ?
		    splice_text(out + 1, rest.s, rest.end) :
		    out;
	}
	struct splice w = { .l = l, .line = line, .fields = 1 };

	return put_fields(&w, c, out);
}

/* Writes a point in another format: its image, then all other fields. */
static char *convert_point(const struct layout *l, const struct line *line,
    const struct numbers *n, const struct word *flags, char *out)
{
	const struct format_row *to = format_of(l->out);
	const struct number_text *text = n->text;
	const double *v = n->v;

	*out = *to->open;
	out += *to->open != '\0';
	for (int k = 0; k < l->writes;
	     k++, text += n->text_step, v += n->step) {
		*out = l->out.separator;
		out = line_put(l, k, text, *v, out + (k > 0));
	}
	if (flags != NULL) {
		*out = l->out.separator;
		out = put_word(l, flags, out + 1);
	}
	out = line_rest(l, line, out);
	*out = *to->close;
	out += *to->close != '\0';
	*out = '\n';
	return out + line->newline;
}

/* Writes the values first, then all other fields, or by --append the other way, as the
 * format out is another or the line can't be taken apart. */
static void convert(struct splice *w)
{
	const struct layout *l = w->l;
	char open = *format_of(l->out)->open, close = *format_of(l->out)->close;
	bool members = w->line->object && l->out.format == l->in.format;

	w->separator = (struct span){ &l->out.separator,
		&l->out.separator + 1 };
	*w->out = members ? '{' : open;
	w->out += open != '\0';
	if (l->append)
		w->out = put_rest_of(w, w->out);
	put_others(w, 0, members);
	if (!l->append)
		w->out = put_rest_of(w, w->out);
	*w->out = members ? '}' : close;
	w->out += close != '\0';
}

/* Writes the names of what is added, and of what is kept. */
static void write_header(struct splice *w)
{
	static const struct word word = { "flags", 5 };
	const struct layout *l = w->l;

	w->numbers = NULL;
	w->flags = l->flags ? &word : NULL;
	if (l->append) {
		append(w);
		return;
	}
	header_places(l, line_text(w->line), w->at);
	if (same_dialect(l->in, l->out)) {
		splice(w);
		return;
	}
	if (format_of(l->out)->blanks)
		w->out = stpcpy(w->out, "# ");
	convert(w);
}

char *line_write(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	if (line->kind == LINE_POINT && !l->append &&
	    !same_dialect(l->in, l->out))
		return convert_point(l, line, numbers, flags, out);
	struct splice w = { .l = l,
		.line = line,
		.numbers = numbers,
		.flags = flags,
		.separator = { &l->in.separator, &l->in.separator + 1 },
		.out = out };
	bool copy = line->kind == LINE_COPY, header = line->kind == LINE_HEADER;

	if ((copy || header) &&
	    (*format_of(l->in)->open != '\0' ||
		*format_of(l->out)->open != '\0'))
		return out;
	if (copy) {
		w.out = splice_text(out, line->s, line->s + line->size);
	} else if (header) {
		write_header(&w);
	} else {
		splice_places(&w);
		if (line->kind == LINE_LOST || !same_dialect(l->in, l->out))
			convert(&w);
		else if (l->append)
			append(&w);
		else
			splice(&w);
	}
	if (line->newline)
		*w.out++ = '\n';
	return w.out;
}
