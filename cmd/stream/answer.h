/* SPDX-License-Identifier: MIT */
/* What the user gets: chunks whose job is done are printed, counted and
 * complained of, in the order of their source. */
#ifndef ANSWER_H
#define ANSWER_H

#include "job.h"

/* A new source begins: lines are counted from 1 again. */
void answer_source(void);

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
