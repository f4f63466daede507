/* SPDX-License-Identifier: MIT */
/* These macros make headers declare sched_getaffinity and _SC_NPROCESSORS_ONLN. */
#define _GNU_SOURCE
#define _DARWIN_C_SOURCE
#define __BSD_VISIBLE 1
#include "stream.h"

#include <pthread.h>
#include <sched.h>
#include <unistd.h>

#include "answer.h"

/* The size of a thread's stack in bytes. By default some systems give 128 KB. */
enum { STACK_SIZE = 1 << 20 };

static int start_thread(pthread_t *t, void *(*run)(void *), void *data)
{
	pthread_attr_t attributes;
	int error = pthread_attr_init(&attributes);

	if (error != 0)
		return error;
	pthread_attr_setstacksize(&attributes, STACK_SIZE);
	error = pthread_create(t, &attributes, run, data);
	pthread_attr_destroy(&attributes);
	return error;
}

/* Bytes of a source for each thread: for fewer its start costs more than it saves. */
enum { BYTES_PER_THREAD = 1 << 16 };

/* A thread without a chunk looks LOOKS_MAX times for one before it sleeps, as to wake
 * takes longer than to read a piece. Between two looks it runs an empty loop:
 * sched_yield could cost milliseconds if other programs run. */
enum { LOOKS_MAX = 100, PAUSE_LOOPS = 200 };

/* Each thread begins the next chunk, which may wait for input; does the job on it; and
 * answers (prints) chunks that are done, in order, if no other does. No thread waits
 * for an answer, and no answer for the source. A chunk belongs to the thread that began
 * it, then to the one that answers. The lock protects everything else. */
static struct {
	struct job *job;
	int started_max; /* the largest value that `started` may reach */

	pthread_mutex_t lock;
	pthread_cond_t changed; /* wakes threads that are asleep */
	/* numbers of threads: started so far; awake without a chunk; asleep */
	int started, looking, asleep;
	struct chunk *unused; /* a stack, so that few chunks are in use */

	struct point_source *source;
	bool can_read;        /* source has not ended, and no thread reads it */
	bool answering;       /* a thread is answering chunks */
	enum next_part first; /* see struct chunk */
	struct chunk *oldest, **queue_end; /* chunks begun but not answered */
} pool = {
	.lock = PTHREAD_MUTEX_INITIALIZER,
	.changed = PTHREAD_COND_INITIALIZER,
	.queue_end = &pool.oldest,
};

/* Before the first row, a chunk waits until the previous one, which may have the
 * header, is answered. The lock is held from here to run_chunks. */
static bool can_begin_chunk(void)
{
	return pool.can_read && pool.unused != NULL &&
	    (!pool.first || pool.oldest == NULL);
}

static bool is_finished(void)
{
	return !pool.can_read && pool.oldest == NULL;
}

static void add_unused(struct chunk *c)
{
	c->next = pool.unused;
	pool.unused = c;
}

static void *thread_main(void *);

/* Wakes a sleeping thread, or starts one with two chunks: to work on, and to answer. */
static void wake_or_start_thread(void)
{
	pthread_t t;

	if (!pool.can_read || pool.looking > 0)
		return;
	if (pool.asleep > 0) {
		if (can_begin_chunk())
			pthread_cond_signal(&pool.changed);
	} else if (pool.started < pool.started_max &&
	    pool.source->bytes_read / BYTES_PER_THREAD > (size_t)pool.started) {
		add_unused(chunk_new());
		add_unused(chunk_new());
		if (start_thread(&t, thread_main, NULL) == 0) {
			pthread_detach(t);
			pool.started++;
		} else {
			pool.started_max = pool.started;
		}
	}
}

static struct chunk *begin_chunk(void)
{
	struct chunk *c = pool.unused;

	pool.unused = c->next;
	*pool.queue_end = c;
	pool.queue_end = &c->next;
	c->next = NULL;
	c->first = pool.first;
	c->done = false;
	pool.can_read = false;
	pthread_mutex_unlock(&pool.lock);
	source_read(pool.source, &pool.job->layout, &c->piece);
	pthread_mutex_lock(&pool.lock);
	pool.can_read = c->piece.state < PIECE_LAST;
	/* after PIECE_EARLY the source is slow: no other thread is needed */
	if (c->piece.state != PIECE_EARLY)
		wake_or_start_thread();
	return c;
}

static void answer_done_chunks(void)
{
	struct chunk *c;

	if (pool.answering)
		return;
	pool.answering = true;
	while ((c = pool.oldest) != NULL && c->done) {
		pthread_mutex_unlock(&pool.lock);
		answer_chunk(pool.job, c);
		pthread_mutex_lock(&pool.lock);
		pool.oldest = c->next;
		if (pool.oldest == NULL)
			pool.queue_end = &pool.oldest;
		add_unused(c);
		if (c->next == NULL)
			wake_or_start_thread();
	}
	pool.answering = false;
}

/* Works on chunks, endlessly if `forever` is set, else until the source is finished. */
static void run_chunks(bool forever)
{
	int looks = 0;

	while (forever || !is_finished()) {
		if (can_begin_chunk()) {
			struct chunk *c = begin_chunk();

			pthread_mutex_unlock(&pool.lock);
			job_do(pool.job, c);
			pthread_mutex_lock(&pool.lock);
			pool.first = c->first;
			c->done = true;
			answer_done_chunks();
			if (is_finished())
				pthread_cond_broadcast(&pool.changed);
			looks = 0;
		} else if (looks++ < LOOKS_MAX) {
			pool.looking++;
			pthread_mutex_unlock(&pool.lock);
			for (volatile int i = 0; i < PAUSE_LOOPS; i++)
				continue;
			pthread_mutex_lock(&pool.lock);
			pool.looking--;
		} else {
			pool.asleep++;
			pthread_cond_wait(&pool.changed, &pool.lock);
			pool.asleep--;
			looks = 0;
		}
	}
}

static void *thread_main(void *unused)
{
	pthread_mutex_lock(&pool.lock);
	run_chunks(true);
	return unused;
}

/* More threads than processors would evict each other's caches. */
static int count_threads(int wanted)
{
	int processors = (int)sysconf(_SC_NPROCESSORS_ONLN);
#if defined CPU_COUNT && !defined __EMSCRIPTEN__
	cpu_set_t set;

	if (sched_getaffinity(0, sizeof set, &set) == 0)
		processors = CPU_COUNT(&set);
#endif
	return 0 < wanted && wanted < processors ? wanted : processors;
}

void stream_points(struct job *j, struct point_source s)
{
	answer_begin_source(j, &s);
	pthread_mutex_lock(&pool.lock);
	if (pool.job == NULL) {
		pool.job = j;
		pool.started_max = count_threads(j->threads) - 1;
		add_unused(chunk_new());
	}
	pool.source = &s;
	pool.can_read = true;
	pool.first = FIRST_BYTE;
	run_chunks(false);
	pthread_mutex_unlock(&pool.lock);
	j->layout.plan.drops_bom = true;
}
