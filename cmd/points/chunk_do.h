/* The job, done on a chunk. */
#ifndef CHUNK_DO_H
#define CHUNK_DO_H

#include "chunk.h"
#include "job.h"

/* Fills out from whole lines, or whole binary points, up to the first bad one
 * where the job does not keep going. */
void chunk_do(struct job *, struct chunk *);

#endif
