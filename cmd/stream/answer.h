/* SPDX-License-Identifier: MIT */
/* What the user gets: chunks whose job is done are printed, counted and
 * complained of, in the order of their source; and progress on standard error. */
#ifndef ANSWER_H
#define ANSWER_H

#include "job.h"

/* Begins to tell how far a long input is: if standard error is a terminal and
 * standard output is none, or if asked to. Only the first call counts. */
void answer_progress(bool asked);

/* A new source of so many bytes begins, 0 where that is not known: lines are counted
 * from 1 again. */
void answer_source(long long size);

/* Prints the next chunk's output, then says what was wrong with its lines,
 * which ends the program unless the job keeps going, and why the source can't
 * be read any further, which ends it always. Any thread may call it, but not
 * two at a time. */
void answer_chunk(const struct job *, const struct chunk *);

/* Answers a scene that was refused: by null in JSON, else by nothing. */
void answer_no_scene(enum format);

/* At the end: says how many points had no image, and closes standard output.
 * Returns the exit status. */
int answer_end(void);

#endif
