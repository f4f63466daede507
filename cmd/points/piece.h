/* A source's bytes, in pieces that end where a line or a binary point does. */
#ifndef PIECE_H
#define PIECE_H

#include "line.h"

struct piece {
	char *text;
	size_t room, have; /* bytes: allocated, read */
	size_t whole;      /* of have: up to the last end of a line or point */
};

enum piece_state {
	PIECE_FULL,     /* or the next read would have to wait */
	PIECE_LAST,     /* the source ends with it */
	PIECE_TOO_LONG, /* a line of more than 64 MiB */
	PIECE_FAILED,   /* errno says why */
};

/* Begins a piece with what the piece before holds from end on: the beginning of
 * a line or point that was not whole. before is NULL for the first of a
 * source. */
void piece_begin(struct piece *, const struct piece *before, const char *end);

/* Reads from fd until the source ends; or until there is a whole line or point
 * and either the piece is full or the next read would wait. */
enum piece_state piece_fill(struct piece *, const struct layout *, int fd);

#endif
