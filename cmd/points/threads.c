#include "threads.h"

#include <pthread.h>
#include <string.h>

#include "../talk.h"
#include "answer.h"

/* The k-th chunk of all sources is kept in chunks[k % n]. The reader, the
 * thread that calls the functions of threads.h, fills it; one of the threads
 * takes it, does the job on it and, once the chunk before is answered, answers
 * it, so that no answer waits for the reader. Nobody else looks at a chunk that
 * is the reader's, until it counts as filled, or a thread's, until it counts as
 * answered. */
static struct {
	int threads; /* that run; the reader alone asks */

	/* Set before the first thread starts. */
	struct job *job;
	struct chunk **chunks;
	size_t n;

	/* Counts of chunks. They change under the lock; the reader, who alone
	 * changes filled, may read that one without. */
	size_t filled, taken, answered;
	pthread_mutex_t lock;
	pthread_cond_t is_filled, is_answered; /* the count has grown */
} ring = {
	.lock = PTHREAD_MUTEX_INITIALIZER,
	.is_filled = PTHREAD_COND_INITIALIZER,
	.is_answered = PTHREAD_COND_INITIALIZER,
};

static void *work(void *unused)
{
	pthread_mutex_lock(&ring.lock);
	for (;;) {
		while (ring.taken == ring.filled)
			pthread_cond_wait(&ring.is_filled, &ring.lock);
		size_t k = ring.taken++;
		struct chunk *c = ring.chunks[k % ring.n];

		pthread_mutex_unlock(&ring.lock);
		job_do(ring.job, c);
		pthread_mutex_lock(&ring.lock);
		while (ring.answered != k)
			pthread_cond_wait(&ring.is_answered, &ring.lock);
		pthread_mutex_unlock(&ring.lock);
		answer_chunk(ring.job, c);
		pthread_mutex_lock(&ring.lock);
		ring.answered++;
		pthread_cond_broadcast(&ring.is_answered);
	}
	return unused;
}

/* Waits until at most n chunks are on their way. */
static void wait_for(size_t n)
{
	pthread_mutex_lock(&ring.lock);
	while (ring.filled - ring.answered > n)
		pthread_cond_wait(&ring.is_answered, &ring.lock);
	pthread_mutex_unlock(&ring.lock);
}

void threads_wait(void)
{
	wait_for(0);
}

/* Starts as many as the job wants, or as there can be: perhaps none. */
static void start_threads(const struct job *j)
{
	pthread_t t;

	for (; ring.threads < j->threads; ring.threads++) {
		if (pthread_create(&t, NULL, work, NULL) != 0)
			break;
		pthread_detach(t);
	}
}

static struct chunk *chunk_at(size_t k)
{
	struct chunk **c = &ring.chunks[k % ring.n];

	if (*c == NULL)
		*c = chunk_new();
	return *c;
}

struct chunk *threads_first(struct job *j)
{
	if (ring.chunks == NULL) {
		ring.job = j;
		ring.n = (size_t)j->threads + 2;
		ring.chunks = need(NULL, ring.n * sizeof *ring.chunks);
		memset(ring.chunks, 0, ring.n * sizeof *ring.chunks);
	}
	return chunk_at(ring.filled);
}

struct chunk *threads_next(void)
{
	wait_for(ring.n - 2);
	return chunk_at(ring.filled + 1);
}

/* The reader itself does the first chunk of a source, which may be all there
 * is, and each up to the one with a csv header, as only that tells where in the
 * lines of all others the columns are. */
void threads_hand_over(struct job *j, struct chunk *c)
{
	bool here = c->first || c->header || j->threads < 2;

	if (!here)
		start_threads(j);
	here |= ring.threads == 0;
	if (here) {
		job_do(j, c);
		answer_chunk(j, c);
	}
	pthread_mutex_lock(&ring.lock);
	ring.filled++;
	if (here) {
		ring.taken++;
		ring.answered++;
	} else {
		pthread_cond_signal(&ring.is_filled);
	}
	pthread_mutex_unlock(&ring.lock);
}
