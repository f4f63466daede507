/* SPDX-License-Identifier: MIT */
/* The paths from a JSON value to coordinates, by names and indexes with / between. */
#pragma once

#include <stdint.h>
#include <string.h>

#include "../message/utf8.h"

/* path[i] leads to coordinate i. Its first name or index has size[i] bytes; SIZE_MAX:
 * coordinate i is elsewhere. */
struct walk_paths {
	const char *path[4];
	size_t size[4];
};

static inline struct walk_paths paths_inside(const struct walk_paths *t, unsigned leads)
{
	struct walk_paths rest;

	for (int i = 0; i < 4; i++) {
		bool set = (leads >> i & 1) != 0;

		rest.path[i] = set ? t->path[i] + t->size[i] + 1 : "";
		rest.size[i] = set ? strcspn(rest.path[i], "/") : SIZE_MAX;
	}
	return rest;
}

/* Returns the coordinate whose path ends at the field with this name or index, or
 * -1. Sets bit i of *leads if path i leads to the field or into it. */
static inline __attribute__((always_inline)) int
follow_paths(const struct walk_paths *t, int n, struct span name, unsigned *leads)
{
	size_t size = (size_t)(name.end - name.s);

	*leads = 0;
	for (int i = 0; i < n; i++) {
		const char *path = t->path[i];

		if (t->size[i] != size || *path != *name.s ||
		    (size > 1 && memcmp(path, name.s, size) != 0))
			continue;
		*leads |= 1u << i;
		if (path[size] != '/')
			return i;
	}
	return -1;
}
