/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../json/check.h"
#include "../json/text.h"
#include "../../core/scene/scene.h"
#include "../message/escape.h"
#include "header.h"
#include "line_bad.h"
#include "choose.h"
#include "names.h"

static const struct dialect json = { FORMAT_JSON, ',' };

/* Reads the number that the value is; in JSON, null is one that is not known. */
static bool read_value(struct dialect d, struct span f, double *v)
{
	if (d.format != FORMAT_JSON)
		return f.s < f.end && number_read(f.s, f.end, v) == f.end;
	*v = (double)NAN;
	return (f.end - f.s == 4 && memcmp(f.s, "null", 4) == 0) ||
	    json_number(f.s, f.end, v) == f.end;
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

/* Says why coordinate i was not found, or not once. */
static void say_missing(const struct layout *l, int i, struct cut cut,
    const struct chosen *c, char reason[REASON_MAX])
{
	const char *path = cut.members ? path_of(l, i) : NULL;
	int k = l->columns.field[i];
	char word[ESCAPED_MAX];

	if (path != NULL && c->times[i] > 1) {
		snprintf(reason, REASON_MAX, "has two members '%s'",
		    escaped(word, path, strlen(path)));
	} else if (path != NULL) {
		struct names names = { 0 };
		struct field f;

		snprintf(reason, REASON_MAX, "has no member '%s'%s",
		    escaped(word, path, strlen(path)),
		    l->columns.n > 0 ? "" : "; --columns names the coordinates");
		while (cut_next(&cut, &f))
			names_add(&names,
			    (struct span){ f.name.s + 1, f.name.end - 1 });
		names_say(&names, path, reason);
	} else if (l->columns.n == 0) {
		say_bad_field(l, i, (struct span){ NULL, NULL }, reason);
	} else {
		snprintf(reason, REASON_MAX,
		    k < 0 ? "%s is missing: the header has no such column" :
			c->times[i] == 0 ?
			    "%s is missing: there is no field %d" :
			    "%s is missing: field %d is empty",
		    axis(i), k + 1);
	}
}

/* What a message shows of a field: in csv with its quotes. */
static struct span shown_of(const struct layout *l, const struct field *f)
{
	return l->in.format == FORMAT_CSV ? f->whole : f->value;
}

/* Reads the numbers of the coordinates; says which is the first that is none. */
static bool read_values(const struct layout *l, struct cut cut,
    const struct chosen *c, double v[4], char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads; i++) {
		struct span f = c->field[i].value;
		struct span all = c->field[i].whole;
		bool empty = !cut.members && l->columns.n > 0 && all.s == all.end;

		if (c->times[i] != 1 || empty) {
			say_missing(l, i, cut, c, reason);
			return false;
		}
		if (!read_value(l->in, f, &v[i])) {
			say_bad_field(l, i, shown_of(l, &c->field[i]), reason);
			return false;
		}
		if (!in_range(i, v[i], reason))
			return false;
	}
	return true;
}

/* Whether a member can be added by that path: it is a name, short and without what
 * would have to be escaped. */
static bool can_be_added(const char *path)
{
	bool plain = *path != '/' && strlen(path) < NAME_ROOM - 8;

	for (; *path != '\0'; path++)
		plain &= *path != '"' && *path != '\\' &&
		    (unsigned char)*path >= ' ';
	return plain;
}

/* Whether a bad line's other fields can be kept. */
static bool can_be_kept(const struct layout *l, bool members,
    const struct chosen *c)
{
	for (int i = 0; i < l->reads && members; i++)
		if (c->times[i] > 1 ||
		    (c->times[i] == 0 && !can_be_added(path_of(l, i))))
			return false;
	return !choose_overlaps(l, c);
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

/* Whether the line of JSON is one that has the coordinates in the way --columns says. */
static bool check_json(const struct layout *l, struct span text,
    char reason[REASON_MAX])
{
	const char *s = skip_blanks(json, text.s, text.end);
	bool named = l->columns.n > 0, numbered = named;
	struct json_error e;

	for (int i = 0; i < l->columns.n; i++) {
		named &= l->columns.name[i] != NULL;
		numbered &= l->columns.name[i] == NULL;
	}
	if (*s != '[' && *s != '{')
		snprintf(reason, REASON_MAX,
		    "is neither a JSON array nor an object; one a line: jq -c "
		    "'.[]'");
	else if (!json_check(JSON_LINE, text.s, text.end, &e))
		say_no_json(text, &e, reason);
	else if (*s == '[' && l->columns.n > 0 && !numbered)
		snprintf(reason, REASON_MAX,
		    "is an array; --columns is to number its elements: 2,3,4");
	else if (*s == '{' && l->columns.n > 0 && !named)
		snprintf(reason, REASON_MAX,
		    "is an object; --columns is to name its members: x,y,z, or "
		    "/position/0");
	else
		return true;
	return false;
}

/* Whether each quote that opens a field of csv is closed on the line. */
static bool check_quotes(struct cut c, struct span text, char reason[REASON_MAX])
{
	struct field f = { .closed = true };

	if (memchr(text.s, '"', (size_t)(text.end - text.s)) == NULL)
		return true;
	while (f.closed && cut_next(&c, &f))
		;
	if (!f.closed)
		snprintf(reason, REASON_MAX,
		    "a quote is not closed on the line; a field with a newline "
		    "in it can't be read");
	return f.closed;
}

/* Reads a line that has fields. */
static void read_fields(const struct layout *l, struct span text,
    struct line *line, double v[4], char reason[REASON_MAX])
{
	struct chosen c;

	line->kind = LINE_LOST;
	line->object = l->in.format == FORMAT_JSON &&
	    *skip_blanks(json, text.s, text.end) == '{';
	if (l->in.format == FORMAT_JSON && !check_json(l, text, reason))
		return;
	struct cut cut = cut_line(l->in, text);

	if (l->in.format == FORMAT_CSV && !check_quotes(cut, text, reason))
		return;
	choose(l, cut, &c);
	bool ok = read_values(l, cut, &c, v, reason);

	if (ok && choose_overlaps(l, &c)) {
		ok = false;
		snprintf(reason, REASON_MAX,
		    "has a coordinate in another; --columns names values apart");
	}
	if (l->in.format == FORMAT_TEXT && c.mixed) {
		if (ok)
			snprintf(reason, REASON_MAX,
			    "has commas between some numbers and not between "
			    "others; is the comma a decimal point? write 1.5 "
			    "for 1,5");
		ok = false;
		line->words = l->columns.n == 0;
		cut.words = line->words;
		choose(l, cut, &c);
	}
	if (ok || ((cut.members || cut.s != NULL) && can_be_kept(l, cut.members, &c)))
		line->kind = ok ? LINE_POINT : LINE_BAD;
	for (int i = 0; i < l->reads; i++)
		line->at[i] = c.times[i] > 0 ?
		    line_part(line, ok || l->in.format != FORMAT_CSV ? c.field[i].value : trimmed(l->in, c.field[i].whole)) :
		    part_missing;
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
	bool was_first = *first;

	(void)readable;

	line->kind = LINE_COPY;
	line->object = line->words = false;
	line->mark = was_first && skip_mark(text.s, text.end) > text.s;
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
	read_fields(l, text, line, v, reason);
	if (was_first && line_is_bad(line) && l->in.format == FORMAT_TEXT)
		say_header_of_text(l, text, reason);
}
