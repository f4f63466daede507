/* SPDX-License-Identifier: MIT */
/* Reads a source of points in pieces of whole lines or whole binary points. */
#pragma once

#include <sys/types.h>

#include "../table/list.h"
#include "../table/plan.h"

/* The size of a piece in bytes. Threads then seldom wait, and caches hold a piece. */
enum { PIECE_ROOM = 1 << 17 };

/* Pipes have room for two pieces: one is written while another is read. */
enum { PIPE_ROOM = 2 * PIECE_ROOM };

/* EARLY: not full, as the next read would wait. LAST: the source ends with this
 * piece, as it does after the errors TOO_LONG, a line of more than 64 MiB, FAILED, of
 * a read, and BROKEN, of a list. */
enum piece_state {
	PIECE_FULL,
	PIECE_EARLY,
	PIECE_LAST,
	PIECE_BROKEN,
	PIECE_TOO_LONG,
	PIECE_FAILED
};

struct piece {
	char *text;        /* NULL before the first use */
	size_t room;       /* bytes allocated, less LINE_MARGIN */
	size_t size;       /* bytes of text */
	size_t whole_size; /* bytes of the whole lines or points in text */
	enum piece_state state;
	int error; /* the errno of PIECE_FAILED */
	/* Of a list: where the elements begin, and the fault of PIECE_BROKEN. */
	struct list_place *place;
	size_t place_room;
	struct refusal fault;
};

struct point_source {
	const char *name;
	struct span text;  /* unread text in memory; .s is NULL for a file */
	struct span head;  /* bytes of a file that source_begin has read */
	bool is_ours;      /* the program made the lines: they are arrays */
	bool has_ended;    /* source_begin has read all of it */
	bool has_bom;      /* a byte order mark stands before the list */
	struct list list;  /* used if plan.is_list is set */
	int fd;            /* descriptor of a file */
	off_t size;        /* bytes of the whole source; 0: unknown */
	size_t bytes_read; /* bytes of all pieces read so far */
	struct span rest;  /* bytes of the last piece after its whole_size */
};

/* Allocates `room` bytes for the text of a piece, and keeps the text that fits. */
void piece_resize(struct piece *, size_t room);

struct point_source source_of_file(const char *name, int fd);
struct point_source source_of_text(const char *name, const char *text, size_t size);

/* Begins a plan for the source. Reads what tells the format if l->in is not known, and
 * whether JSON is a list: up to the first line that is neither blank nor a comment.
 * Only one source at a time may have begun. Returns false if it is of another kind,
 * such as a picture. */
bool source_begin(struct point_source *, struct layout *, struct refusal *);

/* Reads the next piece, and may wait for input. Copies `rest` from the previous piece,
 * whose text must still exist. Only one thread at a time may call source_read. */
void source_read(struct point_source *, const struct layout *, struct piece *);
