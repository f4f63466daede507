/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "header.h"
#include "line_put.h"
#include "line_splice.h"

/* Room for the separator before the flags, two quotes, as many bytes as are copied
 * of a word, two brackets and the newline. What a number touches behind its text is
 * in the room of NUMBER_MAX that each has. */
enum { FLAGS_ROOM = SEPARATOR_MAX + 2 + WORD_MAX + 2 + 1 };

size_t lines_room(const struct layout *l, size_t lines, size_t bytes)
{
	/* In another format a byte of a field may become six, as \u0001 in
	 * JSON. Six for the separator after it are enough for a comma and two
	 * quotes. */
	return (same_dialect(l->in, l->out) ? bytes : 6 * bytes) +
	    lines *
	    ((size_t)l->writes * (NUMBER_MAX + SEPARATOR_MAX) + FLAGS_ROOM);
}

/* Whether the field holds a coordinate, with its quotes, or is part of one, as of one
 * with a decimal comma. */
static bool is_coordinate(const struct layout *l, const struct line *line,
    struct span f)
{
	struct part p = line_part(line, f);

	for (int i = 0; i < l->reads; i++) {
		struct part at = line->at[i];

		if (!is_missing(at) &&
		    ((at.from >= p.from && at.to <= p.to) ||
			(p.from >= at.from && p.to <= at.to)))
			return true;
	}
	return false;
}

/* Where the first field begins that may be no coordinate, or NULL: binary points
 * have none, what is a member of an object is no field of another format, and of what
 * can't be taken apart none is kept. Unless there are --columns it is
 * the one after the coordinates; in csv the last of these may end with a quote. */
static const char *first_kept(const struct layout *l, const struct line *line)
{
	struct span text = line_text(line);
	const char *s = skip_mark(text.s, text.end);

	if (line->kind == LINE_LOST || line->object || is_binary(l->in.format))
		return NULL;
	if (l->columns.n == 0 && line->kind == LINE_POINT) {
		const char *last = line_at(line, l->reads - 1).end;

		if (last == text.end || *last != '"')
			return field_next(l->in, last, text.end);
	}
	return skip_blanks(l->in, s, text.end) + (l->in.format == FORMAT_JSON);
}

char *line_rest(const struct layout *l, const struct line *line, char *out)
{
	const char *s = first_kept(l, line), *end = line->s + line->size;

	if (s != NULL && line->kind == LINE_POINT && l->columns.n == 0 &&
	    l->in.format == FORMAT_TEXT && l->out.format == FORMAT_TEXT) {
		while (end > s && is_blank(end[-1]))
			end--;
		if (s < end) {
			*out++ = ' ';
			out = put(out, s, end);
		}
		return out;
	}
	while (s != NULL) {
		struct span f = field_at(l->in, s, end);

		/* csv's empty fields become "" in JSON, so that the fields
		 * after them keep their place in the array */
		if ((f.s < f.end ||
			(l->in.format == FORMAT_CSV &&
			    l->out.format != FORMAT_TEXT)) &&
		    !is_coordinate(l, line, f)) {
			*out++ = l->out.separator;
			out = field_convert(l->in, l->out, f, out);
		}
		s = field_next(l->in, f.end, end);
	}
	return out;
}

/* The format out is another: coordinates and flags go first, then all other
 * fields. Where numbers is NULL the line is a header. */
static char *convert(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	bool json = l->out.format == FORMAT_JSON;

	if (json)
		*out++ = '[';
	for (int k = 0; k < l->writes; k++) {
		if (k > 0)
			*out++ = l->out.separator;
		out = numbers != NULL ? put_number(l, numbers, k, out) :
					put_name(l, line, k, out);
	}
	if (flags != NULL) {
		*out++ = l->out.separator;
		out = put_word(l->out, flags, out);
	}
	out = line_rest(l, line, out);
	if (json)
		*out++ = ']';
	return out;
}

/* What can't be taken apart becomes the coordinates alone, by their names where it
 * would be an object. */
static char *put_alone(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	if (l->out.format != FORMAT_JSON || l->in.format != FORMAT_JSON ||
	    !line->object)
		return convert(l, line, numbers, flags, out);
	*out++ = '{';
	for (int k = 0; k < l->writes; k++)
		out = put_member(l, numbers, flags, k, name_of(l, k), out);
	if (flags != NULL)
		out = put_member(l, numbers, flags, FLAGS, "flags", out);
	*out++ = '}';
	return out;
}

/* A csv header gets names for the columns that are added, and loses those of
 * coordinates that are not written. In text it is a comment. */
static char *copy_header(const struct layout *l, const struct line *line,
    char *out)
{
	static const struct word word = { "flags", 5 };
	static const char comment[] = "# ";
	const struct word *flags = l->flags ? &word : NULL;
	struct line named = *line;

	header_places(l, line_text(line), &named);
	if (same_dialect(l->in, l->out))
		return line_splice(l, &named, NULL, flags, out);
	if (l->out.format == FORMAT_TEXT)
		out = put(out, comment, comment + 2);
	return convert(l, &named, NULL, flags, out);
}

/* What is no point. JSON has none of that. */
static char *copy(const struct layout *l, const struct line *line, char *out)
{
	if (l->in.format == FORMAT_JSON || l->out.format == FORMAT_JSON)
		return out;
	if (line->kind == LINE_HEADER)
		return copy_header(l, line, out);
	return put(out, line->s, line->s + line->size);
}

char *line_write(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	bool copied = line->kind == LINE_COPY || line->kind == LINE_HEADER;
	char *begin = out;

	if (copied)
		out = copy(l, line, out);
	else if (line->kind == LINE_LOST)
		out = put_alone(l, line, numbers, flags, out);
	else if (!same_dialect(l->in, l->out))
		out = convert(l, line, numbers, flags, out);
	else if (line->object)
		out = line_splice_object(l, line, numbers, flags, out);
	else
		out = line_splice(l, line, numbers, flags, out);
	if (copied && out == begin &&
	    (l->in.format == FORMAT_JSON || l->out.format == FORMAT_JSON))
		return out;
	if (line->newline)
		*out++ = '\n';
	return out;
}
