/* SPDX-License-Identifier: MIT */
/* Reads a source of points in pieces that end with a whole line or binary point. */
#ifndef SOURCE_H
#define SOURCE_H

#include <sys/types.h>

#include "../message/utf8.h"

struct layout;

/* The bytes of a piece: enough that threads seldom wait, few enough for caches. */
enum { PIECE_ROOM = 1 << 17 };

/* The size of pipes in bytes, so that one process writes a piece while another reads a
 * piece. Larger pipes would not stay in the cache. */
enum { PIPE_ROOM = 2 * PIECE_ROOM };

/* The number of bytes that may be read after the end of a text. If the text is a JSON
 * document they may also be written: a point at its very end gets a newline there. */
enum { PIECE_MARGIN = 2 };

enum piece_state {
	PIECE_FULL,
	PIECE_EARLY, /* not full, as the next read would wait */
	PIECE_LAST,  /* the source ends with this piece */
	/* errors that end the source */
	PIECE_TOO_LONG, /* a line of more than 64 MiB */
	PIECE_FAILED,   /* a read failed */
};

struct piece {
	char *text;        /* NULL before the first use */
	size_t room;       /* bytes allocated, less PIECE_MARGIN */
	size_t size;       /* bytes of text */
	size_t whole_size; /* of these, bytes of whole lines or points */
	enum piece_state state;
	int error; /* the errno of PIECE_FAILED */
};

struct point_source {
	const char *name;
	struct span text;  /* unread text in memory; s is NULL for a file */
	int fd;            /* of a file */
	off_t size;        /* bytes; 0: unknown */
	size_t bytes_read; /* bytes of all pieces read so far */
	struct span rest;  /* the last piece after its whole lines or points */
};

/* Allocates `room` bytes for the text of a piece, and keeps the text that fits. */
void piece_resize(struct piece *, size_t room);

struct point_source source_of_file(const char *name, int fd);
struct point_source source_of_text(const char *name, const char *text,
    size_t size);

/* Reads the next piece, and may wait for input. The previous piece must still have its
 * text. Only one thread at a time may call source_read. */
void source_read(struct point_source *, const struct layout *, struct piece *);

#endif
