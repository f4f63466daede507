/* SPDX-License-Identifier: MIT */
/* Reads and writes blocks of binary points. A record is a binary point that may have
 * other numbers beside the coordinates; a row is the coordinates alone. */
#pragma once

#include "job.h"

/* Returns whether the job writes a binary image for every binary point of its input. */
bool binary_is_rows(const struct job *);

/* Reads a block. Sets its lines only if a point is bad or binary_is_rows is false. */
void binary_read_block(const struct job *, struct chunk *);

/* Reads, transforms and writes a block of floats in precision single. Reads nothing and
 * returns false if it is another, or points_map_floats returns false. */
bool binary_map_floats(const struct job *, struct chunk *);

/* Appends the images of the block, whose points begin at `text`. If an image is not
 * finite, or point_exact_float has to round, only sets the lines, and returns false. */
bool binary_write_rows(const struct job *, struct chunk *, const char *text);

/* Writes the images of the block and, for a bad point, nan. `outside` has the planes
 * that point p is outside of, for --visible. */
void binary_put_block(const struct job *, struct chunk *, const unsigned char *outside);
