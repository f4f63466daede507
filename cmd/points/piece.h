/* A source's bytes, in pieces that end where a line or a binary point does. */
#ifndef PIECE_H
#define PIECE_H

#include "line.h"

struct piece {
	char *text;
	size_t room, have; /* bytes: allocated, read */
	size_t whole;      /* of these, up to the last end of a line or point */
};

enum piece_state {
	PIECE_FULL,     /* or more would have to be waited for */
	PIECE_LAST,     /* the source ends with it */
	PIECE_TOO_LONG, /* a line of more than 64 MiB */
	PIECE_FAILED,   /* errno says why */
};

/* Begins a piece with what the one before holds behind end; NULL: empty. */
void piece_begin(struct piece *, const struct piece *before, const char *end);

/* Reads until there is something whole, and the piece is full, the next read
 * would wait, or the source ends. */
enum piece_state piece_fill(struct piece *, const struct layout *, int fd);

#endif
