#include <math.h>
#include <string.h>

#include "field_convert.h"
#include "line.h"

/* Of more blanks than these, one is enough for what is added. */
enum { SEPARATOR_MAX = 64 };

size_t line_room(const struct layout *l, const struct line *r)
{
	size_t line = (size_t)(r->line.end - r->line.s);

	/* n foreign characters, each \u0001, in quotes after a comma: 6 n + 3
	 * for the n + 1 that they and their separator were */
	return (l->in == l->out ? line : 6 * line) +
	    (size_t)l->writes * (NUMBER_MAX + SEPARATOR_MAX) + 192;
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

/* Coordinates from the k-th on, or in a header their names, and the flags, each
 * after a separator. */
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

/* What stands before the last coordinate; behind it where it begins the line. */
static struct span separator(const struct layout *l, const struct line *r)
{
	const char *usual = separator_of(l->in);
	struct span s = { usual, usual + 1 }, last = r->at[l->reads - 1];
	struct span found = { last.s, last.s };

	if (l->in != FORMAT_TEXT)
		return s;
	while (found.s > r->line.s && separates(found.s[-1]))
		found.s--;
	if (found.s == r->line.s) {
		found.s = found.end = last.end;
		while (found.end < r->line.end && separates(*found.end))
			found.end++;
	}
	return found.s < found.end && found.end - found.s <= SEPARATOR_MAX &&
		text_next(found.s, found.end) == found.end ?
	    found :
	    s;
}

/* The coordinates in the order in which they stand in the line. */
static void sort(const struct line *r, int n, int sorted[4])
{
	for (int i = 0; i < n; i++) {
		int k = i;

		for (; k > 0 && r->at[sorted[k - 1]].s > r->at[i].s; k--)
			sorted[k] = sorted[k - 1];
		sorted[k] = i;
	}
}

/* A coordinate that is not written goes with the separator before it; where it
 * is the first field, with the one behind it. */
static struct span whole_field(const struct layout *l, const struct line *r,
    struct span f)
{
	const char *s = r->line.s, *next;

	if (l->in == FORMAT_CSV && f.s > s && f.s[-1] == '"' &&
	    f.end < r->line.end && *f.end == '"') {
		f.s--;
		f.end++;
	}
	const char *before = f.s;

	while (before > s && (is_blank(before[-1]) || before[-1] == ','))
		before--;
	if (before > s && (l->in != FORMAT_JSON || before[-1] != '['))
		return (struct span){ before, f.end };
	next = split_next(l->in, f.end, r->line.end);
	return (struct span){ f.s, next != NULL ? next : f.end };
}

/* The same format out as in: coordinates are replaced where they stand, the
 * names in a header, where v is NULL, stay. */
static char *splice(const struct layout *l, const struct line *r,
    const double v[], const char *flags, char *out)
{
	int sorted[4] = { 0, 1, 2, 3 }, n = l->reads;
	int last = (n < l->writes ? n : l->writes) - 1;
	const char *s = r->line.s;

	if (l->columns.n > 0)
		sort(r, n, sorted);
	for (int k = 0; k < n; k++) {
		int i = sorted[k];
		struct span f = i < l->writes ? r->at[i] :
						whole_field(l, r, r->at[i]);

		if (f.s > s) /* not so behind a name that ends in blanks */
			out = put(out, s, f.s);
		if (i < l->writes)
			out = v != NULL ? put_number(l, r->single, v[i], out) :
					  put(out, f.s, f.end);
		s = f.end;
		if (i != last || (l->writes <= n && flags == NULL))
			continue;
		if (l->in == FORMAT_CSV && s < r->line.end && *s == '"')
			*out++ = *s++;
		out = put_more(l, r->single, n, v, flags, separator(l, r), out);
	}
	return put(out, s, r->line.end);
}

static bool is_coordinate(const struct layout *l, const struct line *r,
    struct span f)
{
	for (int i = 0; i < l->reads; i++)
		if (r->at[i].s >= f.s && r->at[i].end <= f.end)
			return true;
	return false;
}

/* Another format out: the coordinates first, then the other fields. */
static char *convert(const struct layout *l, const struct line *r,
    const double v[], const char *flags, char *out)
{
	const char *usual = separator_of(l->out), *s = r->line.s;
	struct span sep = { usual, usual + 1 };

	if (l->out == FORMAT_JSON)
		*out++ = '[';
	out = put_number(l, r->single, v[0], out);
	out = put_more(l, r->single, 1, v, flags, sep, out);
	s = skip_blanks(s, r->line.end);
	if (l->in == FORMAT_JSON)
		s++;
	/* what a bad line or a binary point holds is not fields */
	if (r->kind == LINE_BAD || l->in == FORMAT_F64 || l->in == FORMAT_F32)
		s = NULL;
	while (s != NULL) {
		struct span f = split_field(l->in, s, r->line.end);

		/* in JSON an empty field of csv holds the others' places */
		if ((f.s < f.end ||
			(l->in == FORMAT_CSV && l->out == FORMAT_JSON)) &&
		    !is_coordinate(l, r, f)) {
			out = put(out, sep.s, sep.end);
			out = foreign_write(l->in, l->out, f, out);
		}
		s = split_next(l->in, f.end, r->line.end);
	}
	if (l->out == FORMAT_JSON)
		*out++ = ']';
	return out;
}

/* A header gets the names of what is added, and loses those of what is not
 * written. */
static char *copy_header(const struct layout *l, const struct line *r,
    char *out)
{
	struct line named = *r;
	const char *end = r->line.end - (r->line.end[-1] == '\r');

	for (int i = 0; i < l->reads; i++) {
		int k = l->columns.n > 0 ? l->columns.field[i] : i;
		struct span *f = &named.at[i];

		/* behind the last field where there are too few */
		if (!split_find(l->in, r->line.s, r->line.end, k, f) &&
		    f->s < f->end)
			*f = (struct span){ end, end };
	}
	return splice(l, &named, NULL, l->flags ? "flags" : NULL, out);
}

/* A comment means nothing in JSON. */
static char *copy(const struct layout *l, const struct line *r, char *out)
{
	const char *end = r->line.end;
	const char *s = skip_blanks(r->line.s, end);

	if (l->in == FORMAT_JSON || l->out == FORMAT_JSON)
		return out;
	if (l->in == FORMAT_CSV && s < end && *s != '#' && l->out == l->in)
		return copy_header(l, r, out);
	return put(out, r->line.s, end);
}

char *line_write(const struct layout *l, const struct line *r,
    const double v[COORDINATES_MAX], const char *flags, char *out)
{
	char *begin = out;

	if (r->kind == LINE_COPY)
		out = copy(l, r, out);
	else if (r->kind == LINE_BAD || l->in != l->out)
		out = convert(l, r, v, flags, out);
	else
		out = splice(l, r, v, flags, out);
	if (r->kind == LINE_COPY && out == begin &&
	    (l->in == FORMAT_JSON || l->out == FORMAT_JSON))
		return out;
	if (r->newline)
		*out++ = '\n';
	return out;
}
