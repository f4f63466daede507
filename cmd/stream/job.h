/* SPDX-License-Identifier: MIT */
/* A job says what is done with every point. The threads share it, and none changes it
 * but for its layout (plan.h). */
#pragma once

#include "../../core/derive/frustum.h"
#include "../../core/derive/ray.h"
#include "chunk.h"

/* What it may come of that w of a point is not positive, so that it has no image. Of
 * the scenes of a call the last in this order is said. */
enum behind {
	BEHIND_NOTHING,
	BEHIND_DEPTH,  /* z, a depth beyond that of infinity, may be a distance */
	BEHIND_CAMERA, /* the point is behind the camera, */
	BEHIND_AXES,   /* whose axes may be those of another program, */
	BEHIND_ORDER,  /* or whose quaternion may begin with w */
};

struct job {
	bool visible;         /* print only points in the view volume */
	bool rays;            /* print rays instead of images */
	bool keep_going;      /* after bad lines */
	bool count_imageless; /* report points without image at the end */
	enum behind behind;
	int threads; /* the most; 0: one for each processor */
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
