/* SPDX-License-Identifier: MIT */
/* Does a job on sources of points, with several threads. */
#ifndef STREAM_H
#define STREAM_H

#include "job.h"

/* Calls run(with), in a new thread if the program's stack may be too small, and returns
 * when run has returned. */
void call_with_stack(void *(*run)(void *), void *with);

/* Do the job on the points of a source, a file or a text in memory. Every point that
 * was read is answered before the program waits for more. Errors are printed and end
 * the program. Each call must have the same job, whose contents may change between
 * the calls. */
void stream_file(struct job *, const char *name, int fd);
void stream_text(struct job *, const char *name, const char *text, size_t size);

#endif
