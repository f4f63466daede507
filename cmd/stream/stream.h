/* SPDX-License-Identifier: MIT */
/* Sources of points through a job, by several threads, which take a source's chunks,
 * do the job on them, and answer them in order. */
#ifndef STREAM_H
#define STREAM_H

#include "job.h"

/* Calls run, in a thread where the program's own stack may be too small, and returns
 * when it does. */
void call_with_stack(void *(*run)(void *), void *with);

/* Does the job on the points of one source, which is a file or a text in memory.
 * All that has been read is answered before more is waited for. Errors are printed
 * and end the program. The job must be the same at each call; its contents may
 * change in between. */
void stream_file(struct job *, const char *name, int fd);
void stream_text(struct job *, const char *name, const char *text, size_t size);

#endif
