/* SPDX-License-Identifier: MIT */
#include "refusal.h"

#include <string.h>

static void copy_cut(char *to, size_t room, const char *s)
{
	size_t n = s != NULL ? strlen(s) : 0;

	n = n < room ? n : room - 1;
	while (n > 0 && (s[n] & 0xc0) == 0x80) /* within a character of UTF-8 */
		n--;
	if (n > 0)
		memcpy(to, s, n);
	to[n] = '\0';
}

void refusal_set(struct refusal *r, const char *where, const char *what,
    const char *remedy)
{
	copy_cut(r->where, sizeof r->where, where);
	copy_cut(r->what, sizeof r->what, what);
	copy_cut(r->remedy, sizeof r->remedy, remedy);
	r->line = 0;
	r->column = 0;
}

static bool are_equal(const struct refusal *a, const struct refusal *b)
{
	const bool has_pointer = *a->where != '\0';

	return (has_pointer || (a->line == b->line && a->column == b->column)) &&
	    strcmp(a->where, b->where) == 0 && strcmp(a->what, b->what) == 0 &&
	    strcmp(a->remedy, b->remedy) == 0;
}

static bool has_equal(const struct refusals *faults, const struct refusal *r)
{
	for (size_t i = 0; i < faults->n && i < REFUSALS_MAX; i++)
		if (are_equal(&faults->list[i], r))
			return true;
	return false;
}

bool refusals_have(const struct refusals *faults, const char *where, const char *what,
    const char *remedy)
{
	struct refusal r;

	refusal_set(&r, where, what, remedy);
	return *r.where != '\0' && has_equal(faults, &r);
}

bool refuse_at(struct refusals *faults, const char *where, const char *what,
    const char *remedy, long long line, size_t column)
{
	struct refusal r;

	if (faults == NULL)
		return false;
	if (faults->n >= REFUSALS_MAX) {
		faults->n++;
		return false;
	}
	refusal_set(&r, where, what, remedy);
	r.line = line;
	r.column = column;
	if (!has_equal(faults, &r))
		faults->list[faults->n++] = r;
	return false;
}

bool refuse(struct refusals *faults, const char *where, const char *what,
    const char *remedy)
{
	return refuse_at(faults, where, what, remedy, 0, 0);
}
