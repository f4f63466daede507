/* SPDX-License-Identifier: MIT */
#include "line.h"

#include <limits.h>
#include <stdio.h>

#include "../json/text.h"

/* The path to each coordinate from a value; NULL if the path does not lead into it. */
struct paths {
	const char *to[4];
};

bool is_index(struct span token, long k)
{
	for (; k >= 10 && token.end > token.s && token.end[-1] == '0' + k % 10;
	     k /= 10)
		token.end--;
	return k < 10 && token.end - token.s == 1 && *token.s == '0' + k;
}

/* Returns whether the path, a name or a pointer, leads to field k of the cut or into its
 * value; sets *rest to the rest of the path. */
static bool leads_to(const char *path, const struct cut *c,
    const struct field *f, long k, const char **rest)
{
	bool pointer = *path == '/';

	path += pointer;
	*rest = path + (pointer ? strcspn(path, "/") : strlen(path));
	struct span token = { path, *rest };

	return c->members ? json_is_name(f->name, token, pointer) :
			    pointer && is_index(token, k);
}

/* Finds the values at the ends of the paths. Enters each value once, for all paths that
 * lead into it, so that the time is linear in the length of the line. */
static void choose_by_path(struct cut c, int reads, const struct paths *paths,
    struct chosen *out)
{
	int seen[4] = { 0 };
	struct field f;

	for (long k = 0; cut_next(&c, &f); k++) {
		struct paths inside = { { NULL } };
		bool more = false;

		for (int i = 0; i < reads; i++) {
			const char *rest;

			if (paths->to[i] == NULL ||
			    !leads_to(paths->to[i], &c, &f, k, &rest))
				continue;
			seen[i]++;
			if (*rest != '\0') {
				inside.to[i] = rest;
				more = true;
				continue;
			}
			out->field[i] = f;
			out->times[i] = seen[i];
		}
		if (more && (*f.value.s == '{' || *f.value.s == '['))
			choose_by_path(cut_value(f.value, c.end), reads,
			    &inside, out);
	}
	for (int i = 0; i < reads; i++)
		if (seen[i] > 1)
			out->times[i] = seen[i];
}

/* Returns whether the field f, after the last coordinate, may be the decimals of a number
 * with a decimal comma: f is a number, and follows two coordinates, or a comma without a
 * blank. Its separator must then be like those between the coordinates. */
static bool counts_on(const struct layout *l, const struct field *f)
{
	double v;

	return number_read(f->value.s, f->value.end, &v) == f->value.end &&
	    (l->reads == 2 || (f->value.s == f->from + 1 && *f->from == ','));
}

static void choose_by_place(const struct layout *l, struct cut c,
    struct chosen *out)
{
	int place[4], first = INT_MAX, last = -1, commas = 0, separators = 0;
	bool text = format_of(l->in)->blanks;
	struct field f;

	for (int i = 0; i < l->reads; i++) {
		place[i] = l->columns.n > 0 ? l->columns.field[i] : i;
		first = place[i] < first ? place[i] : first;
		last = place[i] > last ? place[i] : last;
	}
	for (int k = 0; k <= last + text && cut_next(&c, &f); k++) {
		for (int i = 0; i < l->reads; i++)
			if (k == place[i]) {
				out->field[i] = f;
				out->times[i] = 1;
			}
		if (text && k > first && f.value.s < c.end &&
		    (k <= last || counts_on(l, &f))) {
			separators++;
			commas += f.comma;
		}
	}
	out->mixed = commas != 0 && commas != separators;
}

void choose(const struct layout *l, struct cut c, struct chosen *out)
{
	struct paths paths = { { NULL } };
	bool by_path = c.members ||
	    (c.bracket != NULL && l->columns.n > 0 &&
		l->columns.name[0] != NULL);

	memset(out->times, 0, sizeof out->times);
	out->mixed = false;
	for (int i = 0; i < l->reads && by_path; i++)
		paths.to[i] = l->columns.name[i];
	if (by_path)
		choose_by_path(c, l->reads, &paths, out);
	else
		choose_by_place(l, c, out);
}

bool choose_overlaps(const struct layout *l, const struct chosen *c)
{
	for (int i = 1; i < l->reads; i++)
		for (int k = 0; k < i; k++)
			if (c->times[i] > 0 && c->times[k] > 0 &&
			    c->field[i].value.s < c->field[k].value.end &&
			    c->field[k].value.s < c->field[i].value.end)
				return true;
	return false;
}

size_t choose_count(struct cut c)
{
	struct field f;
	size_t n = 0;

	while (cut_next(&c, &f))
		n++;
	return n;
}

bool choose_clashes(const struct layout *l, struct cut c,
    char reason[REASON_MAX])
{
	struct field f;

	while (l->append && cut_next(&c, &f))
		for (int k = 0; k <= COORDINATES_MAX; k++) {
			struct span added = { l->name[k],
				l->name[k] + strlen(l->name[k]) };
			struct span s = trimmed(c.in, f.value);
			size_t n = (size_t)(added.end - added.s);

			if (n == 0 ||
			    !(c.members ? json_is_name(f.name, added, false) :
					  (size_t)(s.end - s.s) == n &&
					memcmp(s.s, added.s, n) == 0))
				continue;
			snprintf(reason, REASON_MAX,
			    "%s '%s', which --append adds; give it another "
			    "name",
			    c.members ? "has a member" :
					"the header has a column",
			    added.s);
			return true;
		}
	return false;
}

bool choose_may_clash(const struct layout *l, struct span line)
{
	size_t size = (size_t)(line.end - line.s);

	if (memchr(line.s, '\\', size) != NULL)
		return true;
	/* every other name that is added has a _ */
	if (!l->flags && l->writes <= 4 && memchr(line.s, '_', size) == NULL)
		return false;
	while ((line.s = memchr(line.s, '"', size)) != NULL) {
		size = (size_t)(line.end - ++line.s);
		for (int k = 0; k <= COORDINATES_MAX; k++)
			if (size > 0 && *line.s == l->name[k][0] &&
			    strncmp(line.s, l->name[k], strlen(l->name[k])) ==
				0)
				return true;
	}
	return false;
}
