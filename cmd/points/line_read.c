/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../json/check.h"
#include "../json/scan.h"
#include "../../core/scene.h"
#include "../escape.h"
#include "header.h"
#include "line_bad.h"
#include "line_object.h"
#include "names.h"

static const struct dialect json = { FORMAT_JSON, ',' };

/* Reads the number in *f, and cuts *f to it: in csv, blanks and quotes may
 * stand around it; in JSON, null is an unknown number. Returns false if *f
 * holds anything else. As no number goes on past what ends a field, number_read
 * may look at all that is readable after it, which is faster. */
static bool field_number(struct dialect d, struct span *f, const char *readable,
    double *v)
{
	struct span n = *f;
	const char *stop;

	if (d.format == FORMAT_CSV) {
		n = trimmed(d, n);
		if (n.end - n.s >= 2 && *n.s == '"' && n.end[-1] == '"') {
			n.s++;
			n.end--;
		}
	}
	if (d.format == FORMAT_JSON && n.end - n.s == 4 &&
	    memcmp(n.s, "null", 4) == 0) {
		*v = (double)NAN;
		return true;
	}
	if (n.s == n.end)
		return false;
	stop = d.format == FORMAT_JSON ? json_number(n.s, readable, v) :
					 number_read(n.s, readable, v);
	if (stop != n.end)
		return false;
	*f = n;
	return true;
}

static bool in_range(int i, double v, char reason[REASON_MAX])
{
	if (!(fabs(v) > MAGNITUDE_MAX))
		return true;
	snprintf(reason, REASON_MAX,
	    isinf(v) ?
		"%s is infinite; a number up to 1e150 is wanted, or nan" :
		"%s is beyond 1e150 in magnitude; choose another unit",
	    axis(i));
	return false;
}

/* Reads the first fields of a line of text. */
static bool read_words(const struct layout *l, const char *s, const char *end,
    const char *readable, struct line *line, double v[4],
    char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads; i++) {
		const char *stop = s == end ? NULL :
					      number_read(s, readable, &v[i]);

		if (stop == NULL || !ends_field(stop, end)) {
			say_bad_field(l, i, field_at(l->in, s, end), reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
		line->at[i] = line_part(line, (struct span){ s, stop });
		s = skip_separator(stop, end);
	}
	return true;
}

/* Reads the first fields of a line of csv or JSON. */
static bool read_first(const struct layout *l, const char *s, const char *end,
    const char *readable, struct line *line, double v[4],
    char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads; i++) {
		struct span field = field_at(l->in, s, end), number = field;

		if (!field_number(l->in, &number, readable, &v[i])) {
			say_bad_field(l, i, field, reason);
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
			    f.s == NULL ?
				"%s is missing: there is no field %d" :
				"%s is missing: field %d is empty",
			    axis(i), k + 1);
			return false;
		}
		from = f.s;
		passed = k;
		if (!field_number(l->in, &f, readable, &v[i])) {
			say_bad_field(l, i, f, reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
		line->at[i] = line_part(line, f);
	}
	return true;
}

/* Whether a carriage return, outside of quotes, stands where more of the line comes
 * after it; says so then. */
static bool has_old_line_ends(struct dialect d, struct span text,
    char reason[REASON_MAX])
{
	const char *s = text.s;
	bool csv = d.format == FORMAT_CSV &&
	    *skip_blanks(d, s, text.end) != '#';
	/* as csv_field has it: a quote counts where it opens a field */
	bool quoted = false, opens = csv;

	for (; s < text.end && (*s != '\r' || quoted); s++) {
		if (*s == '"' && quoted && s + 1 < text.end && s[1] == '"')
			s++;
		else if (*s == '"')
			quoted = opens && !quoted;
		opens = quoted ||
		    (csv && (*s == d.separator || (opens && is_blank(*s))));
	}
	while (s < text.end && is_blank(*s))
		s++;
	if (s == text.end)
		return false;
	snprintf(reason, REASON_MAX,
	    "has carriage returns alone for line ends; make them newlines: tr "
	    "'\\r' '\\n'");
	return true;
}

/* Says why the text, which begins as an array or object, is no JSON. */
static void say_no_json(struct span text, const struct json_error *e,
    char reason[REASON_MAX])
{
	const char *s = skip_blanks(json, text.s, text.end);
	bool object = *s == '{';

	/* what is in it need not be JSON */
	for (s = json_skip(s + 1, text.end); s < text.end && *s == ',';)
		s = json_skip(s + 1, text.end);
	if (s < text.end && *s == (object ? '}' : ']') &&
	    skip_blanks(json, s + 1, text.end) == text.end)
		snprintf(reason, REASON_MAX, "is no JSON: %s", e->reason);
	else if (!has_old_line_ends(json, text, reason))
		snprintf(reason, REASON_MAX,
		    object ? "the object does not end with the line; one "
			     "object a line: jq -c ." :
			     "the array does not end with the line; one array "
			     "a line: jq -c '.[]'");
}

/* Whether all of the line is one JSON array. Up to done it has been read; if
 * those were numbers alone, and only the closing bracket comes after them, the
 * line need not be looked at again. */
static bool check_array(struct span text, const char *done)
{
	const char *s = skip_blanks(json, done, text.end);
	struct json_error e;

	if (s < text.end && *s == ']' &&
	    skip_blanks(json, s + 1, text.end) == text.end)
		return true;
	return json_check(JSON_LINE, text.s, text.end, &e);
}

/* Finds coordinate i of the object. */
static bool find_member(const struct layout *l, int i, struct span object,
    struct json_place *p, char reason[REASON_MAX])
{
	const char *path = path_of(l, i);
	int times = json_place_find(object, path, p);
	char word[ESCAPED_MAX];
	struct names names = { 0 };

	if (times == 1)
		return true;
	if (times > 1) {
		snprintf(reason, REASON_MAX, "has two members '%s'",
		    escaped(word, path, strlen(path)));
		return false;
	}
	snprintf(reason, REASON_MAX,
	    l->columns.n > 0 ? "has no member '%s'" :
			       "has no member '%s'; --columns names the "
			       "coordinates",
	    escaped(word, path, strlen(path)));
	json_place_names(object, &names);
	names_say(&names, path, reason);
	return false;
}

static bool read_object(const struct layout *l, struct span text,
    const char *readable, struct line *line, double v[4],
    char reason[REASON_MAX])
{
	struct json_error e;

	line->object = true;
	if (!json_check(JSON_LINE, text.s, text.end, &e))
		return false;
	text = trimmed(json, text);
	for (int i = 0; i < l->reads; i++) {
		struct json_place p;
		struct span f;

		if (l->columns.n > 0 && l->columns.name[i] == NULL) {
			snprintf(reason, REASON_MAX,
			    "is an object; --columns is to name its members: "
			    "x,y,z, or /position/0");
			return false;
		}
		if (!find_member(l, i, text, &p, reason))
			return false;
		f = p.value;
		if (!field_number(json, &f, readable, &v[i])) {
			say_bad_field(l, i, f, reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
		line->at[i] = line_part(line, f);
	}
	if (!places_overlap(l, line))
		return true;
	snprintf(reason, REASON_MAX,
	    "has a coordinate in another; --columns names values apart");
	return false;
}

static bool read_array(struct layout *l, struct span text, const char *readable,
    struct line *line, double v[4], char reason[REASON_MAX])
{
	const char *s = skip_blanks(json, text.s, text.end) + 1;

	for (int i = 0; i < l->columns.n; i++)
		if (l->columns.name[i] != NULL) {
			snprintf(reason, REASON_MAX,
			    "is an array; --columns is to number its elements: "
			    "2,3,4");
			return false;
		}
	if (l->columns.n > 0)
		return read_columns(l, s, text.end, readable, line, v,
			   reason) &&
		    check_array(text, s);
	return read_first(l, s, text.end, readable, line, v, reason) &&
	    check_array(text, line_at(line, l->reads - 1).end);
}

static bool read_json(struct layout *l, struct span text, const char *readable,
    struct line *line, double v[4], char reason[REASON_MAX])
{
	const char *s = skip_blanks(json, text.s, text.end);
	struct json_error e;

	if (*s != '[' && *s != '{') {
		snprintf(reason, REASON_MAX,
		    "is neither a JSON array nor an object; one a line: jq -c "
		    "'.[]'");
		return false;
	}
	if (*s == '[' ? read_array(l, text, readable, line, v, reason) :
			read_object(l, text, readable, line, v, reason))
		return true;
	if (!json_check(JSON_LINE, text.s, text.end, &e))
		say_no_json(text, &e, reason);
	return false;
}

static bool read_csv(struct layout *l, struct span text, const char *readable,
    struct line *line, double v[4], char reason[REASON_MAX])
{
	bool ok = l->columns.n > 0 ?
	    read_columns(l, text.s, text.end, readable, line, v, reason) :
	    read_first(l, text.s, text.end, readable, line, v, reason);

	if (memchr(text.s, '"', (size_t)(text.end - text.s)) == NULL ||
	    quotes_are_closed(l->in, text))
		return ok;
	snprintf(reason, REASON_MAX,
	    "a quote is not closed on the line; a field with a newline in it "
	    "can't be read");
	return false;
}

static bool read_text(struct layout *l, struct span text, const char *readable,
    struct line *line, double v[4], char reason[REASON_MAX])
{
	const char *s = skip_blanks(l->in, text.s, text.end), *first = s;

	if (l->columns.n == 0) {
		if (!read_words(l, s, text.end, readable, line, v, reason))
			return false;
	} else {
		if (!read_columns(l, s, text.end, readable, line, v, reason))
			return false;
		first = line_at(line, 0).s;
		for (int i = 1; i < l->reads; i++)
			if (line_at(line, i).s < first)
				first = line_at(line, i).s;
	}
	if (commas_agree(l, first, text.end))
		return true;
	snprintf(reason, REASON_MAX,
	    "has commas between some numbers and not between others; is the "
	    "comma a decimal point? write 1.5 for 1,5");
	return false;
}

/* Returns false where the first line that counts is not to be read as a point. In
 * JSON a carriage return is a blank like others. */
static bool read_first_line(struct layout *l, struct span text,
    struct line *line, char reason[REASON_MAX])
{
	const char *s = skip_blanks(l->in, text.s, text.end);
	bool mark = *s == '#';

	line->kind = LINE_LOST;
	if ((l->in.format != FORMAT_JSON || mark) &&
	    has_old_line_ends(l->in, text, reason))
		return false;
	if (l->in.format != FORMAT_CSV)
		return true;
	if (*s != '{')
		return !header_read(l, text, line, reason);
	snprintf(reason, REASON_MAX, "looks like JSON; say -i json");
	return false;
}

/* Whether the line, of which s is the first character that is no blank, is copied as
 * it is: a comment, but not one that is a header, or a whole file. */
static bool is_comment(struct layout *l, struct span text, const char *s,
    bool first)
{
	char reason[REASON_MAX];

	return *s == '#' &&
	    !(first &&
		(header_in_comment(l, text) ||
		    has_old_line_ends(l->in, text, reason)));
}

void line_read(struct layout *l, struct span text, const char *readable,
    bool *first, struct line *line, double v[4], char reason[REASON_MAX])
{
	bool was_first = *first, ok;

	line->kind = LINE_COPY;
	line->object = false;
	line->s = text.s;
	line->size = (uint32_t)(text.end - text.s);
	if (was_first)
		text.s = skip_mark(text.s, text.end);
	const char *s = skip_blanks(l->in, text.s, text.end);

	if (s == text.end || is_comment(l, text, s, was_first))
		return;
	*first = false;
	if (was_first && !read_first_line(l, text, line, reason))
		return;
	switch (l->in.format) {
	case FORMAT_CSV:
		ok = read_csv(l, text, readable, line, v, reason);
		break;
	case FORMAT_JSON:
		ok = read_json(l, text, readable, line, v, reason);
		break;
	default:
		ok = read_text(l, text, readable, line, v, reason);
		if (!ok && was_first)
			say_header_of_text(l, text, reason);
	}
	line->kind = LINE_POINT;
	if (!ok)
		line_take_apart(l, text, line);
}
