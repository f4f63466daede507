/* Points as numbers without separators. */
#ifndef BINARY_H
#define BINARY_H

#include "chunk.h"

/* Reads up to a block of points into columns; returns how many. */
size_t binary_read(const struct job *, struct chunk *, size_t *points);

/* Writes v, the image of point p. */
void binary_write(const struct job *, struct chunk *, size_t p,
    const double *v);

/* A whole block, where each point of it is written and nothing else is; line
 * is the first one's. */
void binary_write_block(const struct job *, struct chunk *, size_t n,
    size_t line);

#endif
