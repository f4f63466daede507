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

/* Prints the output of chunks in the order of their source, reports bad lines and
 * points without image, and shows progress on standard error. */

/* Turns progress on if asked is true, or standard error is a terminal and standard
 * output is not. Only the first call has an effect. */
void answer_progress(bool asked);

/* Begins a source of that many bytes, 0 for unknown, with line 1. */
void answer_source(long long size);

/* Prints the output of the next chunk, then reports its bad lines, which end the
 * program unless the job keeps going, and the error that ended its source, which
 * always does. Any thread may call it, but only one at a time. */
void answer_chunk(const struct job *, const struct chunk *);

/* Counts a scene that was refused, and prints null for it if the format is JSON. */
void answer_no_scene(enum format);

/* Reports how many points had no image and how many lines were bad, and closes standard
 * output. Returns the exit status. */
int answer_end(void);

#endif
