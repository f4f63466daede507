#include <math.h>
#include <string.h>

#include "field_convert.h"
#include "line.h"

/* A separator that is longer, in bytes, is not repeated before coordinates that
 * are added to the line; one blank does. */
enum { SEPARATOR_MAX = 64 };

/* Room for the separator before the flags, two quotes, as many bytes as are copied
 * of a word, two brackets and the newline. What a number touches behind its text is
 * in the room of NUMBER_MAX that each has. */
enum { FLAGS_ROOM = SEPARATOR_MAX + 2 + WORD_MAX + 2 + 1 };

size_t lines_room(const struct layout *l, size_t lines, size_t bytes)
{
	/* In another format a byte of a field may become six, as \u0001 in
	 * JSON. Six for the separator after it are enough for a comma and two
	 * quotes. */
	return (l->in == l->out ? bytes : 6 * bytes) +
	    lines *
	    ((size_t)l->writes * (NUMBER_MAX + SEPARATOR_MAX) + FLAGS_ROOM);
}

static char *put(char *out, const char *s, const char *end)
{
	size_t n = (size_t)(end - s);

	if (n == 1) /* the usual separator */
		*out = *s;
	else
		memcpy(out, s, n);
	return out + n;
}

static inline char *put_number(const struct layout *l,
    const struct numbers *numbers, int k, char *out)
{
	static const char null[] = "null";
	double v = numbers->v[(size_t)k * numbers->step];

	if (l->out == FORMAT_JSON && isnan(v))
		return put(out, null, null + 4);
	return number_put(out, &numbers->text[(size_t)k * numbers->text_step],
	    v, l->single, l->style[k]);
}

static const char *separator_of(enum format format)
{
	return format == FORMAT_TEXT ? " " : ",";
}

/* Writes the coordinates from the k-th on, or, for a header, where numbers is
 * NULL, their names; then flags unless it is NULL. A separator goes before each. */
static char *put_more(const struct layout *l, int k,
    const struct numbers *numbers, const struct word *flags,
    struct span separator, char *out)
{
	static const char *const names[] = { "x", "y", "z", "w" };
	static const char *const ray[] = { "x", "y", "z", "dx", "dy", "dz" };

	for (; k < l->writes; k++) {
		const char *name = l->writes > 4 ? ray[k] : names[k];

		out = put(out, separator.s, separator.end);
		out = numbers != NULL ? put_number(l, numbers, k, out) :
					put(out, name, name + strlen(name));
	}
	if (flags != NULL) {
		out = put(out, separator.s, separator.end);
		if (l->out == FORMAT_JSON)
			*out++ = '"';
		memcpy(out, flags->s, WORD_MAX);
		out += flags->size;
		if (l->out == FORMAT_JSON)
			*out++ = '"';
	}
	return out;
}

static bool separates(char c)
{
	return is_blank(c) || c == ',';
}

/* The separator to write before numbers that are added to the line. In text it
 * is the one that stands before the last coordinate, or after it if that is the
 * first field; but the usual one if what stands there has several commas or is
 * too long. Other formats have one separator only. */
static struct span separator_in(const struct layout *l, const struct line *line)
{
	const char *usual = separator_of(l->in);
	struct span one = { usual, usual + 1 }, text = line_text(line);
	struct span last = line_at(line, l->reads - 1);
	struct span found = { last.s, last.s };

	if (l->in != FORMAT_TEXT)
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

/* Numbers the coordinates in the order in which they stand in the line. */
static void sort(const struct line *line, int n, int sorted[4])
{
	for (int i = 0; i < n; i++) {
		int k = i;

		for (; k > 0 && line->at[sorted[k - 1]].from > line->at[i].from;
		     k--)
			sorted[k] = sorted[k - 1];
		sorted[k] = i;
	}
}

/* What has to go if the coordinate at f is not written: also its quotes, and
 * the separator before it, or after it if it is the first field. */
static struct span whole_field(const struct layout *l, const struct line *line,
    struct span f)
{
	const struct span text = line_text(line);
	const char *s = text.s, *next;

	if (l->in == FORMAT_CSV && f.s > s && f.s[-1] == '"' &&
	    f.end < text.end && *f.end == '"') {
		f.s--;
		f.end++;
	}
	const char *before = f.s;

	while (before > s && (is_blank(before[-1]) || before[-1] == ','))
		before--;
	if (before > s && (l->in != FORMAT_JSON || before[-1] != '['))
		return (struct span){ before, f.end };
	next = field_next(l->in, f.end, text.end);
	return (struct span){ f.s, next != NULL ? next : f.end };
}

/* The format out is that in: coordinates are replaced where they stand. If
 * numbers is NULL the line is a header, whose names stay. */
static char *splice(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	int sorted[4] = { 0, 1, 2, 3 }, n = l->reads;
	int last = (n < l->writes ? n : l->writes) - 1;
	const char *s = line->s, *end = s + line->size;

	if (l->columns.n > 0)
		sort(line, n, sorted);
	for (int k = 0; k < n; k++) {
		int i = sorted[k];
		struct span f = i < l->writes ?
		    line_at(line, i) :
		    whole_field(l, line, line_at(line, i));

		/* A coordinate that is left out begins with the blanks before
		 * it. In a header they can belong to the name before, and are
		 * written already: then f.s < s. */
		if (f.s > s)
			out = put(out, s, f.s);
		if (i < l->writes)
			out = numbers != NULL ? put_number(l, numbers, i, out) :
						put(out, f.s, f.end);
		s = f.end;
		if (i != last || (l->writes <= n && flags == NULL))
			continue;
		if (l->in == FORMAT_CSV && s < end && *s == '"')
			*out++ = *s++;
		out = put_more(l, n, numbers, flags, separator_in(l, line),
		    out);
	}
	return put(out, s, end);
}

static bool is_coordinate(const struct layout *l, const struct line *line,
    struct span f)
{
	struct part p = line_part(line, f);

	for (int i = 0; i < l->reads; i++)
		if (line->at[i].from >= p.from && line->at[i].to <= p.to)
			return true;
	return false;
}

/* Where the first field begins that may be no coordinate, or NULL: of bad lines
 * no field is kept, and binary points have none. Unless there are --columns it is
 * the one after the coordinates; in csv the last of these may end with a quote. */
static const char *first_kept(const struct layout *l, const struct line *line)
{
	struct span text = line_text(line);

	if (line->kind == LINE_BAD || is_binary(l->in))
		return NULL;
	if (l->columns.n == 0) {
		const char *last = line_at(line, l->reads - 1).end;

		if (last == text.end || *last != '"')
			return field_next(l->in, last, text.end);
	}
	return skip_blanks(l->in, text.s, text.end) + (l->in == FORMAT_JSON);
}

char *line_rest(const struct layout *l, const struct line *line, char *out)
{
	const char *usual = separator_of(l->out);
	const char *s = first_kept(l, line), *end = line->s + line->size;

	if (s != NULL && l->in == FORMAT_TEXT && l->out == FORMAT_TEXT &&
	    l->columns.n == 0) {
		while (end > s && is_blank(end[-1]))
			end--;
		if (s < end)
			out = put(put(out, usual, usual + 1), s, end);
		return out;
	}
	while (s != NULL) {
		struct span f = field_at(l->in, s, end);

		/* csv's empty fields become "" in JSON, so that the fields
		 * after them keep their place in the array */
		if ((f.s < f.end ||
			(l->in == FORMAT_CSV && l->out == FORMAT_JSON)) &&
		    !is_coordinate(l, line, f)) {
			out = put(out, usual, usual + 1);
			out = field_convert(l->in, l->out, f, out);
		}
		s = field_next(l->in, f.end, end);
	}
	return out;
}

/* The format out is another: coordinates and flags go first, then all other
 * fields. */
static char *convert(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	const char *usual = separator_of(l->out);
	struct span sep = { usual, usual + 1 };

	if (l->out == FORMAT_JSON)
		*out++ = '[';
	out = put_number(l, numbers, 0, out);
	out = put_more(l, 1, numbers, flags, sep, out);
	out = line_rest(l, line, out);
	if (l->out == FORMAT_JSON)
		*out++ = ']';
	return out;
}

/* A csv header gets names for the columns that are added, and loses those of
 * coordinates that are not written. */
static char *copy_header(const struct layout *l, const struct line *line,
    char *out)
{
	static const struct word flags = { "flags", 5 };
	struct line named = *line;
	struct span text = line_text(line);
	const char *end = text.end - (text.end[-1] == '\r');

	for (int i = 0; i < l->reads; i++) {
		int k = l->columns.n > 0 ? l->columns.field[i] : i;
		struct span f = { end, end };

		/* a missing name's place is the end of the line */
		if (!field_find(l->in, text.s, text.end, k, &f) && f.s < f.end)
			f = (struct span){ end, end };
		named.at[i] = line_part(line, f);
	}
	return splice(l, &named, NULL, l->flags ? &flags : NULL, out);
}

/* A blank line, a comment or a header. JSON has none of them. */
static char *copy(const struct layout *l, const struct line *line, char *out)
{
	const char *end = line->s + line->size;
	const char *s = skip_blanks(l->in, line->s, end);

	if (l->in == FORMAT_JSON || l->out == FORMAT_JSON)
		return out;
	if (l->in == FORMAT_CSV && s < end && *s != '#' && l->out == l->in)
		return copy_header(l, line, out);
	return put(out, line->s, end);
}

char *line_write(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	char *begin = out;

	if (line->kind == LINE_COPY)
		out = copy(l, line, out);
	else if (line->kind == LINE_BAD || l->in != l->out)
		out = convert(l, line, numbers, flags, out);
	else
		out = splice(l, line, numbers, flags, out);
	if (line->kind == LINE_COPY && out == begin &&
	    (l->in == FORMAT_JSON || l->out == FORMAT_JSON))
		return out;
	if (line->newline)
		*out++ = '\n';
	return out;
}
