/* A piece of a source and what becomes of it. Chunks depend on nothing but
 * themselves, so that threads can share them out; lines are counted from 0 in
 * each. */
#ifndef CHUNK_H
#define CHUNK_H

#include "../../core/frustum.h"
#include "../../core/points.h"
#include "../../core/ray.h"
#include "line.h"

struct chunk;

/* What is done with every point. */
struct job {
	struct transform transform;
	struct accuracy accuracy;
	struct layout layout;
	/* Where flags or visible ask for it, and for rays. */
	struct frustum frustum;
	struct ray_maker ray;
	bool flags, visible, rays;
	bool keep_going;
	bool count_imageless; /* points without image are told of at the end */
	int threads;
	/* For the commands that don't print a line a point: take gets every
	 * point, p in the columns and read from r, in any thread, and may
	 * leave bytes in the chunk's out; collect gets the chunks in order;
	 * flush prints what there is, before a bad line ends the program too. */
	void (*take)(const struct job *, struct chunk *, const struct line *,
	    size_t p, size_t line);
	void (*collect)(const struct job *, const struct chunk *,
	    size_t first_line);
	void (*flush)(const struct job *);
	void *with; /* what they share */
};

/* A bad line, counted from 0 in its chunk. */
struct complaint {
	size_t line;
	char reason[REASON_MAX];
};

struct chunk {
	const char *name; /* of the source */
	const char *text, *end;
	size_t bytes; /* of both, for the progress */
	size_t lines; /* read so far; points where they are binary */
	bool first;   /* of its source */
	bool header;  /* a csv header may still come */

	char *out;
	size_t size, room;
	struct complaint *complaints;
	size_t n_complaints, told; /* of which so many are before this line */
	size_t imageless, first_imageless;

	struct line records[POINTS_BLOCK];
	double in[4][POINTS_BLOCK];
	double image[COORDINATES_MAX][POINTS_BLOCK];
	bool single[POINTS_BLOCK]; /* the image is of floats */
};

struct chunk *chunk_new(void);
void chunk_free(struct chunk *);

/* Does the job on whole lines, or whole binary points: fills out, up to the
 * first bad line where the job does not keep going. */
void chunk_do(struct job *, struct chunk *);

/* Notes what is wrong with a line. */
void chunk_complain(struct chunk *, size_t line, const char *reason);

/* Counts point p, of a line, where it has no image. */
void chunk_mark(const struct job *, struct chunk *, size_t p, size_t line);

/* Room for more bytes of output behind out + size. */
char *chunk_reserve(struct chunk *, size_t more);

bool is_binary(enum format);

/* Bytes of one binary point. */
size_t point_size(const struct layout *, enum format);

#endif
