/* Threads that do a job on chunks, and answer these in their order. One thread
 * more, the reader, fills the chunks: it alone calls these functions. */
#ifndef THREADS_H
#define THREADS_H

#include "job.h"

/* The chunk to be filled first. The job's contents may change only while no
 * chunk is on its way; the job itself must be the same at each call. */
struct chunk *threads_first(struct job *);

/* The chunk to be filled after that which is in hand, once it is free. */
struct chunk *threads_next(void);

/* The chunk in hand is filled: hands it over to the threads. */
void threads_hand_over(struct job *, struct chunk *);

/* Waits until all chunks that were handed over are answered. */
void threads_wait(void);

#endif
