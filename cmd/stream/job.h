/* SPDX-License-Identifier: MIT */
/* A job says what is done with every point. A chunk is a piece of a source and its
 * output. Chunks are independent, so that several threads work on them at the same
 * time. To answer a chunk is to print its output. */
#ifndef JOB_H
#define JOB_H

#include "../../core/derive/frustum.h"
#include "../../core/derive/ray.h"
#include "../lines/line.h"
#include "../message/message.h"
#include "source.h"

/* The number of bad lines that are reported; any others are only counted. */
enum { COMPLAINTS_MAX = 10 };

struct complaint {
	size_t line;             /* its index in the chunk, from 0 */
	char reason[REASON_MAX]; /* what is wrong with the line */
};

/* Lines are counted from 0 in each chunk. A binary point counts as a line. */
struct chunk {
	struct chunk *next; /* in one of the lists of stream.c */
	struct place place; /* of the first line; set by answer_chunk */
	struct piece piece;
	const char *text, *end; /* the bytes that are not read yet */
	size_t n_lines;         /* lines before the block */
	enum first first; /* whether the first byte, line or row is next */
	bool refused;     /* no line can be read, as after a bad header */
	bool done;        /* ready for answer_chunk */

	char *out;
	size_t size, room; /* bytes of out: used, allocated */
	size_t n_complaints;
	size_t imageless;       /* points without image */
	size_t first_imageless; /* the line of the first such point */

	/* The block: lines that are transformed together, with columns of numbers. */
	size_t block_lines, block_points;
	bool walk_planned, can_walk; /* walk_plan: was called; returned true */
	struct walk walk;
	struct flags flags[256]; /* results of chunk_flags, or empty */
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
	const char *space; /* the name of the space of images, for --append */
	const char *from;  /* the name of the space of points, or NULL */
	struct frustum frustum; /* used if layout.flags or visible is set */
	struct ray_maker ray;   /* used if rays is set */
	bool visible;           /* print only points in the view volume */
	bool rays;              /* print rays instead of images */
	bool keep_going;        /* after bad lines */
	bool count_imageless;   /* report points without image at the end */
	int threads;            /* the most; 0: one for each processor */

	/* Functions of a command that does not print a line for each point; other
	 * commands leave them NULL. take_block gets each block before its points are
	 * transformed; it may append to the chunk's out, and runs in any thread.
	 * collect_chunk gets the chunks in order. flush prints what was collected,
	 * after the last chunk or before an error ends the program. */
	void (*take_block)(const struct job *, struct chunk *);
	void (*collect_chunk)(const struct job *, const struct chunk *);
	void (*flush)(const struct job *);
	void *data; /* data for these functions */
};

struct chunk *chunk_new(void);

/* Makes room for n more bytes in the chunk's out, and returns their address. The caller
 * adds to the member size how many bytes it writes there. */
char *chunk_reserve(struct chunk *, size_t n);

/* Returns the word of --flags, such as "in" or "left+near", for a point that is outside
 * of the frustum planes with bits set in `outside`. The word belongs to the chunk. */
const struct flags *chunk_flags(struct chunk *, unsigned outside);

/* Adds a complaint on the block's next line. Returns false if the chunk ends there. */
bool chunk_complain(const struct job *, struct chunk *, const char *reason);

/* Does the job on the chunk's piece and writes the output to the chunk's out. Stops at
 * the first bad line or binary point unless the job keeps going. */
void job_do(struct job *, struct chunk *);

/* Returns whether the job writes a binary image for every binary point of its input. */
bool binary_to_binary(const struct job *);

/* Reads a block of up to POINTS_BLOCK binary points. Sets the lines of the block only
 * if a point is bad or binary_to_binary is false. */
void binary_read(const struct job *, struct chunk *);

/* Reads, transforms and writes a block of points if they are f32 in input and output,
 * the precision is single, and layout.keeps is false. If not, or if points_map_floats
 * returns false, as for a point without image, reads nothing and returns false. */
bool binary_map_floats(const struct job *, struct chunk *);

/* Appends the images of the block to out. The block's binary points begin at `text`. If
 * an image is not finite, or if point_single has to round a float, only sets the lines
 * of the block, and returns false. */
bool binary_write(const struct job *, struct chunk *, const char *text);

/* Returns the number of bytes that are written for each point. */
size_t binary_size(const struct layout *);

/* Writes a binary point for a line: the image of its point, which is point p of the
 * block, or nan if the line is bad. Returns the end of the binary point. */
char *binary_put(const struct layout *, const struct chunk *,
    const struct line *, size_t p, char *at);
/* stream.c does a job on sources of points, with several threads. */

/* Calls run(data), in a new thread if the stack may be too small, and waits for it. */
void call_with_stack(void *(*run)(void *), void *data);

/* Does the job on the points of a source. Before it waits for more input, prints the
 * output for all points that were read. Prints errors and ends the program after them.
 * Each call must get the same struct job; its contents may change between calls. */
void stream(struct job *, struct point_source);
/* answer.c prints the output of chunks in the order of their source, reports bad lines
 * and points without image, and shows progress on standard error. */

/* At the first call, turns progress on if `asked`, or if only stderr is a terminal. */
void answer_start_progress(bool asked);

/* Says that the next chunks are of this source. Its lines are counted from 1. */
void answer_begin_source(const struct job *, const struct point_source *);

/* Prints the output of the next chunk. Then reports its bad lines, which end the
 * program unless the job keeps going, and an error that ended its source, which always
 * ends the program. Any thread may call answer_chunk, but only one at a time. */
void answer_chunk(const struct job *, struct chunk *);

/* Counts a scene that was refused, and prints null for it if the format is JSON. */
void answer_refused_scene(enum format);

/* Reports how many lines are bad, how many points have no image and, by --progress, all
 * lines. Closes standard output, and returns the exit status. */
int answer_end(void);

#endif
