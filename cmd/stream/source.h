/* SPDX-License-Identifier: MIT */
/* A source of points, in pieces that end where a line or a binary point does. */
#ifndef SOURCE_H
#define SOURCE_H

#include <sys/types.h>

#include "../message/span.h"

struct layout;

/* The bytes of most pieces: enough that threads seldom take the lock, few enough for
 * caches. The first piece of a source is smaller, as no second one is begun before it
 * is done. */
enum { PIECE_ROOM = 1 << 17, FIRST_ROOM = 1 << 14 };

/* The size of pipes, two pieces: one is filled while the other is emptied. More of
 * them on both sides would not stay in the cache of a processor. */
enum { PIPE_ROOM = 2 * PIECE_ROOM };

/* The bytes that a text has behind its end: a document's lone point gets its newline
 * there, and walk.c looks at one, whatever it is, behind a minus that ends a line. */
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
	char *text;             /* NULL at first */
	size_t room, have;      /* bytes: before the margin, read */
	size_t whole;           /* bytes of have: whole lines or points */
	enum piece_state state; /* what comes after it in the source */
	int error;              /* the errno of PIECE_FAILED */
};

struct point_source {
	const char *name;
	struct span text; /* what is left of a text in memory; else s is NULL */
	int fd;           /* of a file */
	off_t size;       /* bytes; 0 where it is not known */
	struct piece
	    rest; /* what was read behind the last whole line or point */
};

struct point_source source_of_file(const char *name, int fd);

/* Fills a piece, and says in its state what comes after it. Pieces are read in their
 * order, by one thread at a time. The read may wait for a stream. */
void source_read(struct point_source *, const struct layout *, struct piece *);

#endif
