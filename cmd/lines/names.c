/* SPDX-License-Identifier: MIT */
#include "names.h"

#include <stdio.h>

#include "../message/escape.h"
#include "../message/nearest.h"

void names_add(struct names *names, struct span name)
{
	size_t n = (size_t)(name.end - name.s);

	if (names->n == NAMES_MAX || n >= NAME_ROOM) {
		names->left_out++;
		return;
	}
	memcpy(names->name[names->n], name.s, n);
	names->name[names->n++][n] = '\0';
}

/* Writes to the end of the reason, as far as there is room. */
static void add(char reason[REASON_MAX], const char *before, const char *name,
    const char *after)
{
	char shown[ESCAPED_MAX];
	size_t n = strlen(reason);

	snprintf(reason + n, REASON_MAX - n, "%s%s%s", before,
	    escaped(shown, name, strlen(name)), after);
}

void names_say(const struct names *names, const char *wanted,
    char reason[REASON_MAX])
{
	const int room = REASON_MAX - ESCAPED_MAX - 8;
	const char *list[NAMES_MAX + 1], *near;
	int i;

	if (names->n + names->left_out == 0)
		return;
	for (i = 0; i < names->n; i++)
		list[i] = names->name[i];
	list[i] = NULL;
	near = nearest(wanted, list);
	if (near != NULL)
		add(reason, "; did you mean '", near, "'? it has ");
	else
		add(reason, "; it has ", "", "");
	for (i = 0; i < names->n && (int)strlen(reason) < room; i++)
		add(reason, i > 0 ? ", " : "", names->name[i], "");
	if (i < names->n || names->left_out > 0)
		add(reason, i > 0 ? ", ..." : "...", "", "");
}
