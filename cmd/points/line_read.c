#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../json/check.h"
#include "../json/scan.h"
#include "../../core/scene.h"
#include "line.h"
#include "../escape.h"

/* Reads the number that *f holds, and cuts *f to it: in csv, blanks and quotes
 * may be around it; in JSON, null is an unknown one. */
static bool field_number(enum format format, struct span *f, double *v)
{
	struct span n = *f;
	const char *stop;

	if (format == FORMAT_CSV) {
		n.s = skip_blanks(n.s, n.end);
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
	stop = format == FORMAT_JSON ? json_number(n.s, n.end, v) :
				       number_read(n.s, n.end, v);
	if (stop != n.end)
		return false;
	*f = n;
	return true;
}

static const char *order(int i)
{
	static const char *const words[] = { "x", "y", "z", "w" };

	return words[i];
}

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
		    order(i));
	else if (n == 0)
		snprintf(reason, REASON_MAX,
		    "%s is missing; %d numbers are wanted", order(i), l->reads);
	else
		snprintf(reason, REASON_MAX, "%s is '%s'; a number is wanted%s",
		    order(i), escaped(word, f.s, n),
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
	    "%s is beyond 1e150 in magnitude; choose another unit", order(i));
	return false;
}

/* The first fields of text. A number does not go on past a newline; so it is
 * read with all that is readable behind it, which is faster. */
static bool read_text(const struct layout *l, const char *s, const char *end,
    const char *readable, struct line *r, double v[4], char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads; i++) {
		const char *stop = s == end ? NULL :
					      number_read(s, readable, &v[i]);

		if (stop == NULL || !ends_field(stop, end)) {
			bad_field(l, i, split_field(l->in, s, end), reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
		r->at[i] = (struct span){ s, stop };
		s = text_next(stop, end);
	}
	return true;
}

/* Whether an element of JSON is a number and nothing else. */
static bool element_number(const char *s, const char *end, const char *readable,
    struct span *f, double *v)
{
	f->s = skip_blanks(s, end);
	if (f->s == end)
		return false;
	f->end = json_number(f->s, readable, v);
	return f->end != NULL &&
	    json_skip(f->end, end) == skip_blanks(f->end, end);
}

/* The field at s, of csv or JSON, and the number in it. Most elements of JSON
 * are but a number; to try that first is faster than to look for their end. */
static bool read_field(enum format format, const char *s, const char *end,
    const char *readable, struct span *field, struct span *number, double *v)
{
	if (format == FORMAT_JSON &&
	    element_number(s, end, readable, number, v)) {
		*field = *number;
		return true;
	}
	*field = *number = split_field(format, s, end);
	return field_number(format, number, v);
}

/* The first fields of csv or JSON. */
static bool read_first(const struct layout *l, const char *s, const char *end,
    const char *readable, struct line *r, double v[4], char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads; i++) {
		struct span field;

		if (!read_field(l->in, s, end, readable, &field, &r->at[i],
			&v[i])) {
			bad_field(l, i, field, reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
		s = split_next(l->in, field.end, end);
		if (s == NULL)
			s = end;
	}
	return true;
}

static bool read_columns(const struct layout *l, const char *s, const char *end,
    struct line *r, double v[4], char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads; i++) {
		int k = l->columns.field[i];
		struct span f;

		if (k < 0) {
			snprintf(reason, REASON_MAX,
			    "%s is missing: the header has no such column",
			    order(i));
			return false;
		}
		if (!split_find(l->in, s, end, k, &f)) {
			snprintf(reason, REASON_MAX,
			    "%s is missing: there is no field %d", order(i),
			    k + 1);
			return false;
		}
		if (!field_number(l->in, &f, &v[i])) {
			bad_field(l, i, f, reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
		r->at[i] = f;
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
	f.s = skip_blanks(f.s, f.end);
	while (f.end > f.s && is_blank(f.end[-1]))
		f.end--;
	return (size_t)(f.end - f.s) == n && memcmp(f.s, name, n) == 0;
}

/* The number of the field of that name, or -1. */
static int find_name(struct span line, const char *name)
{
	const char *s = line.s;

	for (int k = 0; s != NULL; k++) {
		struct span f = split_field(FORMAT_CSV, s, line.end);

		if (is_name(f, name))
			return k;
		s = split_next(FORMAT_CSV, f.end, line.end);
	}
	return -1;
}

/* Turns the names of --columns into field numbers. */
static bool resolve(struct layout *l, struct span line, char reason[REASON_MAX])
{
	for (int i = 0; i < l->columns.n; i++) {
		const char *name = l->columns.name[i];
		int *field = &l->columns.field[i];

		if (name != NULL)
			*field = find_name(line, name);
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
static bool is_header(struct layout *l, struct span line)
{
	for (int i = 0; i < l->reads; i++) {
		int k = l->columns.n > 0 ? l->columns.field[i] : i;
		struct span f;
		double v;

		if (split_find(FORMAT_CSV, line.s, line.end, k, &f) &&
		    field_number(FORMAT_CSV, &f, &v))
			return false;
	}
	return true;
}

/* False where the first line is one of points already. */
static bool take_header(struct layout *l, struct span line, struct line *r,
    char reason[REASON_MAX])
{
	bool wanted = named(&l->columns);

	if (wanted && !resolve(l, line, reason))
		r->kind = LINE_BAD;
	return wanted || is_header(l, line);
}

/* Whether the array that the bracket before s opens is closed and nothing
 * follows, whatever stands between its commas. */
static bool is_closed(const char *s, const char *end)
{
	s = json_skip(s, end);
	while (s < end && *s == ',')
		s = json_skip(s + 1, end);
	return s < end && *s == ']' && skip_blanks(s + 1, end) == end;
}

/* Whether all of the line is one array. Where nothing but numbers stand before
 * done, and nothing but the bracket behind it, no more need be looked at. */
static bool check_array(struct span line, const char *done,
    char reason[REASON_MAX])
{
	const char *s = skip_blanks(done, line.end);
	struct json_error e;
	char word[ESCAPED_MAX];

	if (s < line.end && *s == ']' &&
	    skip_blanks(s + 1, line.end) == line.end)
		return true;
	if (json_check(JSON_LINE, line.s, line.end, &e))
		return true;
	s = skip_blanks(line.s, line.end);
	if (!is_closed(s + 1, line.end))
		snprintf(reason, REASON_MAX,
		    "the array does not end with the line; one array a line: "
		    "jq -c '.points[]'");
	else
		snprintf(reason, REASON_MAX, "no JSON from '%s' on",
		    escaped(word, e.at, (size_t)(line.end - e.at)));
	return false;
}

void line_read(struct layout *l, struct span line, const char *readable,
    bool *header, struct line *r, double v[4], char reason[REASON_MAX])
{
	const char *s = skip_blanks(line.s, line.end);
	bool ok;

	r->kind = LINE_COPY;
	r->text = line;
	if (s == line.end || *s == '#')
		return;
	if (l->in == FORMAT_CSV) {
		s = line.s;
		if (*header && line.end - s >= 3 &&
		    memcmp(s, "\xef\xbb\xbf", 3) == 0)
			s += 3; /* a byte order mark */
		bool taken = *header &&
		    take_header(l, (struct span){ s, line.end }, r, reason);

		*header = false;
		if (taken)
			return;
	}
	if (l->in == FORMAT_JSON) {
		if (*s != '[') {
			snprintf(reason, REASON_MAX,
			    "is not a JSON array; one array a line: jq -c "
			    "'.points[]'");
			r->kind = LINE_BAD;
			return;
		}
		s++;
	}
	if (l->columns.n > 0)
		ok = read_columns(l, s, line.end, r, v, reason);
	else if (l->in == FORMAT_TEXT)
		ok = read_text(l, s, line.end, readable, r, v, reason);
	else
		ok = read_first(l, s, line.end, readable, r, v, reason);
	if (ok && l->in == FORMAT_JSON)
		ok = check_array(line,
		    l->columns.n > 0 ? s : r->at[l->reads - 1].end, reason);
	r->kind = ok ? LINE_POINT : LINE_BAD;
}
