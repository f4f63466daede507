/* SPDX-License-Identifier: MIT */
/* A job: what is done with every point; and chunks, each a piece of a source and what
 * becomes of it. No chunk depends on another, so that each can be done by another
 * thread. */
#ifndef JOB_H
#define JOB_H

#include "../../core/derive/frustum.h"
#include "../../core/derive/ray.h"
#include "../../core/points/points.h"
#include "../lines/walk.h"
#include "source.h"

/* Of more bad lines only the number is told. */
enum { TOLD = 10 };

struct complaint {
	size_t line;
	char reason[REASON_MAX]; /* what is wrong with the line */
};

/* Lines are counted from 0 in each chunk. A binary point counts as a line. */
struct chunk {
	const char *name; /* of the source */
	struct piece piece;
	const char *text, *end; /* what is left to read */
	size_t n_lines;         /* read so far */
	enum first first;       /* which line is still to come */
	bool refused;           /* a header says that no line can be read */
	bool done;              /* it waits to be answered */

	char *out;
	size_t size, room; /* of out: used, allocated */
	size_t n_complaints;
	size_t imageless;       /* points without image */
	size_t first_imageless; /* the line of the first of them */

	/* The block in hand: its lines of text, and its points, a column for
	 * each coordinate. */
	COLUMN_ALIGNED struct stretch stretch;
	COLUMN_ALIGNED struct line line[POINTS_BLOCK];
	COLUMN_ALIGNED double in[4][POINTS_BLOCK];
	COLUMN_ALIGNED double image[COORDINATES_MAX][POINTS_BLOCK];

	struct word word[256]; /* for each set of planes; empty until needed */
	struct complaint complaint[TOLD]; /* the first, in the order of lines */
};

struct job {
	struct transform transform;
	enum precision precision;
	struct layout layout;
	const char *space;      /* of the images, for --append */
	struct frustum frustum; /* for flags and visible alone */
	struct ray_maker ray;   /* for rays alone */
	bool visible;           /* print only points in the view volume */
	bool rays;              /* print rays in the place of images */
	bool keep_going;        /* after bad lines */
	bool count_imageless;   /* tell of points without image at the end */
	int threads;            /* at most; 0: one for each processor */

	/* For the commands that do not print a line for each point, else NULL.
	 * take gets a block before it is carried: n lines, the last that were
	 * read, and in the columns the points of those that are points. It may
	 * append to the chunk's out, and runs in any thread. collect gets the
	 * chunks in order, with the source's number of their first line. flush
	 * prints what was collected, after the last of them or before a bad line
	 * ends the program. */
	void (
	    *take)(const struct job *, struct chunk *, size_t n, size_t points);
	void (*collect)(const struct job *, const struct chunk *,
	    long long first_line);
	void (*flush)(const struct job *);
	void *with; /* what these three share */
};

struct chunk *chunk_new(void);

/* Makes room for so many more bytes of output; returns out + size, where they
 * go. The caller adds to size what it writes. */
char *chunk_reserve(struct chunk *, size_t more);

/* Returns the word for the planes that a point is outside of: in, or left+near. It
 * stays the chunk's. */
const struct word *word_for(struct chunk *, unsigned outside);

/* Notes what is wrong with a line; the reason is copied. Returns whether the job goes
 * on with the next line; else the chunk ends. */
bool chunk_complain(const struct job *, struct chunk *, size_t line,
    const char *reason);

/* Fills the chunk's out from its text, which is whole lines or whole binary
 * points; stops at the first bad one unless the job keeps going. */
void job_do(struct job *, struct chunk *);

/* Reads up to POINTS_BLOCK lines, and the points among them into the chunk's
 * columns. A bad line ends the chunk unless the job keeps going. Returns how
 * many lines, and in *points how many of them are points. */
size_t block_read(struct job *, struct chunk *, size_t *points);

/* Appends n lines to the chunk's out; number is that of the first, and points how many
 * of them are points, whose images the chunk has. */
void block_write(const struct job *, struct chunk *, size_t n, size_t points,
    size_t number);

/* Returns whether blocks of images are written as they are: every binary point
 * becomes as many bytes, and no command wants to see it. */
bool binary_is_whole(const struct job *);

/* Does as block_read; but the chunk has no lines if all is well and
 * binary_is_whole. */
size_t binary_read(const struct job *, struct chunk *, size_t *points);

/* Transforms the next points, at most a block, from floats to floats in single
 * precision. Returns false, with nothing done, where one has no image, or floats are
 * not all that is read and written. */
bool binary_carry(const struct job *, struct chunk *);

/* Appends the images of n binary points, which were read from text. Returns false,
 * with nothing done but the chunk's lines, where one has no image or is to be looked
 * at. */
bool binary_join(const struct job *, struct chunk *, const char *text,
    size_t n);

/* Returns how many bytes are written for each point. */
size_t binary_written(const struct layout *);

/* Writes the image of a line that is point p, or nan for a bad one, and returns where
 * it ends. */
char *binary_put(const struct layout *, const struct chunk *,
    const struct line *, size_t p, char *at);

#endif
