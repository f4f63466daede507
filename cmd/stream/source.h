/* SPDX-License-Identifier: MIT */
/* A source of points, as pieces for chunks. */
#ifndef SOURCE_H
#define SOURCE_H

#include "chunk.h"

struct point_source {
	const char *name;
	enum source_kind {
		SOURCE_STREAM, /* what can be read only once, as a pipe */
		SOURCE_FILE,   /* what several threads can read at a time */
		SOURCE_TEXT,   /* lines or binary points in memory */
	} kind;
	int fd;
	off_t start;            /* of SOURCE_FILE: where its points begin */
	struct piece rest;      /* of SOURCE_STREAM: as piece_fill has it */
	const char *text, *end; /* of SOURCE_TEXT: what is left */
};

/* How the file is best read. */
struct point_source source_of_file(const char *name, int fd);

/* Text in memory, with PIECE_MARGIN bytes behind it. */
struct point_source source_of_text(const char *name, const char *text,
    size_t size);

/* Give a chunk its piece of the source, and say in its state what came of that.
 * source_begin is to be called in the order of chunks, by one thread at a time,
 * and may wait for a stream; then source_read, by any number of threads. */
void source_begin(struct point_source *, const struct layout *, struct chunk *);
void source_read(const struct point_source *, const struct layout *,
    struct chunk *);

/* Frees what the source keeps, after the chunk that was last of it. Whoever
 * reads the file next begins where it ended. */
void source_end(struct point_source *, const struct chunk *last);

#endif
