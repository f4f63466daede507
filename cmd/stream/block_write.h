/* SPDX-License-Identifier: MIT */
/* The lines of a block, or its binary points, with their images in the place of
 * them. */
#ifndef BLOCK_WRITE_H
#define BLOCK_WRITE_H

#include "job.h"

/* Appends n lines, or binary points, to the chunk's out; number is that of the
 * first, and points how many of them are points, whose images the chunk has. */
void block_write(const struct job *, struct chunk *, size_t n, size_t points,
    size_t number);

/* The word for the planes that a point is outside of: in, or left+near. It stays
 * the chunk's. */
const struct word *word_for(struct chunk *, unsigned outside);

/* Appends what stands for a binary point that is not whole. */
void block_write_nan(const struct job *, struct chunk *);

#endif
