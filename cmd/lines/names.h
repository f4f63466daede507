/* SPDX-License-Identifier: MIT */
/* Names that a table has, for messages about one that it hasn't. */
#ifndef NAMES_H
#define NAMES_H

#include "line.h"

enum { NAMES_MAX = 32, NAME_ROOM = 64 };

struct names {
	int n, left_out; /* kept, and those that are too many or too long */
	char name[NAMES_MAX][NAME_ROOM];
};

void names_add(struct names *, struct span name);

/* Writes "; did you mean 'x'? it has x, y, z" to the end of the reason. */
void names_say(const struct names *, const char *wanted,
    char reason[REASON_MAX]);

#endif
