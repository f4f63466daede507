/* A source's bytes, in pieces that end where a line or a binary point does. */
#ifndef PIECE_H
#define PIECE_H

#include "line.h"

/* So many bytes before and after a text may be looked at, whatever they are:
 * those who read digits by the vector take as many at a time. */
enum { PIECE_MARGIN = 64 };

struct piece {
	char *text;        /* within margins; NULL at first */
	size_t room, have; /* bytes: between the margins, read */
	size_t whole;      /* of have: up to the last end of a line or point */
};

enum piece_state {
	PIECE_FULL,     /* or the next read would have to wait */
	PIECE_LAST,     /* the source ends with it */
	PIECE_TOO_LONG, /* a line of more than 64 MiB */
	PIECE_FAILED,   /* errno says why */
};

/* Makes room for so many bytes of text; what was read stays. */
void piece_reserve(struct piece *, size_t room);
void piece_free(struct piece *);

/* Begins a piece with what the piece before holds from end on: the beginning of
 * a line or point that was not whole. before is NULL for the first of a
 * source. */
void piece_begin(struct piece *, const struct piece *before, const char *end);

/* Reads from fd until the source ends; or until there is a whole line or point
 * and either the piece is full or the next read would wait. */
enum piece_state piece_fill(struct piece *, const struct layout *, int fd);

#endif
