/* SPDX-License-Identifier: MIT */
#include "header.h"

#include <stdio.h>

#include "reason.h"

/* Skips a # before the names, but not a # that is a whole field. */
struct cursor header_cursor(struct dialect d, struct span text)
{
	const char *s = skip_blanks(d, text.s, text.end);

	if (s < text.end && *s == '#') {
		s = skip_blanks(d, s + 1, text.end);
		if (s == text.end || *s != d.separator)
			text.s = s;
	}
	struct cursor c = line_cursor(d, text);

	c.names = true;
	return c;
}

static int find_missing_name(const struct lookup *c)
{
	int i = 0;

	while (i < c->l->reads && (c->times[i] > 0 || c->l->columns.name[i] == NULL))
		i++;
	return i;
}

/* Returns whether each coordinate has one column, and added values none; says why. */
static bool is_usable(const struct lookup *c, char reason[REASON_MAX])
{
	int i = find_missing_name(c);

	if (i == c->l->reads && c->l->columns.by_default)
		for (i = 0; i < c->l->reads && c->times[i] == 1;)
			i++;
	if (i < c->l->reads) {
		reason_missing(c, i, reason);
		return false;
	}
	i = lookup_find_overlap(c);
	if (i > 0)
		snprintf(reason, REASON_MAX, "two coordinates are column %ld",
		    c->index[i] + 1);
	return i == 0 && !lookup_clashes(c, reason);
}

/* Returns whether a line is an empty field, then at least l->reads fields 0, 1, 2 ...:
 * pandas writes such a header, but the line may be a point. Then writes the reason. */
static bool is_ambiguous(const struct layout *l, struct cursor c,
    char reason[REASON_MAX])
{
	struct field f;
	int k = 0;

	for (; cursor_next(&c, &f); k++)
		if (k == 0 ? f.value.s < f.value.end : !field_is_index(f.value, k - 1))
			return false;
	if (k <= l->reads)
		return false;
	snprintf(reason, REASON_MAX,
	    "may be a header that counts the columns, or a point; say "
	    "--header --columns %.*s, or --no-header",
	    2 * l->reads - 1, "2,3,4,5");
	return true;
}

/* Counts the fields after the cursor, without a last, empty field. */
static size_t count_full(struct cursor c)
{
	size_t n = 0;
	struct field f = { .next = NULL };

	while (cursor_next(&c, &f))
		n++;
	return n - (f.value.s == f.value.end);
}

/* Returns whether n fields follow the cursor, or n fields and a last, empty field. */
static bool has_fields(struct cursor c, size_t n)
{
	return cursor_count(c) == n || count_full(c) == n;
}

bool header_is_comment(const struct layout *l, struct span text, bool first)
{
	struct lookup c;

	if (!format_of(l->in)->header)
		return true;
	const struct cursor row = line_cursor(l->in, text);

	if (!first)
		return cursor_count(row) < 2 ||
		    (!has_fields(row, l->seen.max_fields) &&
			!has_fields(row, l->seen.header_fields));
	struct cursor header = header_cursor(l->in, text);

	lookup_fields(&c, l, header);
	return header.s != text.s &&
	    (l->header == HEADER_NONE || !layout_has_names(l) ||
		find_missing_name(&c) < l->reads);
}

bool header_read(struct layout *l, struct span text, struct line *line,
    char reason[REASON_MAX])
{
	struct cursor header = header_cursor(l->in, text);
	struct columns *c = &l->columns;
	struct lookup chosen;

	const bool undecided = l->header == HEADER_MAYBE &&
	    (c->by_default || !layout_has_names(l));
	const bool ambiguous = undecided && is_ambiguous(l, header, reason);

	if (l->header == HEADER_NONE ||
	    (undecided && !ambiguous && !lookup_is_header(l, header)))
		return false;
	lookup_fields(&chosen, l, header);
	line->kind = LINE_REFUSED;
	if (ambiguous || !is_usable(&chosen, reason))
		return true;
	line->kind = LINE_HEADER;
	for (int i = 0; i < l->reads; i++)
		if (chosen.times[i] > 0)
			c->field[i] = (int)chosen.index[i];
	c->n = l->reads;
	l->seen.header_fields = l->seen.max_fields = cursor_count(header);
	l->seen.reordered = !layout_in_order(l);
	lookup_set_parts(&chosen, line);
	return true;
}

bool header_row_is_long(struct layout *l, struct cursor c, enum next_part first,
    char reason[REASON_MAX])
{
	const size_t full = count_full(c);
	const bool lacks_name = first == FIRST_ROW &&
	    full == l->seen.header_fields + 1 && full > 2;

	if (first != FIRST_NONE && full > l->seen.max_fields &&
	    (l->seen.header_fields == 0 || (!lacks_name && !layout_has_names(l))))
		l->seen.max_fields = full;
	if (full <= l->seen.max_fields || l->seen.header_fields == 0)
		return false;
	snprintf(reason, REASON_MAX, "has %zu fields and the %s %zu; %s%s", full,
	    l->seen.header_fields == l->seen.max_fields ? "header" : "first row",
	    l->seen.max_fields,
	    lacks_name ? "give each column a name, the first, too" :
			 "quote a field that has the separator in it",
	    l->in.separator == ',' ? ", or write 1.5 for 1,5" : "");
	return true;
}
