/* SPDX-License-Identifier: MIT */
/* Prints the output of chunks in order (answers them), bad lines and progress. */
#pragma once

#include "job.h"

/* At the first call, turns progress on if `asked`, or if only stderr is a terminal. */
void answer_start_progress(bool asked);

/* Says that the next chunks are of this source. Its lines are counted from 1. */
void answer_begin_source(const struct job *, const struct point_source *);

/* Prints the output of the next chunk; then its bad lines, unless the job keeps going,
 * and an error of its source end the program. Only one thread at a time may call it. */
void answer_chunk(struct job *, struct chunk *);

/* Prints bytes of a source that belong to no chunk, such as a header of names. */
void answer_text(const struct job *, struct span);

/* Ends the program, as the source is refused. */
_Noreturn void answer_refuse(const struct job *, const struct point_source *,
    const struct refusal *);

/* Counts a scene that was refused, and prints null for it if `prints_null` is set. */
void answer_refused_scene(bool prints_null);

/* Reports the totals, closes standard output, and returns the exit status. After an
 * error that has told its own, whose status is given, only closes. */
int answer_end(int status);
