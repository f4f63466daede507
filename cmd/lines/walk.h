/* SPDX-License-Identifier: MIT */
/* Reads simple lines fast, many at once. The index of a stretch of text lists the
 * stops, which are the bytes that can end a field. A walk goes from stop to stop and
 * finds the coordinates without looking at the bytes between the stops; vector code
 * then reads many numbers at once. A line that is not simple is left to line_read. */
#ifndef WALK_H
#define WALK_H

#include "../number/vector/loops.h"
#include "line.h"

/* The most bytes of a stretch. A stretch of this size stays in the first-level cache
 * until its numbers are read, and the place of a stop fits into 16 bits. */
enum { STRETCH_MAX = 1 << 14 };

/* A stretch of text with its index. Places are counted in bytes from text. */
struct stretch {
	const char *readable; /* vector code may read from here on */
	const char *text;     /* the beginning of the stretch */
	uint32_t at;          /* the place of the next line */
	uint32_t end;         /* the place after the last line */
	const uint16_t *next; /* the first stop at or after `at` */
	uint16_t stop[STRETCH_MAX + 128]; /* the places of the stops */
};

/* path[i] leads from a JSON value to coordinate i, by names and indexes with / between.
 * The first name or index has size[i] bytes; SIZE_MAX: coordinate i is elsewhere. */
struct walk_paths {
	const char *path[4];
	size_t size[4];
};

/* The properties of simple lines, and the way to their n coordinates. */
struct walk {
	struct dialect in;
	struct byte_set stops;
	int n;
	int exact_fields; /* fields that a line must have; 0: up to max_fields */
	int max_fields;   /* the most fields of a row of csv */
	bool arrays;      /* lines may be JSON arrays */
	bool objects;     /* lines may be JSON objects */
	struct walk_paths paths; /* the paths to the coordinates in an object */
	/* NULL or, by --append, the names that an object must not have */
	const char (*added_names)[NAME_ROOM];
	bool by_column; /* coordinate i is in column field[i], else column i */
	int field[4];
};

/* Sets the walk for a layout. Returns false if no line of the layout is simple. */
bool walk_plan(const struct layout *, struct walk *);

/* Begins a stretch at text and makes its index. Returns false if it has no newline. */
bool stretch_open(struct stretch *, const struct walk *, const char *text,
    const char *end);

/* Walks up to n <= PLAIN_BATCH lines. Stores the places of coordinate k of all lines in
 * element k of the plain_places. Sets bit i of *left if line i is left to line_read.
 * Returns the number of lines walked; 0 only at the end of the stretch. */
size_t walk_lines(struct stretch *, const struct walk *, size_t n,
    struct line[PLAIN_BATCH], struct plain_places[4], uint64_t *left);

/* Reads the numbers of the n lines that walk_lines walked. If bit i is set in left, the
 * numbers of line i mean nothing. Returns `left` plus the bits of further lines that
 * are left to line_read; all other lines are points. */
uint64_t walk_numbers(const struct walk *, const struct line *, size_t n,
    const struct plain_places[4], uint64_t left, double v[4][PLAIN_BATCH]);

#endif
