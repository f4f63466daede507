/* SPDX-License-Identifier: MIT */
/* A source's bytes, in pieces that end where a line or a binary point does. */
#ifndef PIECE_H
#define PIECE_H

#include <sys/types.h>

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

struct piece {
	char *text;          /* NULL at first */
	size_t room, have;   /* bytes: before the margin, read */
	size_t begin, whole; /* of have: whole lines or points */
	off_t at;            /* where in its file text begins */
};

enum piece_state {
	PIECE_FULL,
	PIECE_EARLY, /* as the next read would have to wait */
	PIECE_LAST,  /* the source ends with it */
	/* The source can't be read any further: */
	PIECE_TOO_LONG, /* a line of more than 64 MiB */
	PIECE_FAILED,   /* errno says why */
};

/* Makes room for so many bytes of text; what was read stays. */
void piece_reserve(struct piece *, size_t room);
void piece_free(struct piece *);

/* Reads from fd until the source ends; or until there is a whole line or point
 * and either the piece is full or the next read would wait. The piece begins
 * with *rest, the beginning of a line or point that was not whole, where the
 * next such beginning is left. */
enum piece_state piece_fill(struct piece *, const struct layout *, int fd,
    struct piece *rest);

/* Reads the k-th piece, from 0, of a file whose points begin at start: the lines
 * or points that begin in the k-th of ranges of equal size. Several threads may
 * read pieces of a file at a time: each finds the borders of its own. Behind a
 * piece that is PIECE_LAST there is nothing that counts. */
enum piece_state piece_cut(struct piece *, const struct layout *, int fd,
    off_t start, size_t k);

/* Cuts *size, of a text in memory, to the piece that it begins with. */
enum piece_state piece_of_text(const struct layout *, const char *text,
    size_t *size);

#endif
