/* SPDX-License-Identifier: MIT */
/* Tells on standard error how far a long input is: if that is a terminal and
 * standard output is none, or if asked to. */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

/* Only the first call counts. */
void progress_start(bool asked);

/* The next source begins; size in bytes, 0 where it isn't known. */
void progress_source(long long size);

/* So many more lines and bytes are done. */
void progress_add(size_t lines, size_t bytes);

/* Takes the line off the terminal, before anything else is said. */
void progress_clear(void);

/* After the last source: the same, but if it was asked for it stays. */
void progress_end(void);

#endif
