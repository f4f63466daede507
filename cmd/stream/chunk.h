/* SPDX-License-Identifier: MIT */
/* A piece of a source and what becomes of it. No chunk depends on another, so
 * that each can be done by another thread. */
#ifndef CHUNK_H
#define CHUNK_H

#include "../../core/points/points.h"
#include "source.h"
#include "../lines/walk.h"

/* What is wrong with a line. */
struct complaint {
	size_t line;
	size_t reason; /* where in reasons it stands, ended by a NUL */
};

/* Lines are counted from 0 in each chunk. A binary point counts as a line. */
struct chunk {
	const char *name;       /* of the source */
	size_t number;          /* in the source, from 0 */
	const char *text, *end; /* what is left to read */
	size_t n_lines;         /* read so far */
	bool first;   /* the first line that counts is still to come */
	bool refused; /* a header says that no line can be read */
	bool done;    /* it waits to be answered */

	char *out;
	size_t size, room;            /* of out: used, allocated */
	struct complaint *complaints; /* in the order of their lines */
	size_t n_complaints, complaints_room;
	char *reasons;
	size_t reasons_size, reasons_room;
	size_t imageless;       /* points without image */
	size_t first_imageless; /* the line of the first of them */

	/* The block in hand: its lines of text, and its points, a column for
	 * each coordinate. */
	struct stretch stretch;
	struct line line[POINTS_BLOCK];
	COLUMN_ALIGNED double in[4][POINTS_BLOCK];
	COLUMN_ALIGNED double image[COORDINATES_MAX][POINTS_BLOCK];

	struct word word[256]; /* for each set of planes; empty until needed */

	struct piece piece;
};

struct chunk *chunk_new(void);
void chunk_free(struct chunk *);

/* Forgets what became of the last piece, to be used for another. Room that few
 * pieces need is given back. */
void chunk_clear(struct chunk *);

/* Makes room for so many more bytes of output; returns out + size, where they
 * go. The caller adds to size what it writes. */
char *chunk_reserve(struct chunk *, size_t more);

/* Notes what is wrong with a line; the reason is copied. */
void chunk_complain(struct chunk *, size_t line, const char *reason);

#endif
