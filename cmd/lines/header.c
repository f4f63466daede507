/* SPDX-License-Identifier: MIT */
#include "line.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>

/* A # before a separator is a field and not the beginning of a comment; but if blanks
 * separate fields, "# x y z" is a comment. */
struct cut header_cut(struct dialect d, struct span text)
{
	const char *s = text.s, *after = skip_blanks(d, s, text.end);
	const bool mark = after < text.end && *after == '#';

	after += mark;
	while (
	    mark && d.separator == ' ' && after < text.end && is_blank(*after))
		after++;
	const char *next = skip_blanks(d, after, text.end);

	if (mark &&
	    (d.separator == ' ' || next == text.end || *next != d.separator))
		s = after;
	struct cut c = cut_line(d, (struct span){ s, text.end });

	c.names = true;
	return c;
}

/* Returns the first coordinate whose name the header lacks, or l->reads. */
static int find_missing(const struct layout *l, const struct chosen *c)
{
	int i = 0;

	while (i < l->reads && (c->times[i] > 0 || l->columns.name[i] == NULL))
		i++;
	return i;
}

/* Returns whether the header says where the coordinates are; else writes the reason. */
static bool is_clear(const struct layout *l, struct cut header,
    const struct chosen *c, char reason[REASON_MAX])
{
	int i = find_missing(l, c);

	if (i == l->reads && l->columns.by_header)
		for (i = 0; i < l->reads && c->times[i] == 1;)
			i++;
	if (i < l->reads) {
		say_missing(l, i, header, c, reason);
		return false;
	}
	i = choose_overlap(l, c);
	if (i > 0)
		snprintf(reason, REASON_MAX, "two coordinates are column %ld",
		    c->place[i] + 1);
	return i == 0 && !choose_clashes(l, c, false, reason);
}

/* Returns whether the line may be a header or a point: an empty field and then 0, 1, 2
 * and so on, as pandas names the columns of an array. Writes the reason. */
static bool is_counted(const struct layout *l, struct cut c,
    char reason[REASON_MAX])
{
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

static bool begins_with_digit(struct span f)
{
	f.s += f.s < f.end && (*f.s == '-' || *f.s == '+');
	f.s += f.s < f.end && *f.s == '.';
	return f.s < f.end && isdigit((unsigned char)*f.s);
}

/* Returns false if a coordinate is a number, if all coordinates are missing values, or
 * if all begin with a digit, as numbers with decimal commas do. */
static bool looks_like_header(const struct layout *l, struct cut header)
{
	bool unknown = true, odd = true;
	struct chosen c;

	header.names = false; /* if it is a row, it has no names */
	choose(l, header, &c);
	for (int i = 0; i < l->reads; i++) {
		struct span f = c.field[i].value;
		double v;

		if (c.times[i] == 0)
			continue;
		if (format_number(l->in, f.s, f.end, &v) != f.end)
			unknown = false;
		else if (!isnan(v))
			return false;
		odd &= begins_with_digit(f);
	}
	return !unknown && !odd;
}

bool header_in_comment(const struct layout *l, struct span text, bool first)
{
	const char *s = skip_blanks(l->in, text.s, text.end);
	struct chosen c;

	if (!format_of(l->in)->header)
		return true;
	const size_t n = cut_count(cut_line(l->in, text));

	if (!first) /* where blanks separate, "# x y z" is a comment */
		return n < 2 || (n != l->most && n != l->fields) ||
		    (l->in.separator == ' ' && is_blank(s[1]));
	struct cut header = header_cut(l->in, text);

	choose(l, header, &c);
	return header.s != text.s &&
	    (l->header == HEADER_NONE || !layout_is_named(l) ||
		find_missing(l, &c) < l->reads);
}

bool header_read(struct layout *l, struct span text, struct line *line,
    char reason[REASON_MAX])
{
	struct cut header = header_cut(l->in, text);
	struct columns *c = &l->columns;
	struct chosen chosen;

	l->fields = l->most = 0;
	if (c->by_header)
		c->n = 0;
	const bool maybe = l->header == HEADER_MAYBE &&
	    (c->by_header || !layout_is_named(l));
	const bool counted = maybe && is_counted(l, header, reason);

	if (l->header == HEADER_NONE ||
	    (maybe && !counted && !looks_like_header(l, header)))
		return false;
	choose(l, header, &chosen);
	line->kind = LINE_REFUSED;
	if (counted || !is_clear(l, header, &chosen, reason))
		return true;
	line->kind = LINE_HEADER;
	for (int i = 0; i < l->reads; i++)
		if (chosen.times[i] > 0)
			c->field[i] = (int)chosen.place[i];
	c->n = l->reads;
	l->fields = l->most = cut_count(header);
	l->moved = !layout_is_first(l);
	choose_places(l, &chosen, line);
	return true;
}

bool header_is_short(struct layout *l, struct cut c, enum first first,
    char reason[REASON_MAX])
{
	bool blanks = false;
	size_t n = 0;
	struct field f = { .next = NULL };

	for (; cut_next(&c, &f); n++)
		blanks |= say_blanks(l, &f, reason);
	if (first != FIRST_IS_READ && n > l->most &&
	    (l->fields == 0 || !layout_is_named(l)))
		l->most = n;
	n -= f.value.s == f.value.end;
	if (n <= l->most || l->fields == 0)
		return false;
	if (!blanks)
		snprintf(reason, REASON_MAX,
		    "has %zu fields and the %s %zu; %s%s", n,
		    l->fields == l->most ? "header" : "first row", l->most,
		    first == FIRST_ROW && n == l->most + 1 ?
			"name the first column, too, or number --columns" :
			"quote a field that has the separator in it",
		    l->in.separator == ',' ? ", or write 1.5 for 1,5" : "");
	return true;
}
