/* SPDX-License-Identifier: MIT */
/* Declare sched_getaffinity on Linux, and elsewhere _SC_NPROCESSORS_ONLN, which POSIX
 * does not have. */
#define _GNU_SOURCE
#define _DARWIN_C_SOURCE
#define __BSD_VISIBLE 1
#include "job.h"

#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* The size of a thread's stack in bytes. Systems give 128 KB or more. inspect needs up
 * to 192 KB, as a map is 7 KB of exact numbers. */
enum { STACK_SIZE = 1 << 20 };

/* Starts a thread with STACK_SIZE. Returns 0 or an error, as pthread_create. */
static int start_thread(pthread_t *t, void *(*run)(void *), void *with)
{
	pthread_attr_t attributes;
	int error = pthread_attr_init(&attributes);

	if (error != 0)
		return error;
	pthread_attr_setstacksize(&attributes, STACK_SIZE);
	error = pthread_create(t, &attributes, run, with);
	pthread_attr_destroy(&attributes);
	return error;
}

void call_with_stack(void *(*run)(void *), void *with)
{
	struct rlimit limit;
	pthread_t t;

	if (getrlimit(RLIMIT_STACK, &limit) != 0 ||
	    limit.rlim_cur >= STACK_SIZE) {
		run(with);
		return;
	}
	int error = start_thread(&t, run, with);

	if (error != 0)
		die(EXIT_SYSTEM, "the stack is too small, and a thread: %s",
		    strerror(error));
	pthread_join(t, NULL);
}

/* The bytes of a source for each thread that is started. With less to do, the start
 * would take more time than the thread saves. */
enum { PER_THREAD = 1 << 16 };

/* A thread without a chunk looks for one LOOKS times before it sleeps. Between two
 * looks it runs an empty loop PAUSE times: other threads read a piece of a file in less
 * time than the system takes to wake a thread. To yield the processor could cost
 * milliseconds if other programs run. */
enum { LOOKS = 100, PAUSE = 200 };

/* Each thread repeats three steps: it begins the next chunk, which reads from the
 * source and may wait for it; it does the job on the chunk; and if no other thread is
 * answering, it answers, in the order of the source, the chunks that are done. No
 * thread waits until another has answered, and no answer waits for the source.
 *
 * A chunk belongs to the thread that began it until it is done, then to the thread
 * that answers. The lock protects everything else. */
static struct {
	struct job *job;
	int most; /* threads that may be started */

	pthread_mutex_t lock;
	pthread_cond_t changed;
	/* started; of these, without a chunk and awake; asleep */
	int threads, looking, idle;
	struct chunk *unused; /* a stack, so that few are used */

	/* the source that is read */
	struct point_source *source;
	bool open;        /* it has not ended, and no thread is reading it */
	bool answering;   /* a thread is answering chunks */
	enum first first; /* see struct chunk */
	struct chunk *oldest, **newest; /* the queue of chunks begun */
} pool = {
	.lock = PTHREAD_MUTEX_INITIALIZER,
	.changed = PTHREAD_COND_INITIALIZER,
	.newest = &pool.oldest,
};

/* The functions from may_begin to run_chunks are called, and return, with the lock
 * held.
 *
 * Returns whether a thread can begin a chunk. Up to the first row, each chunk waits for
 * the one before it, which may have the csv header. */
static bool may_begin(void)
{
	return pool.open && pool.unused != NULL &&
	    (!pool.first || pool.oldest == NULL);
}

static bool is_finished(void)
{
	return !pool.open && pool.oldest == NULL;
}

static void add_unused(struct chunk *c)
{
	c->next = pool.unused;
	pool.unused = c;
}

static void *work(void *);

/* Wakes a thread if it can begin a chunk, or starts one, with two more chunks: one is
 * done while the other waits for its answer. */
static void call_thread(void)
{
	pthread_t t;

	if (!pool.open || pool.looking > 0)
		return;
	if (pool.idle > 0) {
		if (may_begin())
			pthread_cond_signal(&pool.changed);
	} else if (pool.threads < pool.most &&
	    pool.source->begun / PER_THREAD > (size_t)pool.threads) {
		add_unused(chunk_new());
		add_unused(chunk_new());
		if (start_thread(&t, work, NULL) == 0) {
			pthread_detach(t);
			pool.threads++;
		} else {
			pool.most = pool.threads;
		}
	}
}

static struct chunk *begin_chunk(void)
{
	struct chunk *c = pool.unused;

	pool.unused = c->next;
	*pool.newest = c;
	pool.newest = &c->next;
	c->next = NULL;
	c->first = pool.first;
	c->done = false;
	pool.open = false;
	pthread_mutex_unlock(&pool.lock);
	source_read(pool.source, &pool.job->layout, &c->piece);
	pthread_mutex_lock(&pool.lock);
	pool.open = c->piece.state < PIECE_LAST;
	/* this thread may do the chunk before a slow stream has more bytes */
	if (c->piece.state != PIECE_EARLY)
		call_thread();
	return c;
}

/* Answers the next chunks up to the first that is not done. */
static void answer_done(void)
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
			pool.newest = &pool.oldest;
		add_unused(c);
		if (c->next == NULL)
			call_thread();
	}
	pool.answering = false;
}

/* Does chunks, forever or until the source is finished. */
static void run_chunks(bool forever)
{
	int looks = 0;

	while (forever || !is_finished()) {
		if (may_begin()) {
			struct chunk *c = begin_chunk();

			pthread_mutex_unlock(&pool.lock);
			job_do(pool.job, c);
			pthread_mutex_lock(&pool.lock);
			pool.first = c->first;
			c->done = true;
			answer_done();
			if (is_finished())
				pthread_cond_broadcast(&pool.changed);
			looks = 0;
		} else if (looks++ < LOOKS) {
			pool.looking++;
			pthread_mutex_unlock(&pool.lock);
			for (volatile int i = 0; i < PAUSE; i++)
				continue;
			pthread_mutex_lock(&pool.lock);
			pool.looking--;
		} else {
			pool.idle++;
			pthread_cond_wait(&pool.changed, &pool.lock);
			pool.idle--;
			looks = 0;
		}
	}
}

static void *work(void *unused)
{
	pthread_mutex_lock(&pool.lock);
	run_chunks(true);
	return unused;
}

/* Returns how many threads the job gets: at most one for each processor, as two would
 * evict each other's data from its cache. */
static int count_threads(int wanted)
{
	int processors = (int)sysconf(_SC_NPROCESSORS_ONLN);
#ifdef CPU_COUNT
	cpu_set_t set;

	if (sched_getaffinity(0, sizeof set, &set) == 0)
		processors = CPU_COUNT(&set);
#endif
	return 0 < wanted && wanted < processors ? wanted : processors;
}

void stream(struct job *j, struct point_source s)
{
	answer_source(j, &s);
	pthread_mutex_lock(&pool.lock);
	if (pool.job == NULL) {
		pool.job = j;
		pool.most = count_threads(j->threads) - 1;
		add_unused(chunk_new());
	}
	pool.source = &s;
	pool.open = true;
	pool.first = FIRST_LINE;
	j->layout.told.n = 0;
	run_chunks(false);
	pthread_mutex_unlock(&pool.lock);
}
