/* SPDX-License-Identifier: MIT */
/* Points as binary numbers in a row. */
#ifndef BINARY_H
#define BINARY_H

#include "job.h"

/* Reads points, up to POINTS_BLOCK, into the chunk's columns. Returns how
 * many. */
size_t binary_read(const struct job *, struct chunk *);

/* Transforms the next points, at most a block, from floats to floats in single
 * precision. Returns false, with nothing done, where one has no image. */
bool binary_carry(const struct job *, struct chunk *);

/* chunk_mark; but a double midway to infinity counts as the float that the exact image
 * is rounded to. */
void binary_mark(const struct job *, struct chunk *, size_t p, size_t line);

/* Writes v, the image of point p of the block. Where v is nan, p does not
 * matter. */
void binary_write(const struct job *, struct chunk *, size_t p,
    const double *v);

/* Writes the images of the block's n points, of four coordinates at most, after
 * chunk_mark of those that have none; first_line is the number of the first. */
void binary_write_block(const struct job *, struct chunk *, size_t n,
    size_t first_line);

#endif
