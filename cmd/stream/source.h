/* SPDX-License-Identifier: MIT */
/* Reads a source of points in pieces that end with a whole line or binary point. */
#ifndef SOURCE_H
#define SOURCE_H

#include <sys/types.h>

#include "../message/utf8.h"

struct layout;

/* The bytes of the pieces of a large source: enough that threads seldom take the lock,
 * few enough for caches. */
enum { PIECE_ROOM = 1 << 17 };

/* The size of pipes: one piece is written while another is read. Larger pipes would
 * not stay in the cache. */
enum { PIPE_ROOM = 2 * PIECE_ROOM };

/* The number of bytes after a text that may be read. After a document's text they may
 * also be written, as by the newline of a single point. */
enum { PIECE_MARGIN = 2 };

enum piece_state {
	PIECE_FULL,
	PIECE_EARLY, /* not full, as the next read would wait */
	PIECE_LAST,  /* the source ends with it */
	/* errors that end the source: */
	PIECE_TOO_LONG, /* a line of more than 64 MiB */
	PIECE_FAILED,   /* error says why */
};

struct piece {
	char *text;   /* NULL before the first use */
	size_t room;  /* bytes allocated, less PIECE_MARGIN */
	size_t have;  /* bytes read */
	size_t whole; /* bytes of these in whole lines or points */
	enum piece_state state;
	int error; /* the errno of PIECE_FAILED */
};

struct point_source {
	const char *name;
	struct span
	    text;     /* the unread part of a text in memory, or s is NULL */
	int fd;       /* of a file */
	off_t size;   /* bytes; 0: unknown */
	size_t begun; /* bytes of all pieces read so far */
	struct span
	    rest; /* of the last piece, after its whole lines or points */
};

/* Allocates room bytes for the text, and keeps its beginning. */
void piece_resize(struct piece *, size_t room);

struct point_source source_of_file(const char *name, int fd);
struct point_source source_of_text(const char *name, const char *text,
    size_t size);

/* Reads the next piece; may wait for a stream. The piece before must still have its
 * text. Only one thread at a time may call source_read. */
void source_read(struct point_source *, const struct layout *, struct piece *);

#endif
