/* What is done with every point. */
#ifndef JOB_H
#define JOB_H

#include "../../core/frustum.h"
#include "../../core/points.h"
#include "../../core/ray.h"
#include "line.h"

struct chunk;

struct job {
	struct transform transform;
	struct accuracy accuracy;
	struct layout layout;
	struct frustum frustum; /* for flags and visible alone */
	struct ray_maker ray;   /* for rays alone */
	/* A word after each point; no points but those in the view volume; rays
	 * in the place of images. */
	bool flags, visible, rays;
	bool keep_going;      /* after bad lines */
	bool count_imageless; /* tell of points without image at the end */
	int threads;
	/* For the commands that print no line a point: take gets every point,
	 * p in the chunk's columns and read from the line, in any thread, and
	 * may leave bytes in the chunk's out; collect gets the chunks in order;
	 * flush prints what there is, before a bad line ends the program too. */
	void (*take)(const struct job *, struct chunk *, const struct line *,
	    size_t p, size_t line);
	void (*collect)(const struct job *, const struct chunk *,
	    size_t first_line);
	void (*flush)(const struct job *);
	void *with; /* what they share */
};

#endif
