/* How far a long input is, on standard error: where that is a terminal and
 * standard output is none, or where it is asked for. */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

void progress_start(bool asked);

/* The next source; its size is 0 where that isn't known. */
void progress_source(size_t size);

/* So many more are done. */
void progress_add(size_t lines, size_t bytes);

/* Takes the line off the terminal, before anything else is said. */
void progress_clear(void);

/* The same after the last source, but where it was asked for it stays. */
void progress_end(void);

#endif
