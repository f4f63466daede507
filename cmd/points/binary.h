/* Points as numbers without separators. */
#ifndef BINARY_H
#define BINARY_H

#include "chunk.h"
#include "job.h"

/* Reads up to a block of points into columns; returns how many. */
size_t binary_read(const struct job *, struct chunk *);

/* Writes v, the image of point p; where v is nan, p may be any. */
void binary_write(const struct job *, struct chunk *, size_t p,
    const double *v);

/* Writes the images of a block of n points as f64, and marks those that have
 * none; line is the number of the first. */
void binary_write_block(const struct job *, struct chunk *, size_t n,
    size_t line);

#endif
