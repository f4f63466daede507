/* SPDX-License-Identifier: MIT */
/* A refusal is a value: what is wrong with a scene or a line of points, where, and what
 * would be right. Whoever finds it adds it to a list that the caller owns, and returns
 * false; whoever called hands the false on; the command prints the list. A refusal owns
 * its text, so that it outlives what it is about.
 *
 * A function whose last parameter is a list of refusals returns false only if it has
 * refused something, and then has added to the list. The list may be NULL if nobody is
 * going to read it. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

struct refusal {
	/* The JSON pointer of a member, such as /camera/up; or "". The longest that
	 * core makes has 98 tokens "/63/inverse". */
	char where[1280];
	char what[320]; /* what is wrong, as "parallel to the gaze" */
	/* what would be right, as "choose another up vector"; or "" */
	char remedy[576];
	/* The line, from 1, and the column, in bytes from 1; or 0, if only the pointer
	 * says where. */
	long long line;
	size_t column;
};

/* The most refusals that a list keeps; it counts all. */
enum { REFUSALS_MAX = 100 };

struct refusals {
	size_t n; /* of these the first REFUSALS_MAX are kept */
	struct refusal list[REFUSALS_MAX];
};

/* Sets the parts of a refusal to copies, cut at a character where they do not fit.
 * `where` and `remedy` may be NULL. */
void refusal_set(struct refusal *, const char *where, const char *what,
    const char *remedy);

/* Adds a refusal to the list, if there is one, unless the list has the same of the
 * same pointer; or counts it if the list is full. Returns false. */
bool refuse(struct refusals *, const char *where, const char *what, const char *remedy);
bool refuse_at(struct refusals *, const char *where, const char *what,
    const char *remedy, long long line, size_t column);

/* Returns whether the list has a refusal with these parts of the same pointer, which is
 * not "". */
bool refusals_have(const struct refusals *, const char *where, const char *what,
    const char *remedy);
