/* A piece of a source and what becomes of it. Chunks depend on nothing but
 * themselves, so that threads can share them out. */
#ifndef CHUNK_H
#define CHUNK_H

#include "../../core/points.h"
#include "line.h"

/* A bad line. */
struct complaint {
	size_t line;
	char reason[REASON_MAX];
};

/* Lines are counted from 0 in each chunk, and where points are binary, one is a
 * line. */
struct chunk {
	const char *name;       /* of the source */
	const char *text, *end; /* what is left to read */
	size_t bytes;           /* of text at first, for the progress */
	size_t n_lines;         /* read so far */
	bool first;             /* of its source */
	bool header;            /* a csv header may still come */

	char *out;
	size_t size, room;            /* of out: used, allocated */
	struct complaint *complaints; /* in the order of their lines */
	size_t n_complaints;
	size_t n_passed; /* of complaints, by chunk_mark */
	size_t imageless, first_imageless;

	/* The block in hand: lines of text, columns of their points. */
	struct line line[POINTS_BLOCK];
	double in[4][POINTS_BLOCK];
	double image[COORDINATES_MAX][POINTS_BLOCK];
	bool single[POINTS_BLOCK]; /* the image is of floats */
};

struct chunk *chunk_new(void);
void chunk_free(struct chunk *);

/* Forgets what became of another piece. */
void chunk_clear(struct chunk *);

/* Room for more bytes of output behind out + size. */
char *chunk_reserve(struct chunk *, size_t more);

/* Notes what is wrong with a line. */
void chunk_complain(struct chunk *, size_t line, const char *reason);

/* A coordinate of the image of point p that is not finite, if only as the float
 * that it is written as, becomes nan; the point is counted as one without
 * image, unless its line was complained of. Lines come in order. */
void chunk_mark(struct chunk *, const struct layout *, size_t p, size_t line);

#endif
