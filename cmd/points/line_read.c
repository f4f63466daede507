#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../json/check.h"
#include "../json/scan.h"
#include "../../core/scene.h"
#include "line.h"
#include "../escape.h"

/* Reads the number in *f, and cuts *f to it: in csv, blanks and quotes may
 * stand around it; in JSON, null is an unknown number. Returns false if *f
 * holds anything else. As no number goes on past what ends a field, number_read
 * may look at all that is readable after it, which is faster. */
static bool field_number(enum format format, struct span *f,
    const char *readable, double *v)
{
	struct span n = *f;
	const char *stop;

	if (format == FORMAT_CSV) {
		n.s = skip_blanks(format, n.s, n.end);
		while (n.end > n.s && is_blank(n.end[-1]))
			n.end--;
		if (n.end - n.s >= 2 && *n.s == '"' && n.end[-1] == '"') {
			n.s++;
			n.end--;
		}
	}
	if (format == FORMAT_JSON && n.end - n.s == 4 &&
	    memcmp(n.s, "null", 4) == 0) {
		*v = (double)NAN;
		return true;
	}
	if (n.s == n.end)
		return false;
	stop = format == FORMAT_JSON ? json_number(n.s, readable, v) :
				       number_read(n.s, readable, v);
	if (stop != n.end)
		return false;
	*f = n;
	return true;
}

/* The name of coordinate i. */
static const char *axis(int i)
{
	static const char *const words[] = { "x", "y", "z", "w" };

	return words[i];
}

/* Says why f is not coordinate i. */
static void bad_field(const struct layout *l, int i, struct span f,
    char reason[REASON_MAX])
{
	size_t n = (size_t)(f.end - f.s);
	char word[ESCAPED_MAX];
	double v;
	const char *end = number_read(f.s, f.end, &v);

	if (l->in == FORMAT_TEXT && n > 0 && (*f.s == '[' || *f.s == '{'))
		snprintf(reason, REASON_MAX,
		    "looks like JSON; say -i json, with one array a line: jq "
		    "-c '.points[]'");
	else if (l->in == FORMAT_JSON && n > 0 && (*f.s == '[' || *f.s == '{'))
		snprintf(reason, REASON_MAX,
		    "%s is not a number; one array a line: jq -c '.points[]'",
		    axis(i));
	else if (n == 0)
		snprintf(reason, REASON_MAX,
		    "%s is missing; %d numbers are wanted", axis(i), l->reads);
	else
		snprintf(reason, REASON_MAX, "%s is '%s'; a number is wanted%s",
		    axis(i), escaped(word, f.s, n),
		    end == NULL ? "" :
			l->in == FORMAT_JSON ?
				  ", as JSON writes it" :
				  ", with a blank or comma behind it");
}

static bool in_range(int i, double v, char reason[REASON_MAX])
{
	if (!(fabs(v) > MAGNITUDE_MAX))
		return true;
	snprintf(reason, REASON_MAX,
	    "%s is beyond 1e150 in magnitude; choose another unit", axis(i));
	return false;
}

/* Reads the first fields of a line of text. */
static bool read_text(const struct layout *l, const char *s, const char *end,
    const char *readable, struct line *line, double v[4],
    char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads; i++) {
		const char *stop = s == end ? NULL :
					      number_read(s, readable, &v[i]);

		if (stop == NULL || !ends_field(stop, end)) {
			bad_field(l, i, field_at(l->in, s, end), reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
		line->at[i] = line_part(line, (struct span){ s, stop });
		s = skip_separator(stop, end);
	}
	return true;
}

/* Reads the field of csv or JSON at s if it is a number and, but for blanks,
 * nothing else. */
static bool plain_field(enum format format, const char *s, const char *end,
    const char *readable, struct span *f, double *v)
{
	f->s = skip_blanks(format, s, end);
	if (f->s == end)
		return false;
	f->end = format == FORMAT_JSON ? json_number(f->s, readable, v) :
					 number_read(f->s, readable, v);
	if (f->end == NULL)
		return false;
	const char *after = skip_blanks(format, f->end, end);

	return format == FORMAT_JSON ? json_skip(f->end, end) == after :
				       after == end || *after == ',';
}

/* Reads the field at s, of csv or JSON, and the number in it. Most are plain
 * numbers: to try that first is faster than to look for where the field ends. */
static bool read_field(enum format format, const char *s, const char *end,
    const char *readable, struct span *field, struct span *number, double *v)
{
	if (plain_field(format, s, end, readable, number, v)) {
		*field = *number;
		return true;
	}
	*field = *number = field_at(format, s, end);
	return field_number(format, number, readable, v);
}

/* Reads the first fields of a line of csv or JSON. */
static bool read_first(const struct layout *l, const char *s, const char *end,
    const char *readable, struct line *line, double v[4],
    char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads; i++) {
		struct span field, number;

		if (!read_field(l->in, s, end, readable, &field, &number,
			&v[i])) {
			bad_field(l, i, field, reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
		line->at[i] = line_part(line, number);
		s = field_next(l->in, field.end, end);
		if (s == NULL)
			s = end;
	}
	return true;
}

/* Reads the fields that --columns names. Each is looked for from the one before, if
 * it stands after that: most often they do, and the line is gone through once. */
static bool read_columns(const struct layout *l, const char *s, const char *end,
    const char *readable, struct line *line, double v[4],
    char reason[REASON_MAX])
{
	const char *from = s;
	int passed = 0; /* fields before from */

	for (int i = 0; i < l->reads; i++) {
		int k = l->columns.field[i];
		struct span f;

		if (k < 0) {
			snprintf(reason, REASON_MAX,
			    "%s is missing: the header has no such column",
			    axis(i));
			return false;
		}
		if (k < passed) {
			from = s;
			passed = 0;
		}
		if (!field_find(l->in, from, end, k - passed, &f)) {
			snprintf(reason, REASON_MAX,
			    "%s is missing: there is no field %d", axis(i),
			    k + 1);
			return false;
		}
		from = f.s;
		passed = k;
		if (!field_number(l->in, &f, readable, &v[i])) {
			bad_field(l, i, f, reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
		line->at[i] = line_part(line, f);
	}
	return true;
}

static bool is_name(struct span f, const char *name)
{
	size_t n = strlen(name);

	if (f.end - f.s >= 2 && *f.s == '"' && f.end[-1] == '"') {
		f.s++;
		f.end--;
	}
	f.s = skip_blanks(FORMAT_CSV, f.s, f.end);
	while (f.end > f.s && is_blank(f.end[-1]))
		f.end--;
	return (size_t)(f.end - f.s) == n && memcmp(f.s, name, n) == 0;
}

/* The number of the field of that name, or -1. */
static int find_name(struct span header, const char *name)
{
	const char *s = header.s;

	for (int k = 0; s != NULL; k++) {
		struct span f = field_at(FORMAT_CSV, s, header.end);

		if (is_name(f, name))
			return k;
		s = field_next(FORMAT_CSV, f.end, header.end);
	}
	return -1;
}

/* Turns the names of --columns into field numbers. */
static bool resolve(struct layout *l, struct span header,
    char reason[REASON_MAX])
{
	for (int i = 0; i < l->columns.n; i++) {
		const char *name = l->columns.name[i];
		int *field = &l->columns.field[i];

		if (name != NULL)
			*field = find_name(header, name);
		if (*field < 0) {
			snprintf(reason, REASON_MAX,
			    "the header has no column '%.60s'", name);
			return false;
		}
		for (int k = 0; k < i; k++)
			if (l->columns.field[k] == *field) {
				snprintf(reason, REASON_MAX,
				    "two coordinates are column %d",
				    *field + 1);
				return false;
			}
	}
	return true;
}

static bool named(const struct columns *c)
{
	for (int i = 0; i < c->n; i++)
		if (c->name[i] != NULL)
			return true;
	return false;
}

/* The first line of csv is a header if none of its coordinates is a number; if
 * only some are, it is a bad line of points. */
static bool is_header(struct layout *l, struct span text, const char *readable)
{
	for (int i = 0; i < l->reads; i++) {
		int k = l->columns.n > 0 ? l->columns.field[i] : i;
		struct span f;
		double v;

		if (field_find(FORMAT_CSV, text.s, text.end, k, &f) &&
		    field_number(FORMAT_CSV, &f, readable, &v))
			return false;
	}
	return true;
}

/* Returns false if the first line of csv is one of points, and no header. */
static bool take_header(struct layout *l, struct span text,
    const char *readable, struct line *line, char reason[REASON_MAX])
{
	bool wanted = named(&l->columns);

	if (wanted && !resolve(l, text, reason))
		line->kind = LINE_BAD;
	return wanted || is_header(l, text, readable);
}

/* Whether the array whose opening bracket is before s is closed and nothing
 * comes after it. Its elements need not be JSON. */
static bool is_closed(const char *s, const char *end)
{
	s = json_skip(s, end);
	while (s < end && *s == ',')
		s = json_skip(s + 1, end);
	return s < end && *s == ']' &&
	    skip_blanks(FORMAT_JSON, s + 1, end) == end;
}

/* Whether all of the line is one JSON array. Up to done it has been read; if
 * those were numbers alone, and only the closing bracket comes after them, the
 * line need not be looked at again. */
static bool check_array(struct span text, const char *done,
    char reason[REASON_MAX])
{
	const char *s = skip_blanks(FORMAT_JSON, done, text.end);
	struct json_error e;
	char word[ESCAPED_MAX];

	if (s < text.end && *s == ']' &&
	    skip_blanks(FORMAT_JSON, s + 1, text.end) == text.end)
		return true;
	if (json_check(JSON_LINE, text.s, text.end, &e))
		return true;
	s = skip_blanks(FORMAT_JSON, text.s, text.end);
	if (!is_closed(s + 1, text.end))
		snprintf(reason, REASON_MAX,
		    "the array does not end with the line; one array a line: "
		    "jq -c '.points[]'");
	else
		snprintf(reason, REASON_MAX, "no JSON from '%s' on",
		    escaped(word, e.at, (size_t)(text.end - e.at)));
	return false;
}

void line_read(struct layout *l, struct span text, const char *readable,
    bool *header, struct line *line, double v[4], char reason[REASON_MAX])
{
	const char *s = skip_blanks(l->in, text.s, text.end);
	bool ok;

	line->kind = LINE_COPY;
	line->s = text.s;
	line->size = (uint32_t)(text.end - text.s);
	if (s == text.end || *s == '#')
		return;
	if (l->in == FORMAT_CSV) {
		s = text.s;
		if (*header && text.end - s >= 3 &&
		    memcmp(s, "\xef\xbb\xbf", 3) == 0)
			s += 3; /* a byte order mark */
		bool taken = *header &&
		    take_header(l, (struct span){ s, text.end }, readable, line,
			reason);

		*header = false;
		if (taken)
			return;
	}
	if (l->in == FORMAT_JSON) {
		if (*s != '[') {
			snprintf(reason, REASON_MAX,
			    "is not a JSON array; one array a line: jq -c "
			    "'.points[]'");
			line->kind = LINE_BAD;
			return;
		}
		s++;
	}
	if (l->columns.n > 0)
		ok = read_columns(l, s, text.end, readable, line, v, reason);
	else if (l->in == FORMAT_TEXT)
		ok = read_text(l, s, text.end, readable, line, v, reason);
	else
		ok = read_first(l, s, text.end, readable, line, v, reason);
	if (ok && l->in == FORMAT_JSON)
		ok = check_array(text,
		    l->columns.n > 0 ? s : line_at(line, l->reads - 1).end,
		    reason);
	line->kind = ok ? LINE_POINT : LINE_BAD;
}
