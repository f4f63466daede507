/* SPDX-License-Identifier: MIT */
/* Writes lines with other values. Values are numbered: COORDINATES_MAX numbers, and
 * then the word. A point of the same format, none of whose coordinates goes, changes in
 * place; all other lines are cut into fields again, and splice_fields or convert_line
 * decides of each field whether it stays. */
#include <math.h>
#include <string.h>

#include "../../core/points/kernel/little.h"
#include "../json/text.h"
#include "choose.h"
#include "header.h"
#include "in_place.h"

enum { FLAGS = COORDINATES_MAX };

/* A line that is being written. */
struct splice {
	const struct layout *l;
	const struct line *line;
	const struct numbers *numbers; /* NULL: names are written, of a header */
	const struct word *flags;
	struct span separator; /* before what is added */
	const char *done;      /* the line up to here is copied, or left out */
	char *out;
	size_t fields;  /* how many fields are in out */
	unsigned value; /* bit k: value k is written in this line ... */
	unsigned put;   /* ... and is in out already */
};

size_t lines_room(const struct layout *l, size_t lines, size_t bytes)
{
	/* In another format a byte of a field may become six, as \u0001 in
	 * JSON. Six for the separator after it are enough for a comma and two
	 * quotes. The last ADDED_ROOM is for brackets and the newline. */
	return (same_dialect(l->in, l->out) ? bytes : 6 * bytes) +
	    lines *
	    ((size_t)l->writes * (NUMBER_MAX + ADDED_ROOM) + WORD_MAX +
		2 * ADDED_ROOM);
}

char *line_put_rare(const struct layout *l, int k, double v, char *out)
{
	if (isnan(v))
		return stpcpy(out, format_of(l->out)->unknown);
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

/* Returns the name of value k: of a member that a bad object lacks, its path. */
static const char *value_name(const struct splice *w, int k)
{
	const struct layout *l = w->l;

	if (k < l->reads && w->line->object && w->line->kind == LINE_BAD &&
	    !l->append)
		return l->columns.name[k];
	return l->name[k];
}

/* Returns whether value k is still to be written. */
static bool is_due(const struct splice *w, int k)
{
	return ((w->value & ~w->put) >> k & 1) != 0;
}

static char *put_value(const struct splice *w, int k, char *out)
{
	const struct layout *l = w->l;

	if (w->numbers == NULL)
		return !l->append && k < l->reads &&
			!is_missing(w->line->at[k]) ?
		    format_convert(l->in, l->out, line_at(w->line, k), out) :
		    stpcpy(out, value_name(w, k));
	return k < FLAGS ? put_number(l, *w->numbers, k, out) :
			   put_word(l, w->flags, out);
}

/* Writes the values from k on that are due: behind a separator, but for the first of
 * the line, and in an object behind its name. */
static void put_others(struct splice *w, int k, bool members)
{
	size_t gap = (size_t)(w->separator.end - w->separator.s);
	unsigned due = (w->value & ~w->put) >> k << k;
	char *out = w->out;

	w->put |= due;
	for (; due != 0; due &= due - 1) {
		k = __builtin_ctz(due);
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
	}
	w->out = out;
}

/* Returns the coordinate that begins from s up to end, or -1. */
static int coordinate_in(const struct splice *w, const char *s, const char *end)
{
	for (int i = 0; i < w->l->reads; i++) {
		const char *at = line_at(w->line, i).s;

		if (at >= s && at <= end && !is_missing(w->line->at[i]))
			return i;
	}
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
		const char *name = value_name(w, k);
		struct span added = { name, name + strlen(name) };

		if ((w->value >> k & 1) != 0 &&
		    json_is_name(f->name, added, false))
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

		if (k >= 0 && !is_due(w, k)) {
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
			struct span at = k < w->l->reads ?
			    line_at(w->line, k) :
			    f.value;

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

static void splice(struct splice *w)
{
	const struct layout *l = w->l;
	int last = (l->reads < l->writes ? l->reads : l->writes) - 1;
	struct cut c = cut_of(l, w->line);

	for (int i = 0; i < l->reads; i++)
		if (is_missing(w->line->at[i]) || c.members)
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
static void put_fields(struct splice *w, struct cut c)
{
	const struct layout *l = w->l;
	/* csv's empty fields become "" in JSON, so that the fields after them keep
	 * their place in the array */
	bool empty = format_of(l->in)->header && !format_of(l->out)->blanks;
	char *out = w->out;
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
	w->out = out;
}

/* Writes all fields of a line that hold no coordinate. */
static void put_rest(struct splice *w)
{
	if (w->line->kind != LINE_LOST && !w->line->object)
		put_fields(w, cut_of(w->l, w->line));
}

char *line_rest(const struct layout *l, const struct line *line, char *out)
{
	struct cut c = { .in = l->in, .end = line->s + line->size };
	bool first = line->kind == LINE_POINT && !line->object &&
	    l->columns.n == 0;

	if (is_binary(l->in.format))
		return put_rest_of_record(l, line, out);
	if (first) {
		/* no other field stands before the coordinates */
		c.bracket = *format_of(l->in)->open != '\0' ? line->s : NULL;
		cut_behind(&c, line_at(line, l->reads - 1).end);
		if (c.s == NULL)
			return out;
	}
	if (first && format_of(l->in)->blanks && format_of(l->out)->blanks) {
		struct span rest = trimmed(l->in, (struct span){ c.s, c.end });

		*out = ' ';
		return rest.s < rest.end ?
		    splice_text(out + 1, rest.s, rest.end) :
		    out;
	}
	struct splice w = { .l = l, .line = line, .out = out, .fields = 1 };

	if (first)
		put_fields(&w, c);
	else
		put_rest(&w);
	return w.out;
}

/* Writes the values first, then all other fields, or by --append the other way, as the
 * format out is another or the line can't be taken apart. */
static void convert_line(struct splice *w)
{
	const struct layout *l = w->l;
	char open = *format_of(l->out)->open, close = *format_of(l->out)->close;
	bool members = w->line->object && l->out.format == l->in.format;

	w->separator = (struct span){ &l->out.separator,
		&l->out.separator + 1 };
	*w->out = members ? '{' : open;
	w->out += open != '\0';
	if (l->append)
		put_rest(w);
	put_others(w, 0, members);
	if (!l->append)
		put_rest(w);
	*w->out = members ? '}' : close;
	w->out += close != '\0';
}

/* Writes a point in another format: its image, then all other fields. */
static char *convert_point(const struct layout *l, const struct line *line,
    struct numbers n, const struct word *flags, char *out)
{
	const struct format_row *to = format_of(l->out);

	*out = *to->open;
	out += *to->open != '\0';
	for (int k = 0; k < l->writes; k++) {
		*out = l->out.separator;
		out = put_number(l, n, k, out + (k > 0));
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

char *line_write(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	static const struct word name = { "flags", 5 };
	bool header = line->kind == LINE_HEADER;
	bool same = same_dialect(l->in, l->out);

	if (line->kind == LINE_POINT && !same && !l->append)
		return convert_point(l, line, *numbers, flags, out);
	if ((header || line->kind == LINE_COPY) &&
	    (*format_of(l->in)->open != '\0' ||
		*format_of(l->out)->open != '\0'))
		return out;
	struct splice w = { .l = l,
		.line = line,
		.numbers = header ? NULL : numbers,
		.flags = header ? &name : flags,
		.separator = { &l->in.separator, &l->in.separator + 1 },
		.out = out,
		.value = ((1u << l->writes) - 1) |
		    (unsigned)l->flags << FLAGS };

	if (header && !same && format_of(l->out)->blanks)
		w.out = stpcpy(w.out, "# ");
	if (line->kind == LINE_COPY)
		w.out = splice_text(out, line->s, line->s + line->size);
	else if (line->kind == LINE_LOST || !same)
		convert_line(&w);
	else if (l->append)
		append(&w);
	else
		splice(&w);
	*w.out = '\n';
	return w.out + line->newline;
}
