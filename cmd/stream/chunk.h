/* SPDX-License-Identifier: MIT */
/* A chunk is a piece of a source and its output. Chunks are independent, so
 * that several threads work on them at the same time; at any time one
 * thread owns a chunk. */
#pragma once

#include "../../core/points/transform.h"
#include "../table/emit.h"
#include "../message/message.h"
#include "source.h"

struct job;

/* The number of bad lines that are reported; any others are only counted. */
enum { COMPLAINTS_MAX = 10 };

/* Lines are counted from 0 in each chunk. A binary point counts as a line. */
struct chunk {
	struct chunk *next; /* in one of the lists of stream.c */
	struct place place; /* of the first line; set by answer_chunk */
	struct piece piece;
	const char *text, *end; /* the bytes that are not read yet */
	size_t n_lines;         /* lines before the block */
	enum next_part first;   /* whether the first byte, line or row is next */
	bool refused; /* no line after this can be read, as after a bad header */
	bool is_list; /* the lines are elements of a list */
	bool done;    /* ready for answer_chunk */

	char *out;
	size_t size, room; /* bytes of out: used, allocated */
	size_t n_complaints;
	size_t imageless;       /* points without image */
	size_t first_imageless; /* the line of the first such point */
	size_t behind;          /* those behind the camera, up to the first other */

	/* The block: lines that are transformed together, with columns of numbers. */
	size_t block_lines, block_points;
	bool walk_planned, can_walk; /* walk_plan: was called; returned true */
	struct walk walk;
	struct flag_words words;
	COLUMN_ALIGNED struct stretch stretch;
	COLUMN_ALIGNED struct line line[POINTS_BLOCK];
	COLUMN_ALIGNED double in[4][POINTS_BLOCK];
	COLUMN_ALIGNED double image[COORDINATES_MAX][POINTS_BLOCK];
	/* line is its index in the chunk; the last one is the chunk's last complaint if
	 * it has more */
	struct refusal complaint[COMPLAINTS_MAX + 1];
};

struct chunk *chunk_new(void);

/* Returns the end of out, with room for n bytes; the caller adds to size. */
char *chunk_reserve(struct chunk *, size_t n);

/* Adds a complaint about the block's next line. Returns false if the chunk ends
 * there. */
bool chunk_complain(const struct job *, struct chunk *, const struct refusal *);

/* Returns the line of the source, from 1, of a line of the chunk. */
long long chunk_line(const struct chunk *, size_t line);
