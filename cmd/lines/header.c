/* SPDX-License-Identifier: MIT */
#include "header.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <strings.h>

#include "../message/escape.h"
#include "choose.h"
#include "say.h"

/* A # is a field of its own where a separator follows; a blank separates it from
 * nothing, as in "# x y z". */
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

/* Returns the name that coordinate i is looked for by; NULL: a number says it. */
static const char *name_of(const struct columns *c, int i)
{
	return c->by_header ? coordinate_name(i) : c->name[i];
}

/* Returns the number of the first field that has the name of coordinate i, or -1.
 * Names that nobody typed are found in either case. */
static int find_name(const struct layout *l, struct span header, int i)
{
	const char *name = name_of(&l->columns, i);
	struct cut c = cut_line(l->in, header);
	size_t n = strlen(name);
	struct field field;

	for (int k = 0; cut_next(&c, &field); k++) {
		struct span f = field.value;

		if ((size_t)(f.end - f.s) == n &&
		    (l->columns.by_header ? strncasecmp(f.s, name, n) :
					    strncmp(f.s, name, n)) == 0)
			return k;
	}
	return -1;
}

/* Finds the fields of the coordinates. Returns the first that the header lacks, or
 * the number of coordinates. */
static int find_names(const struct layout *l, struct span header, int field[4])
{
	int i;

	for (i = 0; i < l->reads; i++) {
		field[i] = name_of(&l->columns, i) != NULL ?
		    find_name(l, header, i) :
		    l->columns.field[i];
		if (field[i] < 0)
			break;
	}
	return i;
}

static bool is_named(const struct layout *l)
{
	for (int i = 0; i < l->reads; i++)
		if (name_of(&l->columns, i) != NULL)
			return true;
	return false;
}

/* Finds the columns of the coordinates; says which is not there. */
static bool find_columns(struct layout *l, struct span header,
    char reason[REASON_MAX])
{
	struct columns *c = &l->columns;
	char word[ESCAPED_MAX];
	int field[4], i = find_names(l, header, field);

	if (i < l->reads) {
		const char *name = name_of(c, i);

		snprintf(reason, REASON_MAX, "the header has no column '%s'",
		    escaped(word, name, strlen(name)));
		say_names(l, cut_line(l->in, header),
		    c->by_header ? NULL : name, reason);
		return false;
	}
	for (i = 1; i < l->reads; i++)
		for (int k = 0; k < i; k++)
			if (field[k] == field[i]) {
				snprintf(reason, REASON_MAX,
				    "two coordinates are column %d",
				    field[i] + 1);
				return false;
			}
	memcpy(c->field, field, sizeof field);
	c->n = l->reads;
	return true;
}

static bool begins_with_digit(struct span f)
{
	f.s += f.s < f.end && (*f.s == '-' || *f.s == '+');
	f.s += f.s < f.end && *f.s == '.';
	return f.s < f.end && isdigit((unsigned char)*f.s);
}

/* Returns whether none of the coordinates is a number; and not all of them begin as
 * one, as 1,5 does, or are missing values. */
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
	int field[4];

	return format_of(l->in)->header &&
	    (names.s == skip_mark(text.s, text.end) ||
		(l->header != HEADER_NONE && is_named(l) &&
		    find_names(l, names, field) == l->reads));
}

bool header_read(struct layout *l, struct span text, struct line *line,
    char reason[REASON_MAX])
{
	struct columns *c = &l->columns;

	text = header_names(l->in, text);
	l->fields = 0;
	if (c->by_header)
		c->n = 0;
	if (l->header == HEADER_NONE ||
	    (l->header == HEADER_MAYBE && (c->by_header || !is_named(l)) &&
		!looks_like_header(l, text)))
		return false;
	line->kind = find_columns(l, text, reason) &&
		!choose_clashes(l, cut_line(l->in, text), reason) ?
	    LINE_HEADER :
	    LINE_REFUSED;
	if (l->append)
		l->fields = choose_count(cut_line(l->in, text));
	return true;
}

void header_places(const struct layout *l, struct span text, struct span at[4])
{
	struct chosen c;

	choose(l, cut_line(l->in, header_names(l->in, text)), &c);
	for (int i = 0; i < l->reads; i++)
		if (c.times[i] > 0)
			at[i] = trimmed(l->in, c.field[i].whole);
}
