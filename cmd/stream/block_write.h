/* SPDX-License-Identifier: MIT */
/* The lines of a block, with images in the place of their points. */
#ifndef BLOCK_WRITE_H
#define BLOCK_WRITE_H

#include "job.h"

/* Appends n lines to the chunk's out; number is that of the first, and points how many
 * of them are points, whose images the chunk has. */
void block_write(const struct job *, struct chunk *, size_t n, size_t points,
    size_t number);

/* Returns the word for the planes that a point is outside of: in, or left+near. It
 * stays the chunk's. */
const struct word *word_for(struct chunk *, unsigned outside);

#endif
