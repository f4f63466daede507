/* SPDX-License-Identifier: MIT */
/* Prints the output of chunks in the order of their source, reports bad lines and points
 * without image, and shows progress on standard error. To answer a chunk is to print its
 * output. The totals of the call are kept here. */
#pragma once

#include "job.h"

/* At the first call, turns progress on if `asked`, or if only stderr is a terminal. */
void answer_start_progress(bool asked);

/* Says that the next chunks are of this source. Its lines are counted from 1. */
void answer_begin_source(const struct job *, const struct point_source *);

/* Prints the output of the next chunk. Then reports its bad lines, which end the
 * program unless the job keeps going, and an error that ended its source, which always
 * ends the program. Any thread may call answer_chunk, but only one at a time. */
void answer_chunk(const struct job *, struct chunk *);

/* Counts a scene that was refused, and prints null for it if the format is JSON. */
void answer_refused_scene(enum format);

/* Reports how many lines are bad, how many points have no image and, by --progress, all
 * lines. Closes standard output, and returns the exit status. */
int answer_end(void);
