/* SPDX-License-Identifier: MIT */
#include "line_bad.h"

#include <stdio.h>

#include "../escape.h"
#include "../json/check.h"
#include "line_object.h"
#include "names.h"

const char *axis(int i)
{
	static const char *const words[] = { "x", "y", "z", "w" };

	return words[i];
}

static int count(struct span f, char c)
{
	int n = 0;

	for (; f.s < f.end; f.s++)
		n += *f.s == c;
	return n;
}

static bool has(struct span f, char c)
{
	return count(f, c) > 0;
}

/* What would be right in the place of f. Where reads says that a number begins
 * there, it is what comes after it that is wrong. */
static const char *hint(const struct layout *l, int i, struct span f)
{
	double v;

	if (l->in.format == FORMAT_CSV && l->in.separator != ',' && has(f, ','))
		return count(f, ',') == 1 ?
		    "; a decimal point is a point: 1.5" :
		    "; is a comma the separator? say -i csv alone";
	if (l->in.format != FORMAT_JSON && has(f, ';'))
		return "; is ; the separator? say -i csv --separator ';'";
	if (l->in.format != FORMAT_JSON && has(f, '|'))
		return "; is | the separator? say -i csv --separator '|'";
	if (l->in.format == FORMAT_CSV && has(f, ' ') &&
	    number_read(f.s, f.end, &v) != NULL)
		return "; are blanks the separator? leave -i csv out";
	if (number_read(f.s, f.end, &v) != NULL)
		return l->in.format == FORMAT_JSON ?
		    "; a number is wanted, as JSON writes it" :
		    l->in.format == FORMAT_CSV ?
		    "; a number is wanted, and nothing else in the field" :
		    "; a number is wanted, with a blank or comma behind it";
	if (l->in.format != FORMAT_JSON && l->columns.n == 0 && i == 0)
		return "; a number is wanted; --columns says which fields the "
		       "coordinates are";
	return "; a number is wanted";
}

void say_bad_field(const struct layout *l, int i, struct span f,
    char reason[REASON_MAX])
{
	size_t n = (size_t)(f.end - f.s);
	bool nested = n > 0 && (*f.s == '[' || *f.s == '{');
	char word[ESCAPED_MAX];

	if (nested && l->in.format != FORMAT_JSON)
		snprintf(reason, REASON_MAX,
		    "looks like JSON; say -i json, with one array or object a "
		    "line: jq -c '%s'",
		    *f.s == '[' ? ".[]" : ".points[]");
	else if (nested)
		snprintf(reason, REASON_MAX,
		    "%s is not a number; one array or object a line: jq -c "
		    "'.[]'",
		    axis(i));
	else if (n == 0)
		snprintf(reason, REASON_MAX,
		    "%s is missing; %d numbers are wanted", axis(i), l->reads);
	else
		snprintf(reason, REASON_MAX, "%s is '%s'%s", axis(i),
		    escaped(word, f.s, n), hint(l, i, f));
}

bool say_header_of_text(const struct layout *l, struct span text,
    char reason[REASON_MAX])
{
	const char *s = skip_blanks(l->in, text.s, text.end);

	if (l->columns.n > 0 || *s == '[' || *s == '{')
		return false;
	for (int i = 0; i < l->reads && s != NULL; i++) {
		struct span f = field_at(l->in, s, text.end);
		double v;

		if (f.s < f.end && number_read(f.s, f.end, &v) != NULL)
			return false;
		s = field_next(l->in, f.end, text.end);
	}
	snprintf(reason, REASON_MAX, "looks like a header; say %s",
	    has(text, ',')      ? "-i csv" :
		has(text, '\t') ? "-i tsv" :
		has(text, ';')  ? "-i csv --separator ';'" :
				  "-i csv --separator ' ', or put # before it");
	return true;
}

/* Fields from the first coordinate to the last. */
static int fields_spanned(const struct layout *l)
{
	int least = l->columns.field[0], most = least;

	if (l->columns.n == 0)
		return l->reads;
	for (int i = 1; i < l->columns.n; i++) {
		int k = l->columns.field[i];

		least = k < least ? k : least;
		most = k > most ? k : most;
	}
	return most - least + 1;
}

static bool number_stands(const char *s, const char *end)
{
	double v;
	const char *stop = s < end ? number_read(s, end, &v) : NULL;

	return stop != NULL && ends_field(stop, end);
}

/* Whether the number at s, behind the last coordinate, counts as another would:
 * behind two coordinates, or where a comma alone is between. */
static bool counts_on(const struct layout *l, const char *last, const char *s,
    const char *end)
{
	return number_stands(s, end) &&
	    (l->reads == 2 || (s == last + 1 && *last == ','));
}

bool commas_agree(const struct layout *l, const char *s, const char *end)
{
	int n = fields_spanned(l), separators = 0, commas = 0;

	for (int k = 1; k <= n; k++) {
		struct span f = field_at(l->in, s, end);

		s = skip_separator(f.end, end);
		if (s == end || (k == n && !counts_on(l, f.end, s, end)))
			break;
		separators++;
		commas += has((struct span){ f.end, s }, ',');
	}
	return commas == 0 || commas == separators;
}

static bool is_closed(struct span f)
{
	if (f.s == f.end || *f.s != '"')
		return true;
	for (f.s++; f.s < f.end; f.s++)
		if (*f.s == '"' && (++f.s == f.end || *f.s != '"'))
			return true;
	return false;
}

bool quotes_are_closed(struct dialect d, struct span text)
{
	const char *s = text.s;

	while (s != NULL) {
		struct span f = field_at(d, s, text.end);

		if (!is_closed(trimmed(d, f)))
			return false;
		s = field_next(d, f.end, text.end);
	}
	return true;
}

/* A field up to a blank, where commas may be decimal points. */
static struct span word_at(const char *s, const char *end)
{
	struct span f = { s, s };

	while (f.end < end && !is_blank(*f.end))
		f.end++;
	return f;
}

/* Finds the fields of a line of text, csv or an array, from s on. */
static void find_fields(const struct layout *l, const char *s, const char *end,
    bool words, struct line *line)
{
	bool csv = l->in.format == FORMAT_CSV;

	for (int k = 0; s != NULL; k++) {
		struct span f = words ? word_at(s, end) :
					field_at(l->in, s, end);
		struct span inner = csv ? trimmed(l->in, f) : f;

		for (int i = 0; i < l->reads; i++)
			if (k == (l->columns.n > 0 ? l->columns.field[i] : i))
				line->at[i] = line_part(line, inner);
		if (words) {
			s = skip_blanks(l->in, f.end, end);
			s = s < end ? s : NULL;
		} else {
			s = field_next(l->in, f.end, end);
		}
	}
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

bool places_overlap(const struct layout *l, const struct line *line)
{
	for (int i = 1; i < l->reads; i++)
		for (int k = 0; k < i; k++)
			if (line->at[i].from < line->at[k].to &&
			    line->at[k].from < line->at[i].to)
				return true;
	return false;
}

/* Finds the members of an object, of which there may be one of each name. */
static bool find_members(const struct layout *l, struct span text,
    struct line *line)
{
	for (int i = 0; i < l->reads; i++) {
		const char *path = path_of(l, i);
		struct json_place p;

		if (path == NULL)
			return false;
		int times = json_place_find(text, path, &p);

		if (times == 1)
			line->at[i] = line_part(line, p.value);
		else if (times > 1 || !can_be_added(path))
			return false;
	}
	return !places_overlap(l, line);
}

/* Whether the array, from behind its bracket on, has elements to number. */
static bool has_fields(const struct layout *l, const char *s, const char *end)
{
	return *skip_blanks(l->in, s, end) != ']' &&
	    (l->columns.n == 0 || l->columns.name[0] == NULL);
}

static bool take_apart(const struct layout *l, struct span text,
    struct line *line)
{
	const char *s = skip_blanks(l->in, text.s, text.end);
	struct json_error e;

	switch (l->in.format) {
	case FORMAT_CSV:
		if (!quotes_are_closed(l->in, text))
			return false;
		find_fields(l, text.s, text.end, false, line);
		return true;
	case FORMAT_JSON:
		line->object = *s == '{';
		if ((*s != '[' && *s != '{') ||
		    !json_check(JSON_LINE, text.s, text.end, &e))
			return false;
		if (line->object)
			return find_members(l, text, line);
		if (!has_fields(l, s + 1, text.end))
			return false;
		find_fields(l, s + 1, text.end, false, line);
		return true;
	default:
		find_fields(l, s, text.end,
		    l->columns.n == 0 && !commas_agree(l, s, text.end), line);
		return true;
	}
}

void line_take_apart(const struct layout *l, struct span text,
    struct line *line)
{
	for (int i = 0; i < l->reads; i++)
		line->at[i] = part_missing;
	line->kind = take_apart(l, text, line) ? LINE_BAD : LINE_LOST;
}
