/* SPDX-License-Identifier: MIT */
/* Points as binary numbers in a row. */
#ifndef BINARY_H
#define BINARY_H

#include "job.h"

/* Returns whether blocks of images are written as they are: every binary point
 * becomes as many bytes, and no command wants to see it. */
bool binary_is_whole(const struct job *);

/* As block_read does; but the chunk has no lines if all is well and
 * binary_is_whole. */
size_t binary_read(const struct job *, struct chunk *, size_t *points);

/* Transforms the next points, at most a block, from floats to floats in single
 * precision. Returns false, with nothing done, where one has no image. */
bool binary_carry(const struct job *, struct chunk *);

/* Appends the images of the n binary points that were read last, of four coordinates
 * at most. Returns false, with nothing done but the chunk's lines, where one has no
 * image or is to be looked at. */
bool binary_join(const struct job *, struct chunk *, size_t n);

/* Returns v, coordinate k of the image of point p, as a float. */
float binary_float(const struct job *, const struct chunk *, size_t p, int k,
    double v);

/* Returns how many bytes are written for each point. */
size_t binary_written(const struct layout *);

/* Writes the image of a line that is point p, or nan for a bad one, and returns where
 * it ends. */
char *binary_put(const struct job *, const struct chunk *, const struct line *,
    size_t p, char *at);

#endif
