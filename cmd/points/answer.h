/* What the user gets: done chunks are printed, counted and complained of, in
 * the order of their source. */
#ifndef ANSWER_H
#define ANSWER_H

#include "chunk.h"
#include "job.h"

/* A source begins: its lines are counted from 1. */
void answer_source(void);

/* The next chunk's output, then what was wrong with its lines, which ends the
 * program unless the job keeps going. Any thread may call it, but not two at a
 * time. */
void answer_chunk(const struct job *, const struct chunk *);

/* The number of the line behind the last chunk. */
size_t answer_line(void);

/* As stream_end. */
int answer_end(const struct job *);

#endif
