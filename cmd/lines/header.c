/* SPDX-License-Identifier: MIT */
#include "line.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <strings.h>

#include "../message/utf8.h"

/* A # before a separator is a field and not the beginning of a comment; but if blanks
 * separate fields, "# x y z" is a comment. */
struct span header_names(struct dialect d, struct span text)
{
	text.s = skip_mark(text.s, text.end);
	const char *s = skip_blanks(d, text.s, text.end);

	if (s == text.end || *s++ != '#')
		return text;
	if (d.separator == ' ')
		while (s < text.end && is_blank(*s))
			s++;
	const char *next = skip_blanks(d, s, text.end);

	if (d.separator == ' ' || next == text.end || *next != d.separator)
		text.s = s;
	return text;
}

/* Returns the number, not below from, of the first field with that name, or -1. Without
 * --columns, X is x, too. */
static int find_name(const struct layout *l, struct span header,
    const char *name, int from)
{
	struct cut c = cut_line(l->in, header);
	size_t n = strlen(name);
	struct field f;

	for (int k = 0; cut_next(&c, &f); k++)
		if (k >= from && (size_t)(f.value.end - f.value.s) == n &&
		    (l->columns.by_header ? strncasecmp(f.value.s, name, n) :
					    strncmp(f.value.s, name, n)) == 0)
			return k;
	return -1;
}

/* Finds the field of each coordinate. Returns false, with the reason, if the header has
 * no column of its name. */
static bool find_columns(const struct layout *l, struct span header,
    int field[4], char reason[REASON_MAX])
{
	const struct columns *c = &l->columns;
	char shown[ESCAPED_MAX];

	for (int i = 0; i < l->reads; i++) {
		const char *name = c->name[i];

		field[i] = name != NULL ? find_name(l, header, name, 0) :
					  c->field[i];
		if (field[i] >= 0)
			continue;
		snprintf(reason, REASON_MAX, "the header has no column '%s'",
		    escaped(shown, name, strlen(name)));
		say_names(l, cut_line(l->in, header),
		    c->by_header ? NULL : name, reason);
		return false;
	}
	return true;
}

/* Returns whether a coordinate has two columns without --columns, with the reason. */
static bool has_rivals(const struct layout *l, struct span header,
    const int field[4], char reason[REASON_MAX])
{
	for (int i = 0; i < l->reads && l->columns.by_header; i++) {
		int other = find_name(l, header, l->columns.name[i],
		    field[i] + 1);

		if (other < 0)
			continue;
		snprintf(reason, REASON_MAX,
		    "the header has two columns for %s, %d and %d; say with "
		    "--columns, by number, which the coordinates are",
		    coordinate_name(i), field[i] + 1, other + 1);
		return true;
	}
	return false;
}

/* Returns whether the line may be a header or a point: an empty field and then 0, 1, 2
 * and so on, as pandas names the columns of an array. Writes the reason. */
static bool is_counted(const struct layout *l, struct span text,
    char reason[REASON_MAX])
{
	struct cut c = cut_line(l->in, text);
	struct field f;
	int k = 0;

	for (; cut_next(&c, &f); k++)
		if (k == 0 ? f.value.s < f.value.end :
			     !is_index(f.value, k - 1))
			return false;
	if (k <= l->reads)
		return false;
	snprintf(reason, REASON_MAX,
	    "may be a header that counts the columns, or a point; say "
	    "--header --columns %.*s, or --no-header",
	    2 * l->reads - 1, "2,3,4,5");
	return true;
}

/* Returns whether two coordinates have the same column; if so, writes the reason. */
static bool is_twice(const int field[4], int n, char reason[REASON_MAX])
{
	for (int i = 1; i < n; i++)
		for (int k = 0; k < i; k++)
			if (field[k] == field[i]) {
				snprintf(reason, REASON_MAX,
				    "two coordinates are column %d",
				    field[i] + 1);
				return true;
			}
	return false;
}

/* Returns whether any coordinate is found by the name of its column. */
static bool is_named(const struct layout *l)
{
	for (int i = 0; i < l->reads; i++)
		if (l->columns.name[i] != NULL)
			return true;
	return false;
}

static bool begins_with_digit(struct span f)
{
	f.s += f.s < f.end && (*f.s == '-' || *f.s == '+');
	f.s += f.s < f.end && *f.s == '.';
	return f.s < f.end && isdigit((unsigned char)*f.s);
}

/* Returns false if a coordinate is a number, if all coordinates are missing values, or if
 * all begin with a digit, as numbers with decimal commas do. */
static bool looks_like_header(const struct layout *l, struct span text)
{
	bool unknown = true, odd = true;
	struct chosen c;

	choose(l, cut_line(l->in, text), &c);
	for (int i = 0; i < l->reads; i++) {
		struct span f = c.field[i].value;
		double v;

		if (c.times[i] == 0)
			continue;
		if (format_of(l->in)->number(f.s, f.end, &v) != f.end)
			unknown = false;
		else if (!isnan(v))
			return false;
		odd &= begins_with_digit(f);
	}
	return !unknown && !odd;
}

bool header_in_comment(const struct layout *l, struct span text)
{
	struct span names = header_names(l->in, text);
	char reason[REASON_MAX];
	int field[4];

	return format_of(l->in)->header &&
	    (names.s == skip_mark(text.s, text.end) ||
		(l->header != HEADER_NONE && is_named(l) &&
		    find_columns(l, names, field, reason)));
}

bool header_read(struct layout *l, struct span text, struct line *line,
    char reason[REASON_MAX])
{
	struct columns *c = &l->columns;
	struct chosen chosen;

	text = header_names(l->in, text);
	l->fields = 0;
	if (c->by_header)
		c->n = 0;
	const bool maybe = l->header == HEADER_MAYBE &&
	    (c->by_header || !is_named(l));
	const bool counted = maybe && is_counted(l, text, reason);

	if (l->header == HEADER_NONE ||
	    (maybe && !counted && !looks_like_header(l, text)))
		return false;
	struct cut cut = cut_line(l->in, text);
	int field[4];

	line->kind = LINE_REFUSED;
	if (counted || !find_columns(l, text, field, reason) ||
	    has_rivals(l, text, field, reason) ||
	    is_twice(field, l->reads, reason) || choose_clashes(l, cut, reason))
		return true;
	line->kind = LINE_HEADER;
	memcpy(c->field, field, sizeof field);
	c->n = l->reads;
	l->fields = choose_count(cut);
	choose(l, cut, &chosen);
	for (int i = 0; i < l->reads; i++)
		line->at[i] = chosen.times[i] == 0 ?
		    part_missing :
		    line_part(line, trimmed(l->in, chosen.field[i].whole));
	return true;
}

bool header_is_short(const struct layout *l, struct cut c,
    char reason[REASON_MAX])
{
	bool blanks = false;
	size_t n = 0;
	struct field f;

	for (; cut_next(&c, &f); blanks |= say_blanks(l, &f, reason))
		n += f.next != NULL || f.value.s < f.value.end;
	if (!is_named(l) || n <= l->fields)
		return false;
	if (blanks)
		return true;
	snprintf(reason, REASON_MAX,
	    "has %zu fields and the header %zu name%s; name the first column, "
	    "too, or give --columns by number",
	    n, l->fields, l->fields == 1 ? "" : "s");
	return true;
}
