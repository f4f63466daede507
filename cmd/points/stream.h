/* Points in, points out: reading, threads and answers, in order. */
#ifndef STREAM_H
#define STREAM_H

#include "job.h"

/* Does the job on the points of one source: what fd holds, or text. What is
 * there is answered before more is waited for. Errors are printed and end the
 * program. */
void stream_file(struct job *, const char *name, int fd);
void stream_text(struct job *, const char *name, const char *text, size_t size);

/* After the last source: tells what had no image, and closes standard output.
 * Returns the exit status. */
int stream_end(const struct job *);

#endif
