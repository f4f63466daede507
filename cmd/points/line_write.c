#include <math.h>
#include <string.h>

#include "field_convert.h"
#include "line.h"

/* A separator of more bytes is not repeated before what is added to a line: one
 * blank is enough. */
enum { SEPARATOR_MAX = 64 };

/* Room for the flags with their separator, quotes, brackets and the newline. */
enum { FLAGS_ROOM = 192 };

size_t line_room(const struct layout *l, const struct line *line)
{
	size_t n = (size_t)(line->text.end - line->text.s);

	/* In another format a character may become six, as \u0001 in JSON; the
	 * three of a comma and quotes around a field are not more than six for
	 * the separator that it had. */
	return (l->in == l->out ? n : 6 * n) +
	    (size_t)l->writes * (NUMBER_MAX + SEPARATOR_MAX) + FLAGS_ROOM;
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

static char *put_number(const struct layout *l, bool single, double v,
    char *out)
{
	if (l->out == FORMAT_JSON && isnan(v))
		return put(out, "null", &"null"[4]);
	return single ? number_write_float(out, (float)v, l->style) :
			number_write(out, v, l->style);
}

static const char *separator_of(enum format format)
{
	return format == FORMAT_TEXT ? " " : ",";
}

/* Coordinates from the k-th on, or where v is NULL their names, as in a header;
 * then the flags unless they are NULL. A separator goes before each. */
static char *put_more(const struct layout *l, bool single, int k,
    const double v[], const char *flags, struct span separator, char *out)
{
	static const char *const names[] = { "x", "y", "z", "w" };
	static const char *const ray[] = { "x", "y", "z", "dx", "dy", "dz" };

	for (; k < l->writes; k++) {
		const char *name = l->writes > 4 ? ray[k] : names[k];

		out = put(out, separator.s, separator.end);
		out = v != NULL ? put_number(l, single, v[k], out) :
				  put(out, name, name + strlen(name));
	}
	if (flags != NULL) {
		out = put(out, separator.s, separator.end);
		if (l->out == FORMAT_JSON)
			*out++ = '"';
		out = put(out, flags, flags + strlen(flags));
		if (l->out == FORMAT_JSON)
			*out++ = '"';
	}
	return out;
}

static bool separates(char c)
{
	return is_blank(c) || c == ',';
}

/* What is to go before numbers that are added to a line of text: the blanks and
 * comma that stand before the last coordinate, or behind it where it is the
 * first field; the usual separator where those are not just one separator, or
 * too long. Other formats have one separator only. */
static struct span separator_in(const struct layout *l, const struct line *line)
{
	const char *usual = separator_of(l->in);
	struct span one = { usual, usual + 1 }, last = line->at[l->reads - 1];
	struct span found = { last.s, last.s };

	if (l->in != FORMAT_TEXT)
		return one;
	while (found.s > line->text.s && separates(found.s[-1]))
		found.s--;
	if (found.s == line->text.s) {
		found.s = found.end = last.end;
		while (found.end < line->text.end && separates(*found.end))
			found.end++;
	}
	return found.s < found.end && found.end - found.s <= SEPARATOR_MAX &&
		text_next(found.s, found.end) == found.end ?
	    found :
	    one;
}

/* Numbers the coordinates in the order in which they stand in the line. */
static void sort(const struct line *line, int n, int sorted[4])
{
	for (int i = 0; i < n; i++) {
		int k = i;

		for (; k > 0 && line->at[sorted[k - 1]].s > line->at[i].s; k--)
			sorted[k] = sorted[k - 1];
		sorted[k] = i;
	}
}

/* What is left out where a coordinate at f is not written: its quotes and the
 * separator before it; where it is the first field, the one behind it. */
static struct span whole_field(const struct layout *l, const struct line *line,
    struct span f)
{
	const char *s = line->text.s, *next;

	if (l->in == FORMAT_CSV && f.s > s && f.s[-1] == '"' &&
	    f.end < line->text.end && *f.end == '"') {
		f.s--;
		f.end++;
	}
	const char *before = f.s;

	while (before > s && (is_blank(before[-1]) || before[-1] == ','))
		before--;
	if (before > s && (l->in != FORMAT_JSON || before[-1] != '['))
		return (struct span){ before, f.end };
	next = split_next(l->in, f.end, line->text.end);
	return (struct span){ f.s, next != NULL ? next : f.end };
}

/* The same format out as in: coordinates are replaced where they stand. Where v
 * is NULL the line is a header, whose names stay. */
static char *splice(const struct layout *l, const struct line *line,
    const double v[], const char *flags, char *out)
{
	int sorted[4] = { 0, 1, 2, 3 }, n = l->reads;
	int last = (n < l->writes ? n : l->writes) - 1;
	const char *s = line->text.s;

	if (l->columns.n > 0)
		sort(line, n, sorted);
	for (int k = 0; k < n; k++) {
		int i = sorted[k];
		struct span f = i < l->writes ?
		    line->at[i] :
		    whole_field(l, line, line->at[i]);

		/* what is left out takes the blanks before it along, and
		 * there a name of a header may end only behind them */
		if (f.s > s)
			out = put(out, s, f.s);
		if (i < l->writes)
			out = v != NULL ?
			    put_number(l, line->single, v[i], out) :
			    put(out, f.s, f.end);
		s = f.end;
		if (i != last || (l->writes <= n && flags == NULL))
			continue;
		if (l->in == FORMAT_CSV && s < line->text.end && *s == '"')
			*out++ = *s++;
		out = put_more(l, line->single, n, v, flags,
		    separator_in(l, line), out);
	}
	return put(out, s, line->text.end);
}

static bool is_coordinate(const struct layout *l, const struct line *line,
    struct span f)
{
	for (int i = 0; i < l->reads; i++)
		if (line->at[i].s >= f.s && line->at[i].end <= f.end)
			return true;
	return false;
}

/* Another format out: coordinates and flags first, then the other fields. */
static char *convert(const struct layout *l, const struct line *line,
    const double v[], const char *flags, char *out)
{
	const char *usual = separator_of(l->out), *s = line->text.s;
	struct span sep = { usual, usual + 1 };

	if (l->out == FORMAT_JSON)
		*out++ = '[';
	out = put_number(l, line->single, v[0], out);
	out = put_more(l, line->single, 1, v, flags, sep, out);
	s = skip_blanks(s, line->text.end);
	if (l->in == FORMAT_JSON)
		s++;
	/* bad lines and binary points have no fields to go on with */
	if (line->kind == LINE_BAD || is_binary(l->in))
		s = NULL;
	while (s != NULL) {
		struct span f = split_field(l->in, s, line->text.end);

		/* csv's empty fields are "" in JSON, so that those behind them
		 * keep their place in the array */
		if ((f.s < f.end ||
			(l->in == FORMAT_CSV && l->out == FORMAT_JSON)) &&
		    !is_coordinate(l, line, f)) {
			out = put(out, sep.s, sep.end);
			out = foreign_write(l->in, l->out, f, out);
		}
		s = split_next(l->in, f.end, line->text.end);
	}
	if (l->out == FORMAT_JSON)
		*out++ = ']';
	return out;
}

/* A csv header gets names for the columns that are added, and loses those of
 * coordinates that are not written. */
static char *copy_header(const struct layout *l, const struct line *line,
    char *out)
{
	struct line named = *line;
	const char *end = line->text.end - (line->text.end[-1] == '\r');

	for (int i = 0; i < l->reads; i++) {
		int k = l->columns.n > 0 ? l->columns.field[i] : i;
		struct span *f = &named.at[i];

		/* the place of a missing name is behind the last one */
		if (!split_find(l->in, line->text.s, line->text.end, k, f) &&
		    f->s < f->end)
			*f = (struct span){ end, end };
	}
	return splice(l, &named, NULL, l->flags ? "flags" : NULL, out);
}

/* A blank line, a comment or a header. JSON has none of them. */
static char *copy(const struct layout *l, const struct line *line, char *out)
{
	const char *end = line->text.end;
	const char *s = skip_blanks(line->text.s, end);

	if (l->in == FORMAT_JSON || l->out == FORMAT_JSON)
		return out;
	if (l->in == FORMAT_CSV && s < end && *s != '#' && l->out == l->in)
		return copy_header(l, line, out);
	return put(out, line->text.s, end);
}

char *line_write(const struct layout *l, const struct line *line,
    const double v[COORDINATES_MAX], const char *flags, char *out)
{
	char *begin = out;

	if (line->kind == LINE_COPY)
		out = copy(l, line, out);
	else if (line->kind == LINE_BAD || l->in != l->out)
		out = convert(l, line, v, flags, out);
	else
		out = splice(l, line, v, flags, out);
	if (line->kind == LINE_COPY && out == begin &&
	    (l->in == FORMAT_JSON || l->out == FORMAT_JSON))
		return out;
	if (line->newline)
		*out++ = '\n';
	return out;
}
