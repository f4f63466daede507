/* SPDX-License-Identifier: MIT */
/* Threads that take a source's chunks, do a job on them, and answer them in
 * order. */
#ifndef THREADS_H
#define THREADS_H

#include "job.h"
#include "source.h"

/* The processors that the program may run on. */
int threads_processors(void);

/* Does the job on all of the source. The job must be the same at each call; its
 * contents may change in between. */
void threads_run(struct job *, struct point_source *);

#endif
