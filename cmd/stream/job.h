/* SPDX-License-Identifier: MIT */
/* A job says what is done with every point. The threads share it, and none changes it
 * but for its layout (plan.h). */
#pragma once

#include "../../core/derive/frustum.h"
#include "../../core/derive/ray.h"
#include "chunk.h"

/* A point whose w is not positive has no image, as bits. */
enum behind {
	BEHIND_CAMERA = 1,
	BEHIND_AXES = 2,  /* the camera's axes may be those of another program */
	BEHIND_ORDER = 4, /* its quaternion may begin with w */
	BEHIND_DEPTH = 8, /* z, a depth beyond that of infinity, may be a distance */
};

struct job {
	bool visible;         /* print only points in the view volume */
	bool rays;            /* print rays instead of images */
	bool keep_going;      /* after bad lines */
	bool count_imageless; /* report points without image at the end */
	unsigned behind;      /* what a w that is not positive may come of; or 0 */
	int threads;          /* the most; 0: one for each processor */
	enum precision precision;

	/* Functions of a command that does not print a line for each point, or NULL.
	 * take_block gets each block before it is transformed, in any thread; it may
	 * append to out. collect_chunk gets the chunks in order. flush prints what was
	 * collected, at the end or before an error ends the program. */
	void (*take_block)(const struct job *, struct chunk *);
	void (*collect_chunk)(const struct job *, const struct chunk *);
	void (*flush)(const struct job *);
	void *data; /* data for these functions */
	/* Gets each OBJ file whole, so that its lines are not read as points; or NULL.
	 * Returns false, and what is wrong, if it refuses the text. */
	bool (*take_obj)(const struct job *, struct span text, struct refusal *);

	struct transform transform;
	struct layout layout;
	struct frustum frustum; /* used if layout.flags or visible is set */
	struct ray_maker ray;   /* used if rays is set */
};

/* Does the job on the chunk's piece and writes the output to the chunk's out. Stops at
 * the first bad line or binary point unless the job keeps going. */
void job_do(struct job *, struct chunk *);
