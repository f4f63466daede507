/* SPDX-License-Identifier: MIT */
/* A job: what is done with every point, and the function that does it on a
 * chunk of them. */
#ifndef JOB_H
#define JOB_H

#include "../../core/derive/frustum.h"
#include "../../core/derive/ray.h"
#include "chunk.h"

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
	int threads;

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

/* Fills the chunk's out from its text, which is whole lines or whole binary
 * points; stops at the first bad one unless the job keeps going. */
void job_do(struct job *, struct chunk *);

#endif
