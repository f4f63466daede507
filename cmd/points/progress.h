/* How far a long input is, on standard error: where that is a terminal and
 * standard output is none, or where it is asked for. */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

void progress_start(bool asked);

/* The next source; bytes is its size, 0 where that isn't known. */
void progress_source(size_t bytes);

void progress_add(size_t lines, size_t bytes);

/* Takes the line away, before anything else is said, or at the end. */
void progress_clear(void);
void progress_end(void);

#endif
