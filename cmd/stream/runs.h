/* SPDX-License-Identifier: MIT */
/* Runs of points: consecutive ones, which lines join. A blank line, a point with a
 * missing coordinate, a bad line and the end of a source end a run. Threads read the
 * points; each run is delivered in its order when it ends, before more input is waited
 * for, and only one run is kept. */
#pragma once

#include "job.h"

struct run_point {
	double in[4], image[4]; /* the point; its image, by the job's transform */
	unsigned char outside;  /* OUT_ bits, by the job's frustum */
	uint32_t name_size;     /* of run_reader.names, else 0 */
	size_t name;            /* its first byte, in run.names */
};

/* A run of n > 0 points. The name of a point is the rest of its line: what stands
 * before, between and behind the coordinates, without the blanks and separators around
 * it, with blanks between; of JSON and OBJ what stands behind the last. */
struct run {
	const struct run_point *point;
	size_t n;
	const char *names;
};

struct run_reader {
	void (*take)(void *data, const struct run *); /* gets each run */
	/* is called after the runs of each piece of input, before more is waited for;
	 * or NULL */
	void (*flush)(void *data);
	void *data;
	bool names;
	/* the run so far: the reader's own, zero at first */
	struct run_point *point;
	char *text;
	size_t n, text_size;
};

/* Makes the job read runs. The caller has set the reader's first members and the job's
 * transform and frustum, and then calls operands_run_job. */
void runs_prepare(struct run_reader *, struct job *);
