/* SPDX-License-Identifier: MIT */
/* Reads simple lines fast, by an index. The index lists the stops of a stretch of text:
 * the bytes that can end a field. A walk goes from stop to stop and finds the coordinates
 * without a look at the bytes between; vector code then reads many numbers at once. A
 * line that is not simple is left: line_read has to read it. */
#ifndef WALK_H
#define WALK_H

#include "../number/plain.h"
#include "line.h"

/* The most bytes of a stretch: so few that they stay in the first-level cache until
 * their numbers are read. A stop has 16 bits. */
enum { STRETCH = 1 << 14 };

/* A stretch of text with its index. */
struct stretch {
	const char *readable; /* bytes from here on may be read */
	const char *text;     /* the beginning of the stretch */
	uint32_t at;          /* the beginning of the next line */
	uint32_t end;         /* the end of the last line */
	const uint16_t *next; /* the first stop at or after at */
	uint16_t stop[STRETCH + 128];
};

/* The path to each coordinate from the value that the walk is in, and the size of the
 * path's first token in bytes; SIZE_MAX if the path does not lead into this value. */
struct trail {
	const char *path[4];
	size_t size[4];
};

/* How the n coordinates of a line are found. */
struct walk {
	struct dialect in;
	struct byte_set stops;
	int n;
	bool arrays, objects; /* the lines of JSON that are walked */
	struct trail trail;   /* paths to members of objects */
	bool columns;         /* coordinate i is field[i]; false: field i */
	int field[4];
};

/* Makes the walk of a layout. Returns false where every line has to be left. */
bool walk_plan(const struct layout *, struct walk *);

/* Makes the stretch that begins at text, and its index. Returns false where no line
 * ends in the stretch. */
bool stretch_open(struct stretch *, const struct walk *, const char *text,
    const char *end);

/* Walks up to n <= PLAIN_BATCH lines and sets the places of their numbers, by coordinate.
 * Sets bit i of *left if line i is left. Returns the number of lines, at least one if
 * at < end. */
size_t walk_lines(struct stretch *, const struct walk *, size_t n,
    struct line[PLAIN_BATCH], struct plain_places[4], uint64_t *left);

/* Reads the numbers of the n lines that walk_lines walked. Lines with a bit in left may
 * get any numbers. Returns left, and the bits of other lines that have to be left; all
 * other lines are points. Bytes before readable may be read. */
uint64_t walk_numbers(const struct walk *, const struct line *, size_t n,
    const struct plain_places[4], uint64_t left, const char *readable,
    double v[4][PLAIN_BATCH]);

#endif
