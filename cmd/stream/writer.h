/* SPDX-License-Identifier: MIT */
/* Writes the lines of a block with the images of its points: most in place, where only
 * numbers change; splice.h and binary.h write all others. */
#pragma once

#include "job.h"

/* Appends the lines of a block; in a bad line each coordinate becomes nan. `outside`
 * has the planes that point p is outside of, for --flags and --visible. */
void writer_put_block(const struct job *, struct chunk *, const unsigned char *outside);
