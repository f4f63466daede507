/* SPDX-License-Identifier: MIT */
#include "header.h"

#include <ctype.h>
#include <stdio.h>
#include <strings.h>

#include "../message/escape.h"
#include "choose.h"
#include "say.h"

/* Past the mark of a text and that of a comment. */
struct span header_names(struct dialect d, struct span text)
{
	const char *s = skip_mark(text.s, text.end);
	const char *mark = skip_blanks(d, s, text.end);

	text.s = mark < text.end && *mark == '#' ? mark + 1 : s;
	return text;
}

typedef int comparison(const char *, const char *, size_t);

/* Returns the number of the first field of that name, or -1. */
static int find_name(struct dialect d, struct span header, const char *name,
    comparison *compare)
{
	struct cut c = cut_line(d, header);
	size_t n = strlen(name);
	struct field field;

	for (int k = 0; cut_next(&c, &field); k++) {
		struct span f = trimmed(d, field.value);

		if ((size_t)(f.end - f.s) == n && compare(f.s, name, n) == 0)
			return k;
	}
	return -1;
}

static bool header_repeats(const struct columns *c, int i,
    char reason[REASON_MAX])
{
	for (int k = 0; k < i; k++)
		if (c->field[k] == c->field[i]) {
			snprintf(reason, REASON_MAX,
			    "two coordinates are column %d", c->field[i] + 1);
			return true;
		}
	return false;
}

/* Turns the names of --columns into field numbers. */
static bool find_columns(struct layout *l, struct span header,
    char reason[REASON_MAX])
{
	struct columns *c = &l->columns;
	char word[ESCAPED_MAX];
	bool found = true;

	for (int i = 0; i < c->n; i++) {
		if (c->name[i] == NULL)
			continue;
		c->field[i] = find_name(l->in, header, c->name[i], strncmp);
		if (c->field[i] >= 0 || !found)
			continue;
		found = false;
		snprintf(reason, REASON_MAX, "the header has no column '%s'",
		    escaped(word, c->name[i], strlen(c->name[i])));
		say_names(cut_line(l->in, header), c->name[i], reason);
	}
	for (int i = 1; i < c->n && found; i++)
		found = !header_repeats(c, i, reason);
	for (int i = 0; i < c->n && !found; i++)
		c->field[i] = -1;
	return found;
}

/* No number that identifies is a coordinate. */
static bool begins_with_id(struct dialect d, struct span header,
    char reason[REASON_MAX])
{
	static const char *const ids[] = { "id", "fid" };

	for (int i = 0; i < 2; i++)
		if (find_name(d, header, ids[i], strncasecmp) == 0) {
			snprintf(reason, REASON_MAX,
			    "the first column is '%s'; say with --columns "
			    "which the coordinates are",
			    ids[i]);
			return true;
		}
	return false;
}

/* Where nobody said which columns the coordinates are: those named x, y, z, w, if
 * all that are read have one; the first ones if neither x nor y does, unless the first
 * is an id. */
static bool find_axes(struct layout *l, struct span header,
    char reason[REASON_MAX])
{
	struct columns *c = &l->columns;
	int missing = -1;

	for (int i = l->reads - 1; i >= 0; i--) {
		c->field[i] = find_name(l->in, header, coordinate_name(i),
		    strncasecmp);
		if (c->field[i] < 0)
			missing = i;
	}
	bool none = c->field[0] < 0 && c->field[1] < 0;

	c->n = none && missing >= 0 ? 0 : l->reads;
	if (missing < 0 ||
	    (none &&
		(l->header == HEADER_FIRST ||
		    !begins_with_id(l->in, header, reason))))
		return true;
	if (!none)
		snprintf(reason, REASON_MAX,
		    "the header has no column '%s', but '%s'; say with "
		    "--columns which the coordinates are",
		    coordinate_name(missing), coordinate_name(c->field[0] < 0));
	c->n = l->reads;
	for (int i = 0; i < c->n; i++)
		c->field[i] = -1;
	return false;
}

/* What stands for a number that isn't known. */
static bool is_unknown(struct span f)
{
	static const char *const words[] = { "n/a", "na", "nan", "null", "" };
	size_t n = (size_t)(f.end - f.s);

	for (int i = 0; i < 5; i++)
		if (strlen(words[i]) == n && strncasecmp(words[i], f.s, n) == 0)
			return true;
	return false;
}

static bool begins_with_digit(struct span f)
{
	f.s += f.s < f.end && (*f.s == '-' || *f.s == '+');
	f.s += f.s < f.end && *f.s == '.';
	return f.s < f.end && isdigit((unsigned char)*f.s);
}

/* Whether none of the coordinates is a number; and not all of them begin as one, as
 * 1,5 does, or stand for one. */
static bool looks_like_header(const struct layout *l, struct span text)
{
	bool unknown = true, odd = true;
	struct chosen c;

	choose(l, cut_line(l->in, text), &c);
	for (int i = 0; i < l->reads; i++) {
		struct span f;
		double v;

		if (c.times[i] == 0 ||
		    c.field[i].whole.s == c.field[i].whole.end)
			continue;
		f = trimmed(l->in, c.field[i].value);
		if (f.s < f.end && number_read(f.s, f.end, &v) == f.end)
			return false;
		unknown &= is_unknown(f);
		odd &= begins_with_digit(f);
	}
	return !unknown && !odd;
}

/* A header of one field, in which something else could separate others. */
static bool has_other_separator(struct dialect d, struct span text,
    char reason[REASON_MAX])
{
	struct cut c = cut_line(d, text);
	struct field field;

	cut_next(&c, &field);
	struct span f = field.whole;
	size_t n = (size_t)(f.end - f.s);

	if (d.separator != ',' || field.next != NULL || n == 0 || *f.s == '"')
		return false;
	if (memchr(f.s, ';', n) != NULL)
		snprintf(reason, REASON_MAX,
		    "has ; and no comma; say --separator ';'");
	else if (memchr(f.s, '\t', n) != NULL)
		snprintf(reason, REASON_MAX,
		    "has tabs and no comma; say -i tsv, or --separator tab");
	else
		return false;
	return true;
}

static bool is_named(const struct columns *c)
{
	for (int i = 0; i < c->n; i++)
		if (c->name[i] != NULL)
			return true;
	return false;
}

bool header_in_comment(struct layout *l, struct span text)
{
	const struct columns *c = &l->columns;
	bool named = false;

	if (!format_of(l->in)->header || l->header == HEADER_NONE)
		return false;
	text = header_names(l->in, text);
	for (int i = 0; i < l->reads; i++) {
		const char *name = c->by_header ? coordinate_name(i) :
						  c->name[i];

		named |= name != NULL;
		if (l->header == HEADER_MAYBE && name != NULL &&
		    find_name(l->in, text, name,
			c->by_header ? strncasecmp : strncmp) < 0)
			return false;
	}
	return named || l->header == HEADER_FIRST;
}

bool header_read(struct layout *l, struct span text, struct line *line,
    char reason[REASON_MAX])
{
	struct columns *c = &l->columns;

	text = header_names(l->in, text);
	if (c->by_header)
		c->n = 0;
	bool named = is_named(c);

	if (l->header == HEADER_NONE ||
	    (l->header == HEADER_MAYBE && !named &&
		!looks_like_header(l, text)))
		return false;
	bool found = named ? find_columns(l, text, reason) :
	    c->by_header   ? find_axes(l, text, reason) :
			     true;

	if (has_other_separator(l->in, text, reason) ||
	    (found && choose_clashes(l, cut_line(l->in, text), reason)))
		found = false;
	line->kind = found ? LINE_HEADER : LINE_LOST;
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
