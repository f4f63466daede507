/* SPDX-License-Identifier: MIT */
/* Writes lines that in_place.h does not write. There are four ways: convert_point and
 * convert write a point, or another line, in another format; append keeps the line and
 * adds values; splice cuts the line into fields again and decides for each whether it
 * stays, changes or goes.
 *
 * A value is a number or the word of --flags that is written for a point: value k <
 * COORDINATES_MAX is number k, and the value FLAGS is the word. */
#include <math.h>
#include <string.h>

#include "../../core/points/kernel/little.h"
#include "../json/text.h"
#include "line.h"
#include "in_place.h"

enum { FLAGS = COORDINATES_MAX };

/* A line that is being written. */
struct splice {
	const struct layout *l;
	const struct line *line;
	const struct numbers *numbers; /* NULL in a header: names are written */
	const struct word *flags;
	struct span separator; /* before each value that is added */
	const char *done;      /* bytes before it have been copied or skipped */
	char *out;             /* the end of the output */
	size_t fields;         /* the number of fields written so far */
	unsigned due;          /* bit k: value k is still to be written */
};

size_t lines_room(const struct layout *l, size_t lines, size_t bytes)
{
	/* In another format a byte of a field may become six, as \u0001 in
	 * JSON; six for the separator after the field are enough for a comma and
	 * two quotes. One ADDED_ROOM is for the word, and one for brackets, a #
	 * and the newline. */
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

/* Copies the line from done up to s. */
static void splice_to(struct splice *w, const char *s)
{
	if (s > w->done) {
		memcpy(w->out, w->done, (size_t)(s - w->done));
		w->out += s - w->done;
		w->done = s;
	}
}

/* Returns the name of value k; for a coordinate of a bad object, its name as read. */
static const char *value_name(const struct splice *w, int k)
{
	const struct layout *l = w->l;

	if (k < l->reads && w->line->object && w->line->kind == LINE_BAD &&
	    !l->append)
		return l->columns.name[k];
	return l->name[k];
}

/* Writes value k, or in a header its name; a coordinate keeps the header's name. */
static char *put_value(const struct splice *w, int k, char *out)
{
	const struct layout *l = w->l;

	if (w->numbers == NULL)
		return !l->append && k < l->reads &&
			!is_missing(w->line->at[k]) ?
		    format_convert(l->in, l->out, line_at(w->line, k), out) :
		    stpcpy(out, value_name(w, k));
	return k < FLAGS ? put_coordinate(l, *w->numbers, k, out) :
			   put_word(l, w->flags, out);
}

/* Writes all values from k on that are due, each after a separator unless it is the
 * first of the line, and in an object after its name. */
static void put_others(struct splice *w, int k, bool members)
{
	size_t gap = (size_t)(w->separator.end - w->separator.s);
	unsigned due = w->due >> k << k;
	char *out = w->out;

	w->due -= due;
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

/* Returns the coordinate that begins at s, at end or between them, or -1. */
static int coordinate_in(const struct splice *w, const char *s, const char *end)
{
	for (int i = 0; i < w->l->reads; i++) {
		const char *at = line_at(w->line, i).s;

		if (at >= s && at <= end && !is_missing(w->line->at[i]))
			return i;
	}
	return -1;
}

/* Returns the value that takes the place of the field, or -1. This is the coordinate in
 * the field, unless --append keeps that. If outer, the field is one of the line and not
 * of a value inside: in an object it may also be the added value with the name of the
 * field. */
static int value_of(const struct splice *w, const struct field *f, bool outer)
{
	const bool keeps = w->l->append;
	int i = keeps ? -1 : coordinate_in(w, f->whole.s, f->value.s);

	if (f->name.s == NULL || !outer)
		return i;
	for (int k = keeps ? 0 : w->l->reads; k <= FLAGS && i < 0; k++) {
		const char *name = w->l->name[k];
		struct span added = { name, name + strlen(name) };

		if (*name != '\0' && json_is_name(f->name, added, false))
			return k;
	}
	return i;
}

/* Returns the separator for values after the field f: in text a copy of the one before
 * f, or of the one after f if it is the first. */
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

/* Leaves out a field and the separator before it, or after it if it is the first. */
static void splice_out(struct splice *w, const struct field *f)
{
	bool first = f->from == NULL;
	const char *end = first && f->next != NULL ? f->next : f->whole.end;

	splice_to(w, first ? f->whole.s : f->from);
	w->done = end > w->done ? end : w->done;
}

/* Splices the fields of a line or, unless outer is set, of a value inside. A field
 * whose place a value takes (see value_of) becomes it, or is deleted if the value is
 * not due. Adds the other values after coordinate last; at the end if last is -1. */
static void splice_fields(struct splice *w, struct cut c, bool outer, int last)
{
	struct field f;

	while (cut_next(&c, &f)) {
		int k = value_of(w, &f, outer);

		if (k >= 0 && (w->due >> k & 1) == 0) {
			splice_out(w, &f);
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
		w->due -= 1u << k;
		if (w->numbers != NULL) {
			struct span at = k < w->l->reads && !w->l->append ?
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
	}
	if (outer) {
		splice_to(w, c.from != NULL ? c.from : c.bracket);
		put_others(w, 0, c.members);
	}
}

/* Returns a cut before the first field of the line, or the first name of a header. */
static struct cut cut_of(const struct layout *l, const struct line *line)
{
	struct span text = line_text(line);
	struct cut c;

	text.s += line->mark ? 3 : 0;
	c = line->kind == LINE_HEADER ? header_cut(l->in, text) :
					cut_line(l->in, text);
	if (c.s != NULL)
		c.s = skip_blanks(l->in, c.s, c.end);
	c.words = line->words;
	return c;
}

/* Writes the line in its own format with other values. */
static void splice(struct splice *w)
{
	const struct layout *l = w->l;
	int last = (l->reads < l->writes ? l->reads : l->writes) - 1;
	struct cut c = cut_of(l, w->line);

	for (int i = 0; i < l->reads; i++)
		if (is_missing(w->line->at[i]) || c.members)
			last = -1; /* add the other values at the end */
	splice_fields(w, c, true, last);
}

/* Copies the line, and adds all values at its end or before its last bracket. */
static void append(struct splice *w)
{
	const struct format_row *in = format_of(w->l->in);
	struct span s = line_text(w->line);
	struct cut c = cut_of(w->l, w->line);
	struct field f;

	if (in->header) /* blanks at the end belong to the last field */
		s.end -= s.end > s.s && s.end[-1] == '\r';
	else
		s = trimmed(c.in, s);
	if (*in->close != '\0')
		s = trimmed(c.in, (struct span){ s.s, s.end - 1 });
	w->fields = *in->close == '\0' || s.end - s.s > 1;
	while (in->blanks && cut_next(&c, &f))
		if (coordinate_in(w, f.whole.s, f.value.s) >= 0)
			w->separator = separator_at(w->l, &f);
	splice_to(w, s.end);
	put_others(w, 0, w->line->object);
}

/* Moves the cut to the field after the one whose value ends at s. */
static void cut_behind(struct cut *c, const char *s)
{
	const char *end = c->end, *after;

	c->from = s;
	if (format_of(c->in)->blanks) {
		after = skip_separator(s, end);
		c->s = after < end ? after : NULL;
		return;
	}
	after = skip_blanks(c->in, s + (s < end && *s == '"'), end);
	c->s = after < end && *after == c->in.separator ? after + 1 : NULL;
	if (c->s != NULL && c->bracket != NULL)
		c->s = json_skip_blanks(c->s, end);
}

/* Writes the numbers of a binary record that are not coordinates. */
static char *put_rest_of_record(const struct layout *l, const struct line *line,
    char *out)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	const bool single = l->in.format == FORMAT_F32;

	for (int i = 0; i < l->record && line->size == layout_record(l); i++) {
		const char *s = line->s + point_size(l->in.format, i);
		double v = little_get(s, !single);
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

/* Writes each field of a line that holds no coordinate, or by --append every field, in
 * the format out, after a separator unless the field is the first of the line. */
static void put_rest(struct splice *w)
{
	const struct layout *l = w->l;
	const struct line *line = w->line;
	const struct format_row *in = format_of(l->in), *to = format_of(l->out);
	/* csv's empty fields become "" in JSON, so that the fields after them keep
	 * their place in the array */
	const bool empty = in->header && !to->blanks;
	struct cut c = { .in = l->in, .end = line->s + line->size };
	char *out = w->out;
	struct field f;

	if (is_binary(l->in.format)) {
		w->out = put_rest_of_record(l, line, out);
		return;
	}
	if (line->kind == LINE_LOST || line->object)
		return;
	if (line->kind == LINE_POINT && layout_is_first(l) && !l->append) {
		c.bracket = *in->open != '\0' ? line->s : NULL;
		cut_behind(&c, line_at(line, l->reads - 1).end);
		if (in->blanks && to->blanks && l->columns.n == 0 &&
		    c.s != NULL) {
			*w->out++ = ' ';
			w->done = c.s;
			splice_to(w,
			    trimmed(l->in, (struct span){ c.s, c.end }).end);
			return;
		}
	} else {
		c = cut_of(l, line);
	}
	while (cut_next(&c, &f)) {
		if ((f.whole.s == f.whole.end && !empty) ||
		    (!l->append &&
			coordinate_in(w, f.whole.s, f.whole.end) >= 0))
			continue;
		*out = l->out.separator;
		out += w->fields++ > 0;
		out = format_convert(l->in, l->out, f.whole, out);
	}
	w->out = out;
}

char *line_rest(const struct layout *l, const struct line *line, char *out)
{
	struct splice w = { .l = l, .line = line, .out = out, .fields = 1 };

	put_rest(&w);
	return w.out;
}

/* Writes a line in another format, or a LINE_LOST: all values, then all other fields;
 * by --append first the fields. */
static void convert(struct splice *w)
{
	const struct layout *l = w->l;
	char open = *format_of(l->out)->open, close = *format_of(l->out)->close;
	bool members = w->line->object && l->out.format == l->in.format;

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

/* Writes a point as convert does without --append, which is the frequent case. */
static char *convert_point(const struct layout *l, const struct line *line,
    struct numbers n, const struct word *flags, char *out)
{
	const struct format_row *to = format_of(l->out);

	*out = *to->open;
	out = put_coordinate(l, n, 0, out + (*to->open != '\0'));
	for (int k = 1; k < l->writes; k++) {
		*out++ = l->out.separator;
		out = put_coordinate(l, n, k, out);
	}
	if (flags != NULL) {
		*out++ = l->out.separator;
		out = put_word(l, flags, out);
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
	bool header = line->kind == LINE_HEADER;
	bool same = same_dialect(l->in, l->out);
	/* a bad object may have members of the added names, which values replace */
	bool appends = l->append && !(line->object && line_is_bad(line));

	if (line->kind == LINE_POINT && !same && !l->append)
		return convert_point(l, line, *numbers, l->flags ? flags : NULL,
		    out);
	if ((header || line->kind == LINE_COPY) &&
	    (*format_of(l->in)->open != '\0' ||
		*format_of(l->out)->open != '\0'))
		return out;
	struct splice w = { .l = l,
		.line = line,
		.numbers = header ? NULL : numbers,
		.flags = flags,
		.separator = { &l->out.separator, &l->out.separator + 1 },
		.done = line->s,
		.out = out,
		.due = ((1u << l->writes) - 1) | (unsigned)l->flags << FLAGS };

	if (header && !same && format_of(l->out)->blanks)
		w.out = stpcpy(w.out, "# ");
	if (line->kind == LINE_LOST || (!same && line->kind != LINE_COPY)) {
		convert(&w);
	} else {
		if (line->kind != LINE_COPY)
			(appends ? append : splice)(&w);
		splice_to(&w, line->s + line->size);
	}
	*w.out = '\n';
	return w.out + line->newline;
}
