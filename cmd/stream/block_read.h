/* SPDX-License-Identifier: MIT */
/* The lines of a block, and the points on them. */
#ifndef BLOCK_READ_H
#define BLOCK_READ_H

#include "job.h"

/* Reads up to POINTS_BLOCK lines, and the points among them into the chunk's
 * columns. A bad line ends the chunk unless the job keeps going. Returns how
 * many lines, and in *points how many of them are points. */
size_t block_read(struct job *, struct chunk *, size_t *points);

#endif
