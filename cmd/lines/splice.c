/* SPDX-License-Identifier: MIT */
/* convert_point writes points in another format without --append, convert_line other
 * lines, and LINE_LOST. splice_values copies a line field by field.
 * Value k of a point is its number k or, for FLAGS, the word of --flags. */
#include <math.h>
#include <string.h>

#include "../../core/points/kernel/little.h"
#include "../json/text.h"
#include "header.h"
#include "splice.h"

enum { FLAGS = COORDINATES_MAX };

struct splice {
	const struct layout *l;
	const struct line *line;
	const struct image_numbers *numbers; /* NULL in a header: names are written */
	const struct flags *flags;
	struct span separator; /* before each value that is added */
	const char *done;      /* bytes before it are copied or left out */
	char *out;             /* the end of the output */
	size_t fields;         /* the number of fields written so far */
	unsigned due;          /* bit k is set while value k is to be written */
	int last; /* added values follow this coordinate; -1: the last field */
};

size_t splice_room(const struct layout *l, size_t lines, size_t bytes)
{
	/* If the format changes, a byte of a field becomes up to six, as \u0001 in
	 * JSON, and a separator up to three: a comma and two quotes. 2 * PREFIX_ROOM is
	 * for separator and name of the word of --flags, brackets, # and newline. */
	return (same_dialect(l->in, l->out) ? bytes : 6 * bytes) +
	    lines *
	    ((size_t)l->writes * (NUMBER_MAX + PREFIX_ROOM) + FLAG_MAX +
		2 * PREFIX_ROOM);
}

static void copy_to(struct splice *w, const char *s)
{
	if (s > w->done) {
		memcpy(w->out, w->done, (size_t)(s - w->done));
		w->out += s - w->done;
		w->done = s;
	}
}

/* Returns the name of value k. Coordinates of a bad object keep their input names. */
static const char *value_name(const struct splice *w, int k)
{
	const struct layout *l = w->l;

	if (k < l->reads && w->line->object && w->line->kind == LINE_BAD &&
	    !l->output.append)
		return l->columns.name[k];
	return l->output.name[k];
}

/* Writes value k or, in a header, its name. Names of coordinates do not change. */
static char *put_value(const struct splice *w, int k, char *out)
{
	const struct layout *l = w->l;

	if (w->numbers == NULL)
		return !l->output.append && k < l->reads &&
			!part_is_missing(w->line->at[k]) ?
		    format_convert(l->in, l->out, line_field(w->line, k), out) :
		    stpcpy(out, value_name(w, k));
	return k < FLAGS ? put_coordinate(l, *w->numbers, k, out) :
			   put_flags_word(l, w->flags, out);
}

/* Writes all values due from k on, with names if `members` is set. */
static void put_values(struct splice *w, int k, bool members)
{
	size_t gap = (size_t)(w->separator.end - w->separator.s);
	unsigned due = w->due >> k << k;
	char *out = w->out;

	w->due -= due;
	for (; due != 0; due &= due - 1) {
		k = __builtin_ctz(due);
		if (members && *value_name(w, k) == '/')
			continue; /* a pointer that leads nowhere is no name */
		if (w->fields++ > 0)
			out = (char *)memcpy(out, w->separator.s, gap) + gap;
		if (members) {
			*out++ = '"';
			out = stpcpy(out, value_name(w, k));
			out = stpcpy(out, "\":");
		}
		out = put_value(w, k, out);
	}
	w->out = out;
}

/* Returns the first coordinate that begins in [s, end], or -1. */
static int coordinate_in(const struct splice *w, const char *s, const char *end)
{
	for (int i = 0; i < w->l->reads; i++) {
		const char *at = line_field(w->line, i).s;

		if (at >= s && at <= end && !part_is_missing(w->line->at[i]))
			return i;
	}
	return -1;
}

/* Returns the value that replaces the field f, or -1: a coordinate its own, without
 * --append; an added value a member of its name, if f is not inside a value (outer). */
static int value_for(const struct splice *w, const struct field *f, bool outer)
{
	const bool keeps = w->l->output.append;
	int i = keeps ? -1 : coordinate_in(w, f->whole.s, f->value.s);

	if (i >= 0 || f->name.s == NULL || !outer)
		return i;
	for (int k = keeps ? 0 : w->l->reads; k <= FLAGS; k++) {
		const char *name = w->l->output.name[k];
		struct span added = { name, name + strlen(name) };

		if (*name != '\0' && json_is_name(f->name, added, false))
			return k;
	}
	return -1;
}

/* Returns, in the format text, the separator before f or, if it is first, after it. */
static struct span separator_at(const struct layout *l, const struct field *f)
{
	struct span one = { &l->in.separator, &l->in.separator + 1 };
	struct span found = { f->previous_end, f->value.s };

	if (!format_of(l->in)->blanks)
		return one;
	if (f->previous_end == NULL)
		found = (struct span){ f->whole.end, f->next };
	return found.s < found.end && found.end - found.s <= PREFIX_ROOM ? found : one;
}

/* Leaves out the field f and the separator before f, or after f if f is the first. */
static void skip_field(struct splice *w, const struct field *f)
{
	bool first = f->previous_end == NULL;
	const char *end = first && f->next != NULL ? f->next : f->whole.end;

	copy_to(w, first ? f->whole.s : f->previous_end);
	w->done = end > w->done ? end : w->done;
}

/* Writes value k in the place of the field f. In a header f, which is a name, stays. */
static void replace_field(struct splice *w, const struct field *f, int k)
{
	const bool coordinate = k < w->l->reads && !w->l->output.append;
	struct span at = coordinate ? line_field(w->line, k) : f->value;

	w->due -= 1u << k;
	if (w->numbers == NULL)
		return;
	copy_to(w, at.s);
	w->out = put_value(w, k, w->out);
	w->done = at.end;
}

/* Copies a line's fields or (not outer) those of an array or object that has
 * coordinates in it, which stay by --append. Leaves those not due out. */
static void splice_fields(struct splice *w, struct cursor *c, bool outer)
{
	struct field f;

	while (cursor_next(c, &f)) {
		int k = value_for(w, &f, outer);

		if (k >= 0 && (w->due >> k & 1) == 0) {
			skip_field(w, &f);
			continue;
		}
		w->fields += outer;
		if (k >= 0) {
			replace_field(w, &f, k);
		} else if (c->bracket != NULL && !w->l->output.append &&
		    coordinate_in(w, f.value.s, f.value.end) >= 0) {
			struct cursor inside = value_cursor(f.value, c->end);

			splice_fields(w, &inside, false);
		}
		if (outer && coordinate_in(w, f.whole.s, f.value.s) >= 0)
			w->separator = separator_at(w->l, &f);
		if (outer && k >= 0 && k == w->last) {
			copy_to(w, trimmed(c->in, f.whole).end);
			put_values(w, w->l->reads, false);
		}
	}
}

/* Returns a cursor before the first field of a line or the first name of a header. */
static struct cursor cursor_of(const struct layout *l, const struct line *line)
{
	struct span text = line_text(line);
	struct cursor c;

	text.s += line->has_bom ? 3 : 0;
	c = line->kind == LINE_HEADER ? header_cursor(l->in, text) :
					line_cursor(l->in, text);
	/* blanks are part of a field of csv, also of the first */
	if (c.s != NULL && (line->kind == LINE_HEADER || !format_of(l->in)->header))
		c.s = skip_blanks(l->in, c.s, c.end);
	c.no_commas = line->no_commas;
	return c;
}

/* By --append all values follow the fields. */
static void splice_values(struct splice *w)
{
	const struct layout *l = w->l;
	struct cursor c = cursor_of(l, w->line);
	const char *end;

	w->last = (l->reads < l->writes ? l->reads : l->writes) - 1;
	for (int i = 0; i < l->reads; i++)
		if (part_is_missing(w->line->at[i]) || c.members || l->output.append)
			w->last = -1;
	splice_fields(w, &c, true);
	end = c.previous_end != NULL ? c.previous_end : c.bracket;
	if (l->output.append && c.bracket == NULL) /* blanks can end a field of csv */
		end = format_of(l->in)->header ?
		    c.end - (c.end > w->line->s && c.end[-1] == '\r') :
		    trimmed(l->in, line_text(w->line)).end;
	copy_to(w, end);
	put_values(w, 0, c.members);
}

static void cursor_after(struct cursor *c, const char *s)
{
	const char *end = c->end, *after;

	c->previous_end = s;
	if (format_of(c->in)->blanks) {
		after = skip_text_separator(s, end);
		c->s = after < end ? after : NULL;
		return;
	}
	s = skip_blanks(c->in, s, end); /* in quotes they are blanks, too */
	after = skip_blanks(c->in, s + (s < end && *s == '"'), end);
	c->s = after < end && *after == c->in.separator ? after + 1 : NULL;
	if (c->s != NULL && c->bracket != NULL)
		c->s = json_skip_blanks(c->s, end);
}

static char *put_other_numbers(const struct layout *l, const struct line *line,
    char *out)
{
	const struct number_style shortest = { NUMBER_SHORTEST, 0 };
	const bool single = l->in.format == FORMAT_F32;

	for (int i = 0; i < l->record && line->size == layout_record_size(l); i++) {
		const char *s = line->s + format_point_size(l->in.format, i);
		double v = little_get(s, !single);
		bool coordinate = false;

		for (int k = 0; k < l->reads; k++)
			coordinate |= layout_field(l, k) == i;
		if (coordinate)
			continue;
		*out++ = l->out.separator;
		out = !isfinite(v) ? stpcpy(out, format_of(l->out)->nan_text) :
		    single         ? number_write_float(out, (float)v, shortest) :
				     number_write(out, v, shortest);
	}
	return out;
}

/* Writes fields that hold no coordinate, or by --append all, in the output's format. */
static void put_other_fields(struct splice *w)
{
	const struct layout *l = w->l;
	const struct line *line = w->line;
	const struct format_row *in = format_of(l->in), *to = format_of(l->out);
	/* in JSON an empty csv field becomes "", so that fields keep their places */
	const bool empty = in->header && !to->blanks;
	struct cursor c = { .in = l->in, .end = line->s + line->size };
	const bool replaced = line->kind == LINE_POINT && !l->output.append;
	const bool in_row = in->header && replaced && layout_in_row(l);
	uint32_t last = 1; /* the place after the last coordinate, or 1 */
	struct field f;

	if (format_is_binary(l->in.format)) {
		w->out = put_other_numbers(l, line, w->out);
		return;
	}
	if (line->kind == LINE_LOST || line->object)
		return;
	if (replaced && layout_in_order(l)) {
		c.bracket = *in->open != '\0' ? line->s : NULL;
		cursor_after(&c, line_field(line, l->reads - 1).end);
		if (in->blanks && to->blanks && l->columns.n == 0 && c.s != NULL) {
			*w->out++ = ' ';
			w->done = c.s;
			copy_to(w, trimmed(l->in, (struct span){ c.s, c.end }).end);
			return;
		}
	} else {
		c = cursor_of(l, line);
		for (int i = 0; i < l->reads && !l->output.append; i++)
			last = line->at[i].to > last ? line->at[i].to : last;
	}
	while (c.s != NULL) {
		if (in->header && w->fields > 0 && c.previous_end != NULL &&
		    c.s > line->s + last)
			w->out = format_convert_plain(&c, l->out, w->out);
		if (!cursor_next(&c, &f))
			break;
		int k = l->output.append ? -1 :
					   coordinate_in(w, f.whole.s, f.whole.end);

		if (in_row && k == 0)
			cursor_after(&c, line_field(line, l->reads - 1).end);
		if (k >= 0 || (f.whole.s == f.whole.end && !empty))
			continue;
		*w->out = l->out.separator;
		w->out += w->fields++ > 0;
		w->out = format_convert(l->in, l->out, f.whole, w->out);
	}
}

char *splice_rest(const struct layout *l, const struct line *line, char *out)
{
	struct splice w = { .l = l, .line = line, .out = out, .fields = 1 };

	put_other_fields(&w);
	return w.out;
}

/* Values precede the other fields; by --append they follow all fields. */
static void convert_line(struct splice *w)
{
	const struct layout *l = w->l;
	const struct format_row *to = format_of(l->out);
	bool members = w->line->object && l->out.format == l->in.format;

	w->out = stpcpy(w->out, members ? "{" : to->open);
	if (l->output.append)
		put_other_fields(w);
	put_values(w, 0, members);
	if (!l->output.append)
		put_other_fields(w);
	w->out = stpcpy(w->out, members ? "}" : to->close);
}

/* Writes a point as convert_line does without --append, but faster. */
static char *convert_point(const struct layout *l, const struct line *line,
    struct image_numbers n, const struct flags *flags, char *out)
{
	const struct format_row *to = format_of(l->out);

	*out = *to->open;
	out = put_coordinate(l, n, 0, out + (*to->open != '\0'));
	out = put_added(l, n, 1, l->out.separator, flags, out);
	out = splice_rest(l, line, out);
	*out = *to->close;
	out += *to->close != '\0';
	*out = '\n';
	return out + line->newline;
}

char *splice_line(const struct layout *l, const struct line *line,
    const struct image_numbers *numbers, const struct flags *flags, char *out)
{
	bool header = line->kind == LINE_HEADER;
	bool same = same_dialect(l->in, l->out);

	if (line->kind == LINE_POINT && !same && !l->output.append)
		return convert_point(l, line, *numbers, l->output.flags ? flags : NULL,
		    out);
	if ((header || line->kind == LINE_COPY) &&
	    (*format_of(l->in)->open != '\0' || *format_of(l->out)->open != '\0'))
		return out;
	struct splice w = { .l = l,
		.line = line,
		.numbers = header ? NULL : numbers,
		.flags = flags,
		.separator = { &l->out.separator, &l->out.separator + 1 },
		.done = line->s,
		.out = out,
		.due = ((1u << l->writes) - 1) | (unsigned)l->output.flags << FLAGS };

	if (header && !same && format_of(l->out)->blanks)
		w.out = stpcpy(w.out, "# ");
	if (line->kind == LINE_LOST || (!same && line->kind != LINE_COPY)) {
		convert_line(&w);
	} else {
		if (line->kind != LINE_COPY)
			splice_values(&w);
		copy_to(&w, line->s + line->size);
	}
	*w.out = '\n';
	return w.out + line->newline;
}
