/* SPDX-License-Identifier: MIT */
#include "lookup.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <strings.h>

#include "../json/text.h"

/* A route to a field: its name or JSON pointer, or else its index; -1: to none. */
struct route {
	const char *path;
	long index;
};

bool field_is_index(struct span token, long k)
{
	for (; k >= 10 && token.end > token.s && token.end[-1] == '0' + k % 10; k /= 10)
		token.end--;
	return k < 10 && token.end - token.s == 1 && *token.s == '0' + k;
}

/* Returns whether the route for element i of struct lookup leads to or into f, field k.
 * Sets *rest to the path within the value, or to "". In a header the default name x
 * also matches X and, for points in a space named device, device_x and device_X. */
static bool leads_to(const struct layout *l, const struct route *route, int i,
    const struct cursor *c, const struct field *f, long k, const char **rest)
{
	const char *path = route->path;

	*rest = "";
	if (path == NULL)
		return route->index == k;
	bool pointer = *path == '/' && !c->names;

	path += pointer;
	size_t n = pointer ? strcspn(path, "/") : strlen(path);
	struct span token = { path, path + n };

	*rest = token.end;
	if (c->names) {
		const bool by_default = i < 4 && l->columns.by_default;
		const char *s = f->value.s, *space = by_default ? l->from : NULL;
		const size_t from = space != NULL ? strlen(space) : 0;

		if (from > 0 && (size_t)(f->value.end - s) > from &&
		    memcmp(s, space, from) == 0 && s[from] == '_')
			s += from + 1;
		return (size_t)(f->value.end - s) == n &&
		    (by_default ? strncasecmp : strncmp)(s, path, n) == 0;
	}
	return c->members ? json_is_name(f->name, token, pointer) :
			    pointer && field_is_index(token, k);
}

/* Returns whether mixed_commas depends on the separator before f, field k of a line of
 * text: up to the last coordinate, or after it if f, a number, may be its decimals, of
 * two coordinates or behind a comma without blanks. */
static bool separator_counts(const struct lookup *r, const struct field *f, long k,
    const char *end)
{
	double v;

	if (!r->text || k == 0 || f->value.s == end)
		return false;
	return k < r->last ||
	    (number_read(f->value.s, f->value.end, &v) == f->value.end &&
		(r->l->reads == 2 ||
		    (f->value.s == f->previous_end + 1 && *f->previous_end == ',')));
}

/* Enters each value once, for all routes into it, so that the time is linear. */
static void search_fields(struct lookup *r, struct cursor c,
    const struct route routes[SOUGHT_MAX])
{
	int fields[SOUGHT_MAX] = { 0 }; /* how many fields routes[i] leads to */
	struct field f;

	for (long k = 0; k <= r->last && cursor_next(&c, &f); k++) {
		struct route inside[SOUGHT_MAX];
		bool enter = false;

		for (int i = 0; i < r->n; i++) {
			const char *rest;

			inside[i] = (struct route){ .index = -1 };
			if (!leads_to(r->l, &routes[i], i, &c, &f, k, &rest))
				continue;
			fields[i]++;
			if (*rest != '\0') {
				inside[i].path = rest;
				enter = true;
			} else if (r->times[i]++ == 0) {
				r->field[i] = f;
				r->index[i] = k;
			} else if (r->times[i] == 2) {
				r->second_index[i] = k;
			}
		}
		if (enter && (*f.value.s == '{' || *f.value.s == '['))
			search_fields(r, value_cursor(f.value, c.end), inside);
		if (separator_counts(r, &f, k, c.end)) {
			r->separators++;
			r->commas += f.comma;
		}
	}
	for (int i = 0; i < r->n; i++)
		if (fields[i] > 1 && r->times[i] < 2)
			r->times[i] = 2;
}

void lookup_fields(struct lookup *r, const struct layout *l, struct cursor c)
{
	const bool named = c.members || c.names ||
	    (c.bracket != NULL && l->columns.n > 0);
	struct route routes[SOUGHT_MAX];

	r->l = l;
	r->c = c;
	r->n = c.names || (l->output.append && c.members) ? SOUGHT_MAX : l->reads;
	r->text = format_of(c.in)->blanks && !named;
	r->last = named ? LONG_MAX : -1;
	r->separators = r->commas = 0;
	memset(r->times, 0, sizeof r->times);
	for (int i = 0; i < l->reads; i++) {
		long k = layout_field(l, i);

		routes[i].path = named ? l->columns.name[i] : NULL;
		routes[i].index = k;
		r->last = k > r->last ? k : r->last;
	}
	for (int i = l->reads; i < r->n; i++) {
		routes[i] = (struct route){ .index = -1 };
		if (i >= 4 && *l->output.name[i - 4] != '\0' &&
		    (l->output.append ||
			(i - 4 >= l->reads && format_of(l->out)->header)))
			routes[i].path = l->output.name[i - 4];
	}
	r->last += r->text;
	search_fields(r, c, routes);
	r->mixed_commas = r->commas != 0 && r->commas != r->separators;
}

int lookup_find_overlap(const struct lookup *c)
{
	for (int i = 1; i < c->l->reads; i++)
		for (int k = 0; k < i; k++)
			if (c->times[i] > 0 && c->times[k] > 0 &&
			    c->field[i].value.s <= c->field[k].value.end &&
			    c->field[k].value.s <= c->field[i].value.end)
				return i;
	return 0;
}

void lookup_set_parts(const struct lookup *c, struct line *line)
{
	const struct layout *l = c->l;
	bool whole = line->kind != LINE_POINT && format_of(l->in)->header;

	for (int i = 0; i < l->reads; i++) {
		const struct field *f = &c->field[i];

		/* in a bad line of csv, nan replaces a coordinate and its quotes */
		line->at[i] = c->times[i] == 0 ? part_missing :
		    !whole                     ? line_part(line, f->value) :
			     line_part(line, trimmed(l->in, f->whole));
	}
}

bool lookup_clashes(const struct lookup *c, char reason[REASON_MAX])
{
	const struct output *added = &c->l->output;
	int i = 4;

	while (i < SOUGHT_MAX && c->times[i] == 0)
		i++;
	if (i < SOUGHT_MAX)
		snprintf(reason, REASON_MAX,
		    "%s '%s', which %s adds; give it another name",
		    c->c.members ? "has a member" : "the header has a column",
		    added->name[i - 4], added->append ? "--append" : "the output");
	return i < SOUGHT_MAX;
}

bool field_is_name(struct span f)
{
	unsigned c = 0;

	for (int n = 1; f.s < f.end; f.s += n) {
		n = utf8_read(f.s, f.end, &c);
		if (n == 0 || c == '_' || (c | 32) - 'a' < 26u ||
		    (c >= 0xc0 && (c < 0x2000 || c >= 0x2c00)))
			return true;
		if (c == '.' || c - '0' < 10u)
			return false;
	}
	return true;
}

bool lookup_is_header(const struct layout *l, struct cursor header)
{
	bool has_name = false;
	struct lookup c;

	header.names = false; /* find coordinates by index, as in a row */
	lookup_fields(&c, l, header);
	for (int i = 0; i < l->reads; i++) {
		const struct span f = c.field[i].value;
		double v;

		if (c.times[i] == 0)
			continue;
		if (format_read(l->in, f.s, f.end, &v) != f.end)
			has_name |= field_is_name(f);
		else if (!isnan(v))
			return false;
	}
	return has_name;
}
