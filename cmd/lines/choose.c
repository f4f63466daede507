/* SPDX-License-Identifier: MIT */
#include "line.h"

#include <limits.h>
#include <stdio.h>
#include <strings.h>

#include "../json/text.h"

struct cut cut_value(struct span value, const char *end)
{
	const char *s = json_skip_blanks(value.s + 1, end);

	return (struct cut){ .in = { FORMAT_JSON, ',' },
		.s = *s == ']' || *s == '}' ? NULL : s,
		.end = end,
		.bracket = value.s + 1,
		.members = *value.s == '{' };
}

struct cut cut_line(struct dialect in, struct span line)
{
	if (*format_of(in)->open != '\0')
		return cut_value(trimmed(in, line), line.end);
	return (struct cut){ .in = in, .s = line.s, .end = line.end };
}

bool cut_next(struct cut *c, struct field *f)
{
	if (c->s == NULL)
		return false;
	f->name.s = NULL;
	f->open = false;
	f->from = c->from;
	f->comma = c->comma;
	format_of(c->in)->next(c, f);
	c->s = f->next;
	return true;
}

size_t cut_count(struct cut c)
{
	struct field f;
	size_t n = 0;

	while (cut_next(&c, &f))
		n++;
	return n;
}

/* The way from a value to a coordinate or name that is sought: a name or pointer; if
 * path is NULL, the number of a field, or -1 if there is no way. */
struct way {
	const char *path;
	long place;
};

static const struct way nowhere = { NULL, -1 };

bool is_index(struct span token, long k)
{
	for (; k >= 10 && token.end > token.s && token.end[-1] == '0' + k % 10;
	     k /= 10)
		token.end--;
	return k < 10 && token.end - token.s == 1 && *token.s == '0' + k;
}

/* Returns whether path, that of i, leads to field k of the cut or into its value; sets
 * *rest to the rest of the path. Without --columns, X is x in a header, too. */
static bool leads_to(const struct layout *l, const char *path, int i,
    const struct cut *c, const struct field *f, long k, const char **rest)
{
	bool pointer = *path == '/' && !c->names;

	path += pointer;
	size_t n = pointer ? strcspn(path, "/") : strlen(path);
	struct span token = { path, path + n };

	*rest = token.end;
	if (c->names)
		return (size_t)(f->value.end - f->value.s) == n &&
		    (i < 4 && l->columns.by_header ?
			    strncasecmp(f->value.s, path, n) :
			    strncmp(f->value.s, path, n)) == 0;
	return c->members ? json_is_name(f->name, token, pointer) :
			    pointer && is_index(token, k);
}

/* Returns whether the field f, after the last coordinate, may be the decimals of a
 * number with a decimal comma: f is a number, and follows two coordinates, or a comma
 * without a blank. Its separator must then be like those between the coordinates. */
static bool counts_on(const struct layout *l, const struct field *f)
{
	double v;

	return number_read(f->value.s, f->value.end, &v) == f->value.end &&
	    (l->reads == 2 || (f->value.s == f->from + 1 && *f->from == ','));
}

/* What is sought on a line, and the fields that matter: those up to last. In text the
 * separators count, and after the last coordinate one that counts_on. */
struct search {
	const struct layout *l;
	int n; /* things that are sought */
	bool text;
	long last;
	int separators, commas;
	struct chosen *out;
};

/* Finds what is sought among the fields of a cut. Enters each value once, for all ways
 * that lead into it, so that the time is linear in the length of the line. */
static void choose_in(struct search *r, struct cut c,
    const struct way ways[SOUGHT])
{
	struct chosen *out = r->out;
	int seen[SOUGHT] = { 0 };
	struct field f;

	for (long k = 0; k <= r->last && cut_next(&c, &f); k++) {
		struct way inside[SOUGHT];
		bool led = false;

		for (int i = 0; i < r->n; i++) {
			const char *path = ways[i].path, *rest = "";

			inside[i] = nowhere;
			if (path == NULL ?
				ways[i].place != k :
				!leads_to(r->l, path, i, &c, &f, k, &rest))
				continue;
			seen[i]++;
			if (*rest != '\0') {
				inside[i].path = rest;
				led = true;
			} else if (out->times[i]++ == 0) {
				out->field[i] = f;
				out->place[i] = k;
			} else if (out->times[i] == 2) {
				out->again[i] = k;
			}
		}
		if (led && (*f.value.s == '{' || *f.value.s == '['))
			choose_in(r, cut_value(f.value, c.end), inside);
		if (r->text && k > 0 && f.value.s < c.end &&
		    (k < r->last || counts_on(r->l, &f))) {
			r->separators++;
			r->commas += f.comma;
		}
	}
	for (int i = 0; i < r->n; i++)
		if (seen[i] > 1 && out->times[i] < 2)
			out->times[i] = 2;
}

void choose(const struct layout *l, struct cut c, struct chosen *out)
{
	const bool named = c.members || c.names ||
	    (c.bracket != NULL && l->columns.n > 0);
	struct way ways[SOUGHT];
	struct search r = { .l = l,
		.n = c.names || (l->append && c.members) ? SOUGHT : l->reads,
		.text = format_of(c.in)->blanks && !named,
		.last = named ? LONG_MAX : -1,
		.out = out };

	memset(out->times, 0, sizeof out->times);
	for (int i = 0; i < l->reads; i++) {
		long place = layout_field(l, i);

		ways[i].path = named ? l->columns.name[i] : NULL;
		ways[i].place = place;
		r.last = place > r.last ? place : r.last;
	}
	for (int i = l->reads; i < r.n; i++) {
		ways[i] = nowhere;
		if (i >= 4 && *l->name[i - 4] != '\0' &&
		    (l->append ||
			(i - 4 >= l->reads && format_of(l->out)->header)))
			ways[i].path = l->name[i - 4];
	}
	r.last += r.text;
	choose_in(&r, c, ways);
	out->mixed = r.commas != 0 && r.commas != r.separators;
}

int choose_overlap(const struct layout *l, const struct chosen *c)
{
	for (int i = 1; i < l->reads; i++)
		for (int k = 0; k < i; k++)
			if (c->times[i] > 0 && c->times[k] > 0 &&
			    c->field[i].value.s <= c->field[k].value.end &&
			    c->field[k].value.s <= c->field[i].value.end)
				return i;
	return 0;
}

void choose_places(const struct layout *l, const struct chosen *c,
    struct line *line)
{
	bool whole = line->kind != LINE_POINT && format_of(l->in)->header;

	for (int i = 0; i < l->reads; i++) {
		const struct field *f = &c->field[i];

		/* in csv nan replaces the quotes of a bad number, too */
		line->at[i] = c->times[i] == 0 ? part_missing :
		    !whole                     ? line_part(line, f->value) :
			     line_part(line, trimmed(l->in, f->whole));
	}
}

bool choose_clashes(const struct layout *l, const struct chosen *c,
    bool members, char reason[REASON_MAX])
{
	int i = 4;

	while (i < SOUGHT && c->times[i] == 0)
		i++;
	if (i < SOUGHT)
		snprintf(reason, REASON_MAX,
		    "%s '%s', which %s adds; give it another name",
		    members ? "has a member" : "the header has a column",
		    l->name[i - 4], l->append ? "--append" : "the output");
	return i < SOUGHT;
}
