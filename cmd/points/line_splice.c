/* SPDX-License-Identifier: MIT */
#include "line_splice.h"

#include <string.h>

#include "line_bad.h"
#include "line_object.h"
#include "line_put.h"

/* Writes the coordinates from the k-th on, or, for a header, where numbers is
 * NULL, their names; then flags unless it is NULL. A separator goes before each. */
static char *put_more(const struct layout *l, int k,
    const struct numbers *numbers, const struct word *flags,
    struct span separator, char *out)
{
	for (; k < l->writes; k++) {
		const char *name = name_of(l, k);

		out = put(out, separator.s, separator.end);
		out = numbers != NULL ? put_number(l, numbers, k, out) :
					put(out, name, name + strlen(name));
	}
	if (flags != NULL)
		out = put_word(l->out, flags,
		    put(out, separator.s, separator.end));
	return out;
}

static bool separates(char c)
{
	return is_blank(c) || c == ',';
}

/* The separator to write before numbers that are added to the line. In text it
 * is the one that stands before the coordinate last, or after it if that is the
 * first field; but the usual one if what stands there has several commas or is
 * too long. Other formats have one separator only. */
static struct span separator_in(const struct layout *l, const struct line *line,
    struct span last)
{
	struct span one = { &l->in.separator, &l->in.separator + 1 };
	struct span text = line_text(line);
	struct span found = { last.s, last.s };

	if (l->in.format != FORMAT_TEXT)
		return one;
	while (found.s > text.s && separates(found.s[-1]))
		found.s--;
	if (found.s == text.s) {
		found.s = found.end = last.end;
		while (found.end < text.end && separates(*found.end))
			found.end++;
	}
	return found.s < found.end && found.end - found.s <= SEPARATOR_MAX &&
		skip_separator(found.s, found.end) == found.end ?
	    found :
	    one;
}

/* Where a separator begins that ends before s, with the blanks around it. */
static const char *separator_before(struct dialect d, const char *begin,
    const char *s)
{
	while (s > begin && is_blank_of(d, s[-1]))
		s--;
	if (s > begin && s[-1] == (d.format == FORMAT_TEXT ? ',' : d.separator))
		s--;
	while (s > begin && is_blank_of(d, s[-1]))
		s--;
	return s;
}

/* What has to go if coordinate i is not written: also its quotes, and the separator
 * before it, or after it if it is the first field. */
static struct span whole_field(const struct layout *l, const struct line *line,
    int i)
{
	const struct span text = line_text(line);
	const char *s = skip_mark(text.s, text.end), *next;
	struct span f = line_at(line, i);
	struct json_place p;

	if (line->object) {
		json_place_find((struct span){ s, text.end }, path_of(l, i),
		    &p);
		return json_place_whole(&p);
	}
	if (l->in.format == FORMAT_CSV && f.s > s && f.s[-1] == '"' &&
	    f.end < text.end && *f.end == '"') {
		f.s--;
		f.end++;
	}
	const char *before = separator_before(l->in, s, f.s);

	if (before > s && (l->in.format != FORMAT_JSON || before[-1] != '['))
		return (struct span){ before, f.end };
	next = field_next(l->in, f.end, text.end);
	return (struct span){ f.s, next != NULL ? next : f.end };
}

/* What goes in the place of a part of the line: number k, or, where that is not
 * written, nothing; k = FLAGS is the word. */
struct edit {
	struct span at;
	int k;
};

static void add_edit(struct edit *edits, int *n, struct edit e)
{
	int k = (*n)++;

	for (; k > 0 && edits[k - 1].at.s > e.at.s; k--)
		edits[k] = edits[k - 1];
	edits[k] = e;
}

/* The coordinates that have a place, in the order in which they stand there. */
static int edits_of(const struct layout *l, const struct line *line,
    struct edit edits[EDITS])
{
	int n = 0;

	for (int i = 0; i < l->reads; i++) {
		if (is_missing(line->at[i]))
			continue;
		add_edit(edits, &n,
		    (struct edit){ i < l->writes ? line_at(line, i) :
						   whole_field(l, line, i),
			i });
	}
	return n;
}

/* Writes the coordinates that a bad line lacks, or their names. */
static char *put_missing(const struct layout *l, const struct line *line,
    const struct numbers *numbers, struct span separator, char *out)
{
	for (int i = 0; i < l->reads && i < l->writes; i++)
		if (is_missing(line->at[i])) {
			out = put(out, separator.s, separator.end);
			out = numbers != NULL ? put_number(l, numbers, i, out) :
						put_name(l, line, i, out);
		}
	return out;
}

/* The same, and then what is added; where there is nothing before it, without the
 * first separator. */
static char *put_behind(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags,
    struct span separator, char *out, bool first)
{
	size_t n = first ? (size_t)(separator.end - separator.s) : 0;
	char *begin = out;

	out = put_missing(l, line, numbers, separator, out);
	out = put_more(l, l->reads, numbers, flags, separator, out);
	if (n > 0 && out > begin) {
		memmove(begin, begin + n, (size_t)(out - begin) - n);
		out -= n;
	}
	return out;
}

/* Whether no field has been written from begin on. */
static bool nothing_before(struct dialect d, const char *begin, const char *out)
{
	while (out > begin && is_blank_of(d, out[-1]))
		out--;
	return out == begin || (d.format == FORMAT_JSON && out[-1] == '[');
}

/* Where the last field of a line ends. */
static const char *fields_end(const struct layout *l, const struct line *line)
{
	struct span text = trimmed(l->in, line_text(line));

	if (l->in.format != FORMAT_JSON)
		return text.end;
	text.end--; /* the bracket */
	return trimmed(l->in, text).end;
}

char *line_splice(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	struct edit edits[EDITS];
	int n = edits_of(l, line, edits);
	int last = (l->reads < l->writes ? l->reads : l->writes) - 1;
	bool more = l->writes > l->reads || flags != NULL;
	bool whole = n == l->reads; /* none is missing */
	const char *s = line->s, *end = s + line->size, *begin = out;

	for (int k = 0; k < n; k++) {
		struct span f = edits[k].at;
		bool written = edits[k].k < l->writes;

		/* A coordinate that is left out begins with the blanks before
		 * it. In a header they can belong to the name before, and are
		 * written already: then f.s < s. */
		if (f.s > s)
			out = put(out, s, f.s);
		if (written)
			out = numbers != NULL ?
			    put_number(l, numbers, edits[k].k, out) :
			    put(out, f.s, f.end);
		s = f.end;
		if (!whole || edits[k].k != last || !more)
			continue;
		if (l->in.format == FORMAT_CSV && s < end && *s == '"')
			*out++ = *s++;
		out = put_more(l, l->reads, numbers, flags,
		    separator_in(l, line, line_at(line, l->reads - 1)), out);
	}
	if (!whole) {
		const char *behind = fields_end(l, line);
		struct span separator = { &l->in.separator,
			&l->in.separator + 1 };

		if (n > 0)
			separator = separator_in(l, line, edits[n - 1].at);
		if (behind > s) {
			out = put(out, s, behind);
			s = behind;
		}
		out = put_behind(l, line, numbers, flags, separator, out,
		    nothing_before(l->in, begin, out));
	}
	return put(out, s, end);
}

char *line_splice_object(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	const char *name[EDITS];
	int added[EDITS], n_added = 0;
	struct edit edits[EDITS];
	int n = edits_of(l, line, edits);
	const char *s = line->s, *end = s + line->size;
	struct span text = { skip_mark(s, end), end };
	struct json_place p;

	for (int k = 0; k <= FLAGS; k++) {
		bool read = k < l->reads && k != FLAGS;

		if (k == FLAGS ? flags == NULL : k >= l->writes)
			continue;
		if (read && !is_missing(line->at[k]))
			continue;
		name[k] = k == FLAGS ? "flags" :
		    read             ? path_of(l, k) :
				       name_of(l, k);
		if (!read && json_place_find(text, name[k], &p) > 0)
			add_edit(edits, &n, (struct edit){ p.value, k });
		else
			added[n_added++] = k;
	}
	for (int e = 0; e < n; e++) {
		if (edits[e].at.s > s)
			out = put(out, s, edits[e].at.s);
		if (edits[e].k == FLAGS || edits[e].k < l->writes)
			out = put_value(l, numbers, flags, edits[e].k, out);
		s = edits[e].at.end;
	}
	out = put(out, s, fields_end(l, line));
	for (int i = 0; i < n_added; i++)
		out = put_member(l, numbers, flags, added[i], name[added[i]],
		    out);
	return put(out, fields_end(l, line), end);
}
