/* SPDX-License-Identifier: MIT */
/* Lines that are JSON objects: where their values stand. */
#ifndef LINE_OBJECT_H
#define LINE_OBJECT_H

#include <stdbool.h>

#include "../span.h"

/* A value in an object or array. */
struct json_place {
	const char *before; /* the bracket or comma before it */
	const char *s;      /* its member's name, or itself */
	struct span value;
	const char *after; /* the comma or bracket after it */
};

/* Goes on to the next value of the object or array whose opening bracket is
 * before at first; false where there is none. Up to end it is checked text. */
bool json_place_next(struct json_place *, const char *end);

/* Finds the value to which path leads: the name of a member of the object, or a
 * pointer (RFC 6901) if it begins with /. Returns how many members of that name there
 * are, of which the last is found, as most readers of JSON do. */
int json_place_find(struct span object, const char *path, struct json_place *);

/* All of it, with its name and one of the commas beside it. */
struct span json_place_whole(const struct json_place *);

/* names_add for each member of the object. */
struct names;
void json_place_names(struct span object, struct names *);

#endif
