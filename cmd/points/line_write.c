#include <math.h>
#include <string.h>

#include "field_convert.h"
#include "header.h"
#include "line_bad.h"
#include "line_object.h"

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
	return (same_dialect(l->in, l->out) ? bytes : 6 * bytes) +
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

	if (l->out.format == FORMAT_JSON && isnan(v))
		return put(out, null, null + 4);
	return number_put(out, &numbers->text[(size_t)k * numbers->text_step],
	    v, l->single, l->style[k]);
}

/* What coordinate k that is written is called. */
static const char *name_of(const struct layout *l, int k)
{
	static const char *const names[] = { "x", "y", "z", "w" };
	static const char *const ray[] = { "x", "y", "z", "dx", "dy", "dz" };

	return l->writes > 4 ? ray[k] : names[k];
}

static char *put_word(struct dialect d, const struct word *flags, char *out)
{
	if (d.format == FORMAT_JSON)
		*out++ = '"';
	memcpy(out, flags->s, WORD_MAX);
	out += flags->size;
	if (d.format == FORMAT_JSON)
		*out++ = '"';
	return out;
}

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
 * is the one that stands before the last coordinate, or after it if that is the
 * first field; but the usual one if what stands there has several commas or is
 * too long. Other formats have one separator only. */
static struct span separator_in(const struct layout *l, const struct line *line)
{
	struct span one = { &l->in.separator, &l->in.separator + 1 };
	struct span text = line_text(line);
	struct span last = line_at(line, l->reads - 1);
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
		json_place_find(trimmed(l->in, text), path_of(l, i), &p);
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

enum { FLAGS = COORDINATES_MAX, EDITS = COORDINATES_MAX + 1 };

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

/* The name of coordinate k in a header, or what it is called where that has none. */
static char *put_name(const struct layout *l, const struct line *header, int k,
    char *out)
{
	const char *name = name_of(l, k);

	if (k < l->reads && header->at[k].from < header->at[k].to)
		return field_convert(l->in, l->out, line_at(header, k), out);
	return put(out, name, name + strlen(name));
}

/* Writes the coordinates that a bad line lacks, or their names. */
static char *put_missing(const struct layout *l, const struct line *line,
    const struct numbers *numbers, char *out)
{
	for (int i = 0; i < l->reads && i < l->writes; i++)
		if (is_missing(line->at[i])) {
			*out++ = l->in.separator;
			out = numbers != NULL ?
			    put_number(l, numbers, i, out) :
			    put_name(l, line, i, out);
		}
	return out;
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

/* The format out is that in: coordinates are replaced where they stand, and what is
 * added follows the last of them. If numbers is NULL the line is a header, whose
 * names stay. */
static char *splice(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	struct edit edits[EDITS];
	int n = edits_of(l, line, edits);
	int last = (l->reads < l->writes ? l->reads : l->writes) - 1;
	bool more = l->writes > l->reads || flags != NULL;
	bool whole = n == l->reads; /* none is missing */
	const char *s = line->s, *end = s + line->size;

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
		    separator_in(l, line), out);
	}
	if (!whole) {
		const char *behind = fields_end(l, line);
		struct span usual = { &l->in.separator, &l->in.separator + 1 };

		if (behind > s) {
			out = put(out, s, behind);
			s = behind;
		}
		out = put_missing(l, line, numbers, out);
		out = put_more(l, l->reads, numbers, flags, usual, out);
	}
	return put(out, s, end);
}

static char *put_value(const struct layout *l, const struct numbers *numbers,
    const struct word *flags, int k, char *out)
{
	return k == FLAGS ? put_word(l->out, flags, out) :
			    put_number(l, numbers, k, out);
}

/* A member of its own, number k or the flags, behind those that there are. */
static char *put_member(const struct layout *l, const struct numbers *numbers,
    const struct word *flags, int k, const char *name, char *out)
{
	if (out[-1] != '{')
		*out++ = ',';
	*out++ = '"';
	out = put(out, name, name + strlen(name));
	*out++ = '"';
	*out++ = ':';
	return put_value(l, numbers, flags, k, out);
}

/* The same of a JSON object, where what is added takes the place of a member of its
 * name, or becomes one. */
static char *splice_object(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	const char *name[EDITS];
	int added[EDITS], n_added = 0;
	struct edit edits[EDITS];
	int n = edits_of(l, line, edits);
	struct span text = trimmed(l->in, line_text(line));
	const char *s = line->s, *end = s + line->size;
	struct json_place p;

	for (int k = 0; k <= FLAGS; k++) {
		bool read = k < l->reads && k != FLAGS;

		if (k == FLAGS ? flags == NULL : k >= l->writes)
			continue;
		if (read && !is_missing(line->at[k]))
			continue;
		name[k] = k == FLAGS ? "flags" :
		    read	     ? path_of(l, k) :
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

static bool is_coordinate(const struct layout *l, const struct line *line,
    struct span f)
{
	struct part p = line_part(line, f);

	for (int i = 0; i < l->reads; i++)
		if (!is_missing(line->at[i]) && line->at[i].from >= p.from &&
		    line->at[i].to <= p.to)
			return true;
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

	if (line->kind == LINE_LOST || line->object ||
	    is_binary(l->in.format))
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
	const struct word *flags = l->flags ? &word : NULL;
	struct line named = *line;
	struct span text = line_text(line);

	text.s = skip_mark(text.s, text.end);
	text.end -= text.end[-1] == '\r';
	header_places(l, text, &named);
	if (same_dialect(l->in, l->out))
		return splice(l, &named, NULL, flags, out);
	if (l->out.format == FORMAT_TEXT)
		out = put(out, "# ", "# " + 2);
	return convert(l, &named, NULL, flags, out);
}

/* A blank line, a comment or a header. JSON has none of them. */
static char *copy(const struct layout *l, const struct line *line, char *out)
{
	const char *end = line->s + line->size;
	const char *s = skip_blanks(l->in, skip_mark(line->s, end), end);

	if (l->in.format == FORMAT_JSON || l->out.format == FORMAT_JSON)
		return out;
	if (l->in.format == FORMAT_CSV && s < end && *s != '#')
		return copy_header(l, line, out);
	return put(out, line->s, end);
}

char *line_write(const struct layout *l, const struct line *line,
    const struct numbers *numbers, const struct word *flags, char *out)
{
	char *begin = out;

	if (line->kind == LINE_COPY)
		out = copy(l, line, out);
	else if (line->kind == LINE_LOST)
		out = put_alone(l, line, numbers, flags, out);
	else if (!same_dialect(l->in, l->out))
		out = convert(l, line, numbers, flags, out);
	else if (line->object)
		out = splice_object(l, line, numbers, flags, out);
	else
		out = splice(l, line, numbers, flags, out);
	if (line->kind == LINE_COPY && out == begin &&
	    (l->in.format == FORMAT_JSON || l->out.format == FORMAT_JSON))
		return out;
	if (line->newline)
		*out++ = '\n';
	return out;
}
