/* SPDX-License-Identifier: MIT */
/* Reads simple lines fast: a walk goes from stop to stop of a stretch and finds the
 * coordinates; vector code reads the numbers. line_read reads all other lines. */
#pragma once

#include "../number/vector/loops.h"
#include "line.h"

/* A stretch is text with an index of its stops, which are the bytes that can end a
 * field or make a line not simple. The text is the caller's. A stretch stays in the
 * first-level cache, and the place of a stop fits into 16 bits. */
enum { STRETCH_MAX = 1 << 14 };

struct stretch {
	const char *readable;             /* vector code may read from here on */
	const char *text;                 /* the beginning of the stretch */
	uint32_t at;                      /* the place of the next line */
	uint32_t end;                     /* the place after the last line */
	const uint16_t *next;             /* the first stop at or after `at` */
	uint16_t stop[STRETCH_MAX + 128]; /* the places of the stops */
};

/* The paths from a JSON value to coordinates, by names and indexes with / between.
 * path[i] leads to coordinate i. Its first name or index has size[i] bytes; SIZE_MAX:
 * coordinate i is elsewhere. */
struct walk_paths {
	const char *path[4];
	size_t size[4];
};

/* The properties of simple lines, and the way to their n coordinates. */
struct walk {
	struct dialect in;
	struct byte_set stops;
	int n;
	int exact_fields;        /* fields that a line must have; 0: up to max_fields */
	int max_fields;          /* the most fields of a row of csv */
	bool arrays;             /* lines may be JSON arrays */
	bool objects;            /* lines may be JSON objects */
	struct walk_paths paths; /* the paths to the coordinates in an object */
	/* NULL or, by --append, the names that an object must not have */
	const char (*added_names)[NAME_ROOM];
	bool by_column; /* coordinate i is in column field[i], else column i */
	int field[4];
};

/* Sets the walk for a layout. Returns false if no line of the layout is simple. */
bool walk_plan(const struct layout *, struct walk *);

/* Begins a stretch at text and makes its index, by vector code. Returns false if it has
 * no newline before a NUL. */
bool stretch_open(struct stretch *, const struct byte_set *stops, const char *text,
    const char *end);

/* Walks up to n <= PLAIN_BATCH lines, and returns how many; 0 at the end. Stores places
 * of coordinate k in element k. Sets bit i of *left if line_read has to read line i. */
size_t walk_lines(struct stretch *, const struct walk *, size_t n,
    struct line[PLAIN_BATCH], struct plain_places[4], uint64_t *left);

/* Reads the numbers of the n lines of walk_lines, except of those set in `left`.
 * Returns `left` plus further lines for line_read; all others are points. */
uint64_t walk_numbers(const struct walk *, const struct line *, size_t n,
    const struct plain_places[4], uint64_t left, double v[4][PLAIN_BATCH]);
