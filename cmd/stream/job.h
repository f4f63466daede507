/* SPDX-License-Identifier: MIT */
/* A job says what is done with every point. A chunk is a piece of a source and its
 * output. Chunks are independent, so that threads do them at the same time. */
#ifndef JOB_H
#define JOB_H

#include "../../core/derive/frustum.h"
#include "../lines/line.h"
#include "../message/message.h"
#include "source.h"

/* The bad lines that are reported; more are only counted. */
enum { COMPLAINTS_MAX = 10 };

struct complaint {
	size_t line;
	char reason[REASON_MAX]; /* what is wrong with the line */
};

/* Lines are counted from 0 in each chunk. A binary point counts as a line. */
struct chunk {
	struct chunk *next; /* in one of the lists of stream.c */
	struct place place; /* of the first line, when the chunk is answered */
	struct piece piece;
	const char *text, *end; /* the bytes that are not read yet */
	size_t n_lines;         /* lines done: all those before the block */
	enum first first;       /* the special line that comes next */
	bool refused; /* the header is bad, so that no line can be read */
	bool done;    /* ready for answer_chunk */

	char *out;
	size_t size, room; /* bytes of out: used, allocated */
	size_t n_complaints;
	size_t imageless;       /* points without image */
	size_t first_imageless; /* the line of the first of them */

	/* The block: lines of the chunk that are done together, and a column of
	 * their points for each coordinate. */
	size_t block_lines, block_points;
	bool planned, walks; /* walk_plan was called; it returned true */
	struct walk walk;
	struct word word[256]; /* chunk_word's results; empty until needed */
	/* chunk_new leaves the members from here on without a value */
	COLUMN_ALIGNED struct stretch stretch;
	COLUMN_ALIGNED struct line line[POINTS_BLOCK];
	COLUMN_ALIGNED double in[4][POINTS_BLOCK];
	COLUMN_ALIGNED double image[COORDINATES_MAX][POINTS_BLOCK];
	struct complaint complaint[COMPLAINTS_MAX];
};

struct job {
	struct transform transform;
	enum precision precision;
	struct layout layout;
	const char *space;      /* of the images, for --append */
	struct frustum frustum; /* for flags and visible only */
	struct ray_maker ray;   /* for rays only */
	bool visible;           /* print only points in the view volume */
	bool rays;              /* print rays instead of images */
	bool keep_going;        /* after bad lines */
	bool count_imageless;   /* report points without image at the end */
	int threads;            /* at most; 0: one for each processor */

	/* Functions of a command that does not print a line for each point, else
	 * NULL. take gets each block before its points are transformed; it may
	 * append to the chunk's out, and runs in any thread. collect gets the
	 * chunks in order. flush prints what was collected, after the last chunk
	 * or before a bad line ends the program. */
	void (*take)(const struct job *, struct chunk *);
	void (*collect)(const struct job *, const struct chunk *);
	void (*flush)(const struct job *);
	void *with; /* the data of these functions */
};

struct chunk *chunk_new(void);

/* Makes room for that many more bytes of output. Returns out + size, where the caller
 * writes them before adding their number to size. */
char *chunk_reserve(struct chunk *, size_t more);

/* Returns the word of --flags for the planes that a point is outside of, such as "in"
 * or "left+near". The word belongs to the chunk. */
const struct word *chunk_word(struct chunk *, unsigned outside);

/* Adds a complaint about line block_lines of the block. Returns whether the job goes
 * on with the next line; if not, the chunk ends. */
bool chunk_complain(const struct job *, struct chunk *, const char *reason);

/* Fills the chunk's out from its piece, which has whole lines or whole binary points;
 * stops at the first bad one unless the job keeps going. */
void job_do(struct job *, struct chunk *);

/* Returns whether every binary point that is read becomes one that is written, so that
 * whole blocks are written at once. */
bool binary_by_blocks(const struct job *);

/* Reads a block of up to POINTS_BLOCK points. Its lines are filled in only if
 * a point is bad or binary_by_blocks is false. */
void binary_read(const struct job *, struct chunk *);

/* Reads, transforms and writes a block from floats to floats in single precision.
 * Returns false and leaves the chunk unchanged if a point has no image, or if the input
 * or the output is not floats. */
bool binary_map_floats(const struct job *, struct chunk *);

/* Appends the images of the block, whose binary points begin at text, to out. If an
 * image is not finite, or a float needs point_single, only fills in the block's lines
 * and returns false. */
bool binary_join(const struct job *, struct chunk *, const char *text);

/* Returns how many bytes are written for each point. */
size_t binary_written(const struct layout *);

/* Writes the image of a line that is point p of the block, or nan for a bad line.
 * Returns the end of what is written. */
char *binary_put(const struct layout *, const struct chunk *,
    const struct line *, size_t p, char *at);

/* stream.c does a job on sources of points, with several threads. */

/* Calls run(with), in a new thread if the program's stack may be too small, and returns
 * when run has returned. */
void call_with_stack(void *(*run)(void *), void *with);

/* Does the job on the points of a source. Every point that was read is answered before
 * the program waits for more. Errors are printed and end the program. Each call must
 * get the same struct job; its contents may change between the calls. */
void stream(struct job *, struct point_source);

/* answer.c prints the output of chunks in the order of their source, reports bad lines
 * and points without image, and shows progress on standard error. */

/* Turns progress on if asked is true, or standard error is a terminal and standard
 * output is not. Only the first call has an effect. */
void answer_progress(bool asked);

/* Begins a source: its lines are counted from 1. */
void answer_source(const struct job *, const struct point_source *);

/* Prints the output of the next chunk, then reports its bad lines, which end the
 * program unless the job keeps going, and the error that ended its source, which always
 * ends the program. Any thread may call answer_chunk, but only one at a time. */
void answer_chunk(const struct job *, struct chunk *);

/* Counts a scene that was refused, and prints null for it if the format is JSON. */
void answer_no_scene(enum format);

/* Reports how many points had no image and how many lines were bad, and closes standard
 * output. Returns the exit status. */
int answer_end(void);

#endif
