/* SPDX-License-Identifier: MIT */
#include "refusal.h"

#include <string.h>

static void copy_cut(char *to, size_t room, const char *s)
{
	size_t n = s != NULL ? strlen(s) : 0;

	n = n < room ? n : room - 1;
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

bool refuse(struct refusals *faults, const char *where, const char *what,
    const char *remedy)
{
	if (faults == NULL)
		return false;
	if (faults->n < REFUSALS_MAX)
		refusal_set(&faults->list[faults->n], where, what, remedy);
	faults->n++;
	return false;
}
