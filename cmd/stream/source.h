/* SPDX-License-Identifier: MIT */
/* A source of points, in pieces that end where a line or a binary point does. */
#ifndef SOURCE_H
#define SOURCE_H

#include <sys/types.h>

#include "../message/span.h"

struct layout;

/* Most pieces take so many bytes: enough that handing over costs nothing, few
 * enough for caches. */
enum { PIECE_ROOM = 1 << 17 };

/* Of pipes, two pieces: one is filled while the other is emptied. More of them on
 * both sides would not stay in the cache of a processor. */
enum { PIPE_ROOM = 2 * PIECE_ROOM };

/* So many bytes behind a text there are, too: where a document's lone point gets
 * its newline, and one that walk.c looks at, whatever it is, behind a minus that
 * ends a line. */
enum { PIECE_MARGIN = 2 };

enum piece_state {
	PIECE_FULL,
	PIECE_EARLY, /* as the next read would have to wait */
	PIECE_LAST,  /* the source ends with it */
	/* The source can't be read any further: */
	PIECE_TOO_LONG, /* a line of more than 64 MiB */
	PIECE_FAILED,   /* error says why */
};

struct piece {
	struct span
	    got; /* whole lines or points, of text or of a text in memory */
	enum piece_state state; /* what comes after it in the source */
	int error;              /* the errno of PIECE_FAILED */

	char *text;          /* what was read; NULL at first */
	size_t room, have;   /* bytes: before the margin, read */
	size_t begin, whole; /* of have: whole lines or points */
	off_t at;            /* where in its file text begins */
};

struct point_source {
	const char *name;
	enum source_kind {
		SOURCE_STREAM, /* what can be read only once, as a pipe */
		SOURCE_FILE,   /* what several threads can read at a time */
		SOURCE_TEXT,   /* lines or binary points in memory */
	} kind;
	int fd;
	off_t start, size;      /* of a file: where points begin, bytes or 0 */
	struct piece rest;      /* of SOURCE_STREAM: what was not whole */
	const char *text, *end; /* of SOURCE_TEXT: what is left */
};

/* Returns how the file is best read. */
struct point_source source_of_file(const char *name, int fd);

/* Give a piece its text, and say in its state what came of that. source_begin is to be
 * called in the order of pieces, by one thread at a time, and may wait for a stream;
 * then source_read for the k-th piece, from 0, by any number of threads. Behind a piece
 * that is PIECE_LAST there is nothing that counts. */
void source_begin(struct point_source *, const struct layout *, struct piece *);
void source_read(const struct point_source *, const struct layout *,
    struct piece *, size_t k);

/* Frees what the source keeps, after the piece that was last of it. Whoever reads the
 * file next begins where it ended. */
void source_end(struct point_source *, const struct piece *last);

#endif
