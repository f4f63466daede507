/* SPDX-License-Identifier: MIT */
/* Cuts a JSON list, which may have any number of lines, into its elements, each of
 * which becomes a line. The bytes come in parts of any size. */
#pragma once

#include "cut.h"

enum list_state {
	LIST_BEGIN,   /* before the [ */
	LIST_FIRST,   /* before the first element or the ] */
	LIST_ELEMENT, /* in an array or object */
	LIST_SCALAR,  /* in another value */
	LIST_AFTER,   /* before a comma or the ] */
	LIST_NEXT,    /* after a comma */
	LIST_END,     /* after the ] */
};

/* Where an element begins in the source: its line and its column in bytes, from 1. */
struct list_place {
	long long line;
	size_t column;
	bool joined; /* the element has several lines */
};

struct list {
	enum list_state state;
	int level;      /* the open brackets of the element */
	bool quoted;    /* in a string */
	bool escaped;   /* after a backslash in a string */
	bool skips;     /* blanks after a line end are left out */
	long long line; /* the number of the line, from 1 */
	size_t done;    /* bytes of the list before the part that is cut, */
	size_t begin;   /* and before the line */
	struct list_place from;
};

enum { LIST_MARGIN = 64 };

/* Where the elements go. The owner of the members gives room before each call. */
struct list_lines {
	char *text;        /* has room for all bytes of the part and LIST_MARGIN more */
	size_t size;       /* bytes of text */
	size_t whole_size; /* bytes of elements that are whole */
	/* of each element; has room for half of the bytes of the part and one */
	struct list_place *place;
	size_t n; /* elements that are whole */
};

/* Cuts n bytes, or the end of the source if n is 0. Returns false at a fault, which
 * ends the list. */
bool list_cut(struct list *, const char *s, size_t n, struct list_lines *,
    struct refusal *);

/* Returns whether the line that an input of JSON begins with begins a list. `complete`
 * says that all of it is there; *known becomes false if more of it has to be. */
bool list_begins(struct span line, bool complete, bool *known);
