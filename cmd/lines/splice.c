/* SPDX-License-Identifier: MIT */
/* A line on its way out: values take the place of others, or stand behind them. */
#include <math.h>
#include <string.h>

#include "choose.h"
#include "field_convert.h"
#include "header.h"
#include "line_bad.h"

/* A longer separator of text is not repeated before what is added. */
enum { SEPARATOR_MAX = 64 };

/* The word's number where coordinates are numbered. */
enum { FLAGS = COORDINATES_MAX };

struct splice {
	const struct layout *l;
	const struct line *line;
	const struct numbers *numbers; /* NULL: the line is a header */
	const struct word *flags;      /* NULL: none is written */
	struct span separator;         /* before what is added */
	const char *done;              /* what of the line was dealt with */
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
	    ((size_t)l->writes * (NUMBER_MAX + SEPARATOR_MAX) + SEPARATOR_MAX +
		2 + WORD_MAX + 2 + 1);
}

static char *put(char *out, const char *s, const char *end)
{
	memcpy(out, s, (size_t)(end - s));
	return out + (end - s);
}

static char *put_string(char *out, const char *s)
{
	return put(out, s, s + strlen(s));
}

/* Copies the line up to s. */
static void copy_to(struct splice *w, const char *s)
{
	if (s > w->done) {
		w->out = put(w->out, w->done, s);
		w->done = s;
	}
}

/* What value k is called: a coordinate that is read, one that is added, or the word. */
static const char *name_of(const struct splice *w, int k)
{
	static const char *const names[] = { "x", "y", "z", "w" };
	static const char *const ray[] = { "x", "y", "z", "dx", "dy", "dz" };

	if (k == FLAGS)
		return "flags";
	if (k < w->l->reads && w->line->object && w->line->kind == LINE_BAD)
		return path_of(w->l, k);
	return w->l->writes > 4 ? ray[k] : names[k];
}

static bool is_written(const struct splice *w, int k)
{
	return k == FLAGS ? w->flags != NULL : k < w->l->writes;
}

static char *put_value(const struct splice *w, int k, char *out)
{
	const struct layout *l = w->l;
	bool json = l->out.format == FORMAT_JSON;

	if (w->numbers == NULL) {
		struct part at = w->line->at[k < l->reads ? k : 0];

		return k < l->reads && at.from < at.to ?
		    field_convert(l->in, l->out, line_at(w->line, k), out) :
		    put_string(out, name_of(w, k));
	}
	if (k == FLAGS) {
		*out = '"';
		out = put(out + json, w->flags->s,
		    w->flags->s + w->flags->size);
		*out = '"';
		return out + json;
	}
	double v = w->numbers->v[(size_t)k * w->numbers->step];

	if (json && isnan(v))
		return put_string(out, "null");
	return number_put(out,
	    &w->numbers->text[(size_t)k * w->numbers->text_step], v, l->single,
	    l->style[k]);
}

/* Writes every value from k on that was not yet: each behind a separator, but for the
 * first of the line, and in an object behind its name. */
static void put_others(struct splice *w, int k, bool members)
{
	for (; k <= FLAGS; k++) {
		if (!is_written(w, k) || (w->put >> k & 1) != 0)
			continue;
		if (w->fields++ > 0)
			w->out = put(w->out, w->separator.s, w->separator.end);
		if (members) {
			*w->out++ = '"';
			w->out = put_string(w->out, name_of(w, k));
			*w->out++ = '"';
			*w->out++ = ':';
		}
		w->out = put_value(w, k, w->out);
		w->put |= 1u << k;
	}
}

/* Which value stands in the field, or -1: a coordinate, or in an object one that is
 * added and has its name. */
static int value_of(const struct splice *w, const struct field *f, bool outer)
{
	for (int i = 0; i < w->l->reads; i++) {
		struct span at = line_at(w->line, i);

		if (!is_missing(w->line->at[i]) && at.s <= f->value.s &&
		    at.s >= f->whole.s && at.end >= f->value.end &&
		    at.end <= f->whole.end)
			return i;
	}
	for (int k = w->l->reads; k <= FLAGS && outer && f->name.s != NULL; k++)
		if (is_written(w, k) &&
		    choose_is_name(f->name, name_of(w, k),
			strlen(name_of(w, k))))
			return k;
	return -1;
}

/* Whether a coordinate stands somewhere in the span, or the span in one. */
static bool touches(const struct splice *w, struct span f)
{
	for (int i = 0; i < w->l->reads; i++) {
		struct span at = line_at(w->line, i);

		if (!is_missing(w->line->at[i]) &&
		    ((at.s >= f.s && at.end <= f.end) ||
			(f.s >= at.s && f.end <= at.end)))
			return true;
	}
	return false;
}

/* The separator that is repeated behind the field f: in text the one before it, or
 * behind it if it is the first. */
static struct span separator_at(const struct layout *l, const struct field *f)
{
	struct span one = { &l->in.separator, &l->in.separator + 1 };
	struct span found = { f->from, f->value.s };

	if (l->in.format != FORMAT_TEXT)
		return one;
	if (f->from == NULL)
		found = (struct span){ f->whole.end, f->next };
	return found.s < found.end && found.end - found.s <= SEPARATOR_MAX ?
	    found :
	    one;
}

/* Goes through the fields of a line, or of a value in it: writes each value in the
 * place of the one that was read, and leaves out coordinates that are not written. */
static void splice_fields(struct splice *w, struct cut c, bool outer, int last)
{
	struct field f;
	int found = 0;

	while (cut_next(&c, &f)) {
		int k = value_of(w, &f, outer);

		if (k >= 0 && !is_written(w, k)) {
			struct span gone = field_drop(&f);

			copy_to(w, gone.s);
			w->done = gone.end > w->done ? gone.end : w->done;
			found++;
			continue;
		}
		w->fields += outer;
		if (k < 0) {
			if (c.in.format == FORMAT_JSON && touches(w, f.value))
				splice_fields(w, cut_value(f.value, c.end),
				    false, -1);
			continue;
		}
		if (k < w->l->reads && outer)
			w->separator = separator_at(w->l, &f);
		w->put |= 1u << k;
		if (w->numbers != NULL) {
			struct span at = k < w->l->reads ? line_at(w->line, k) : f.value;

			copy_to(w, at.s);
			w->out = put_value(w, k, w->out);
			w->done = at.end;
		}
		if (k == last) {
			copy_to(w, trimmed(c.in, f.whole).end);
			put_others(w, w->l->reads, false);
		}
		if (outer && last >= 0 && ++found == w->l->reads)
			return; /* nothing is to be done behind them */
	}
	if (outer) {
		if (c.from != NULL || c.bracket != NULL)
			copy_to(w, c.from != NULL ? c.from : c.bracket);
		put_others(w, 0, c.members);
	}
}

/* The line's fields, or names, as it was read. */
static struct cut cut_of(const struct layout *l, const struct line *line)
{
	struct span text = line_text(line);

	text.s += line->mark ? 3 : 0;
	struct cut c = cut_line(l->in,
	    line->kind == LINE_HEADER ? header_names(l->in, text) : text);

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
	copy_to(w, w->line->s + w->line->size);
}

char *line_rest(const struct layout *l, const struct line *line, char *out)
{
	const struct splice w = { .l = l, .line = line };
	const char *end = line->s + line->size, *s;
	struct field f;

	if (line->kind == LINE_LOST || line->object || is_binary(l->in.format))
		return out;
	if (line->kind == LINE_POINT && l->columns.n == 0 &&
	    l->in.format == FORMAT_TEXT && l->out.format == FORMAT_TEXT) {
		s = skip_separator(line_at(line, l->reads - 1).end, end);
		while (end > s && is_blank(end[-1]))
			end--;
		return s < end ? put(put_string(out, " "), s, end) : out;
	}
	struct cut c = cut_of(l, line);

	/* most often the coordinates come first */
	if (line->kind == LINE_POINT && l->columns.n == 0)
		c = cut_behind(c, line_at(line, l->reads - 1).end);
	while (cut_next(&c, &f)) {
		/* csv's empty fields become "" in JSON, so that the fields
		 * after them keep their place in the array */
		bool kept = f.whole.s < f.whole.end ||
		    (l->in.format == FORMAT_CSV &&
			l->out.format != FORMAT_TEXT);

		if (!kept || touches(&w, f.whole))
			continue;
		*out++ = l->out.separator;
		out = field_convert(l->in, l->out, f.whole, out);
	}
	return out;
}

/* The format out is another, or the line can't be taken apart: the values go first,
 * then all other fields. */
static void convert(struct splice *w)
{
	const struct layout *l = w->l;
	bool json = l->out.format == FORMAT_JSON;
	bool members = json && l->in.format == FORMAT_JSON && w->line->object;

	w->separator = (struct span){ &l->out.separator, &l->out.separator + 1 };
	if (json)
		*w->out++ = members ? '{' : '[';
	put_others(w, 0, members);
	w->out = line_rest(l, w->line, w->out);
	if (json)
		*w->out++ = members ? '}' : ']';
}

static void copy_header(struct splice *w)
{
	static const struct word word = { "flags", 5 };
	const struct layout *l = w->l;
	struct line named = *w->line;

	header_places(l, line_text(w->line), &named);
	w->line = &named;
	w->numbers = NULL;
	w->flags = l->flags ? &word : NULL;
	if (same_dialect(l->in, l->out)) {
		splice(w);
		return;
	}
	if (l->out.format == FORMAT_TEXT)
		w->out = put_string(w->out, "# ");
	convert(w);
}

char *line_write(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	bool json = l->in.format == FORMAT_JSON || l->out.format == FORMAT_JSON;
	struct splice w = { .l = l,
		.line = line,
		.numbers = numbers,
		.flags = flags,
		.separator = { &l->in.separator, &l->in.separator + 1 },
		.out = out };

	if (json && (line->kind == LINE_COPY || line->kind == LINE_HEADER))
		return out;
	if (line->kind == LINE_COPY)
		w.out = put(out, line->s, line->s + line->size);
	else if (line->kind == LINE_HEADER)
		copy_header(&w);
	else if (line->kind == LINE_LOST || !same_dialect(l->in, l->out))
		convert(&w);
	else
		splice(&w);
	if (line->newline)
		*w.out++ = '\n';
	return w.out;
}
