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

/* The bytes of a source for each thread that is started. With less to do, the start would
 * take more time than the thread saves. */
enum { PER_THREAD = 1 << 16 };

/* A thread without a chunk looks for one that often before it sleeps, with pauses: others
 * read a piece of a file in less time than the system takes to wake a thread. To yield
 * the processor could cost milliseconds if other programs run. */
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
	int threads, looking, idle; /* started; without a chunk; asleep */
	struct chunk *unused;       /* a stack, so that few are used */

	/* the source that is read */
	struct point_source *source;
	bool open;        /* no thread reads it, nor has its end */
	bool answering;   /* a thread is doing so */
	enum first first; /* see struct chunk */
	struct chunk *oldest, **newest; /* the queue of chunks begun */
} ring = {
	.lock = PTHREAD_MUTEX_INITIALIZER,
	.changed = PTHREAD_COND_INITIALIZER,
	.newest = &ring.oldest,
};

/* The functions from may_begin to run_chunks are called, and return, with the lock
 * held.
 *
 * Returns whether a thread can begin a chunk. Up to the first row, each chunk waits for
 * the one before it, which may have the csv header. */
static bool may_begin(void)
{
	return ring.open && ring.unused != NULL &&
	    (!ring.first || ring.oldest == NULL);
}

static bool is_finished(void)
{
	return !ring.open && ring.oldest == NULL;
}

static void add_unused(struct chunk *c)
{
	c->next = ring.unused;
	ring.unused = c;
}

static void *work(void *);

/* Wakes a thread if it can begin a chunk, or starts one, with two more chunks: one is
 * done while the other waits for its answer. */
static void call_thread(void)
{
	pthread_t t;

	if (!ring.open || ring.looking > 0)
		return;
	if (ring.idle > 0) {
		if (may_begin())
			pthread_cond_signal(&ring.changed);
	} else if (ring.threads < ring.most &&
	    ring.source->begun / PER_THREAD > (size_t)ring.threads) {
		add_unused(chunk_new());
		add_unused(chunk_new());
		if (start_thread(&t, work, NULL) == 0) {
			pthread_detach(t);
			ring.threads++;
		} else {
			ring.most = ring.threads;
		}
	}
}

static struct chunk *begin_chunk(void)
{
	struct chunk *c = ring.unused;

	ring.unused = c->next;
	*ring.newest = c;
	ring.newest = &c->next;
	c->next = NULL;
	c->first = ring.first;
	c->done = false;
	ring.open = false;
	pthread_mutex_unlock(&ring.lock);
	source_read(ring.source, &ring.job->layout, &c->piece);
	pthread_mutex_lock(&ring.lock);
	ring.open = c->piece.state < PIECE_LAST;
	/* this thread may be back before a slow stream has more */
	if (c->piece.state != PIECE_EARLY)
		call_thread();
	return c;
}

/* Answers the next chunks up to the first that is not done. */
static void answer_done(void)
{
	struct chunk *c;

	if (ring.answering)
		return;
	ring.answering = true;
	while ((c = ring.oldest) != NULL && c->done) {
		pthread_mutex_unlock(&ring.lock);
		answer_chunk(ring.job, c);
		pthread_mutex_lock(&ring.lock);
		ring.oldest = c->next;
		if (ring.oldest == NULL)
			ring.newest = &ring.oldest;
		add_unused(c);
		if (c->next == NULL)
			call_thread();
	}
	ring.answering = false;
}

/* Does chunks, forever or until the source is finished. */
static void run_chunks(bool forever)
{
	int looks = 0;

	while (forever || !is_finished()) {
		if (may_begin()) {
			struct chunk *c = begin_chunk();

			pthread_mutex_unlock(&ring.lock);
			job_do(ring.job, c);
			pthread_mutex_lock(&ring.lock);
			ring.first = c->first;
			c->done = true;
			answer_done();
			if (is_finished())
				pthread_cond_broadcast(&ring.changed);
			looks = 0;
		} else if (looks++ < LOOKS) {
			ring.looking++;
			pthread_mutex_unlock(&ring.lock);
			for (volatile int i = 0; i < PAUSE; i++)
				continue;
			pthread_mutex_lock(&ring.lock);
			ring.looking--;
		} else {
			ring.idle++;
			pthread_cond_wait(&ring.changed, &ring.lock);
			ring.idle--;
			looks = 0;
		}
	}
}

static void *work(void *unused)
{
	pthread_mutex_lock(&ring.lock);
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
	pthread_mutex_lock(&ring.lock);
	if (ring.job == NULL) {
		ring.job = j;
		ring.most = count_threads(j->threads) - 1;
		add_unused(chunk_new());
	}
	ring.source = &s;
	ring.open = true;
	ring.first = FIRST_LINE;
	run_chunks(false);
	pthread_mutex_unlock(&ring.lock);
}
