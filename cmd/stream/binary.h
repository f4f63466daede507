/* SPDX-License-Identifier: MIT */
/* Reads and writes blocks of binary points. A record is a binary point that may have
 * other numbers beside the coordinates; a row is the coordinates alone. */
#pragma once

#include "job.h"

/* Returns whether the job writes a binary image for every binary point of its input. */
bool binary_is_rows(const struct job *);

/* Reads a block of up to POINTS_BLOCK binary points. Sets the lines of the block only
 * if a point is bad or binary_is_rows is false. */
void binary_read_block(const struct job *, struct chunk *);

/* Reads, transforms and writes a block of floats in precision single. Reads nothing and
 * returns false if it is another, or points_map_floats returns false. */
bool binary_map_floats(const struct job *, struct chunk *);

/* Appends the images of the block, whose points begin at `text`. If an image is not
 * finite, or point_exact_float has to round, only sets the lines, and returns false. */
bool binary_write_rows(const struct job *, struct chunk *, const char *text);

/* Appends a binary point for each point and bad line of the block: the point's image,
 * or nan. If only visible points are printed, leaves out the others and bad lines. */
void binary_write_lines(const struct job *, struct chunk *,
    const unsigned char *outside);
