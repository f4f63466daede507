/* SPDX-License-Identifier: MIT */
/* Lines by way of an index: where in a stretch of text the bytes stand that can
 * end a field. What is usual is found so, with many numbers read at a time; any
 * other line is left to line_read, which alone says what is legal. */
#ifndef WALK_H
#define WALK_H

#include "../number/plain.h"
#include "line.h"

/* Bytes that stay in the nearest cache until their numbers are read; 2^16 at
 * most, for stop. */
enum { STRETCH = 1 << 14 };

/* A stretch of text, with the places of the bytes that can end a field. */
struct stretch {
	const char *readable; /* from here on, text may be looked at */
	const char *text;     /* its beginning */
	uint32_t at, end;     /* the next line; past the last whole one */
	const uint16_t *next; /* the first stop at or after the next line */
	uint16_t stop[STRETCH + 128];
};

/* What is left of the path to each coordinate, inside a value: the first token
 * is of size bytes, SIZE_MAX where the path does not lead into the value. */
struct trail {
	const char *path[4];
	size_t size[4];
};

/* Where the coordinates stand on a line. */
struct walk {
	struct dialect in;
	struct byte_set stops; /* what can end a field */
	int n;
	bool arrays, objects; /* which lines of JSON are walked */
	struct trail trail;   /* to members of objects */
	bool columns;         /* else they are the first fields */
	int field[4];
};

/* False where lines of that layout are not to be walked. */
bool walk_plan(const struct layout *, struct walk *);

/* The stretch that begins at text. False where no line ends in it. */
bool stretch_open(struct stretch *, const struct walk *, const char *text,
    const char *end);

/* Takes up to n <= PLAIN_BATCH lines: where their numbers stand, by coordinate.
 * Bit i of *left says that line i has to be left to line_read; else it is
 * a point if walk_numbers says so. Returns how many, at least one while at is
 * before end. */
size_t walk_lines(struct stretch *, const struct walk *, size_t n,
    struct line[PLAIN_BATCH], struct plain_places[4], uint64_t *left);

/* Reads the numbers of the n lines that walk_lines took, but for those that are left.
 * Returns which lines are left then. Bytes up to readable may be looked at. */
uint64_t walk_numbers(const struct walk *, const struct line *, size_t n,
    const struct plain_places[4], uint64_t left, const char *readable,
    double v[4][PLAIN_BATCH]);

#endif
