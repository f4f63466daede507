/* Threads that do a job on chunks, and answer these in their order. The thread
 * that reads a source fills the chunks, and it alone calls these functions: for
 * each source threads_first; for each chunk, when it is filled, threads_next and
 * threads_hand_over; threads_wait at the end. */
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
