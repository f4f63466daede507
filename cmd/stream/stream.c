/* SPDX-License-Identifier: MIT */
/* for sched_getaffinity, where there is one, and elsewhere for sysconf's count of
 * processors, which POSIX has not */
#define _GNU_SOURCE
#define _DARWIN_C_SOURCE
#define __BSD_VISIBLE 1
#include "stream.h"

#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "../message/message.h"
#include "answer.h"

/* The size of a thread's stack, as systems give from 128 KB on. A map is 7 KB of
 * exact numbers, of which inspect makes some while others wait: it takes between 144
 * and 160 KB where gcc compiles with -O2, and less than 192 with -O0. */
enum { STACK_SIZE = 1 << 20 };

/* Returns as pthread_create does. */
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

/* A thread does the same again and again: in its turn it begins a chunk, which may
 * be to wait for a stream; it does the job on it; and if no thread is answering, it
 * answers all chunks that are done and next. So no thread waits for another to
 * answer, and no answer for the source.
 *
 * A chunk is one thread's from its beginning until it is done, and from then on that
 * of the thread that answers. All else changes under the lock. */
static struct {
	/* These stay. */
	struct job *job;
	int most;              /* threads that may be started */
	size_t n;              /* chunks that there may be */
	struct chunk **chunk;  /* the k-th of the source is chunk[k % n] */
	struct chunk **unused; /* those used last are last */

	pthread_mutex_t lock;
	pthread_cond_t changed;
	int threads, idle; /* that were started; that wait */

	/* Of the source in hand. */
	struct point_source *source;
	bool open;                        /* there may be more */
	enum first first;                 /* which line is still to come */
	bool beginning, answering;        /* a thread is */
	size_t begun, answered, n_unused; /* chunks */
} ring = {
	.lock = PTHREAD_MUTEX_INITIALIZER,
	.changed = PTHREAD_COND_INITIALIZER,
};

/* may_begin to run_chunks are called with the lock held, and return with it. */
static void lock(void)
{
	pthread_mutex_lock(&ring.lock);
}

static void unlock(void)
{
	pthread_mutex_unlock(&ring.lock);
}

/* Up to the first row, one chunk after another is done, as only a csv
 * header tells where the columns are. */
static bool may_begin(void)
{
	return ring.open && !ring.beginning && ring.n_unused > 0 &&
	    (!ring.first || ring.answered == ring.begun);
}

static bool is_finished(void)
{
	return !ring.open && !ring.beginning && ring.answered == ring.begun;
}

static void *work(void *);

/* Lets one more thread begin a chunk, if it can. */
static void call_thread(void)
{
	pthread_t t;

	if (!may_begin())
		return;
	if (ring.idle > 0) {
		pthread_cond_signal(&ring.changed);
	} else if (ring.threads < ring.most) {
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
	struct chunk **unused = &ring.unused[--ring.n_unused];

	if (*unused == NULL)
		*unused = chunk_new();
	struct chunk *c = *unused;

	c->name = ring.source->name;
	c->first = ring.first;
	c->done = false;
	ring.beginning = true;
	unlock();
	source_read(ring.source, &ring.job->layout, &c->piece);
	lock();
	ring.beginning = false;
	ring.open = c->piece.state < PIECE_LAST;
	ring.chunk[ring.begun++ % ring.n] = c;
	/* where a stream has no more yet, this thread may be back in time */
	if (c->piece.state != PIECE_EARLY)
		call_thread();
	return c;
}

/* Answers the chunks that are next, as far as they are done. */
static void answer_done(void)
{
	struct chunk *c;

	if (ring.answering)
		return;
	ring.answering = true;
	while (ring.answered < ring.begun &&
	    (c = ring.chunk[ring.answered % ring.n])->done) {
		unlock();
		answer_chunk(ring.job, c);
		lock();
		ring.unused[ring.n_unused] = c;
		ring.answered++;
		if (ring.n_unused++ == 0)
			call_thread();
	}
	ring.answering = false;
}

/* Does chunks, for ever or until the source is finished. */
static void run_chunks(bool forever)
{
	while (forever || !is_finished()) {
		if (!may_begin()) {
			ring.idle++;
			pthread_cond_wait(&ring.changed, &ring.lock);
			ring.idle--;
			continue;
		}
		struct chunk *c = begin_chunk();

		unlock();
		job_do(ring.job, c);
		lock();
		ring.first = c->first;
		c->done = true;
		answer_done();
		if (is_finished())
			pthread_cond_broadcast(&ring.changed);
	}
}

static void *work(void *unused)
{
	lock();
	run_chunks(true);
	return unused;
}

/* Returns how many threads the job is given. More than one for each processor would
 * only take its caches from each other: a sixteenth more CPU time, and a tenth more
 * of the clock's. */
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

static void set_up(struct job *j)
{
	ring.job = j;
	ring.most = count_threads(j->threads) - 1;
	/* one for each thread, and as many that wait to be answered */
	ring.n = 2 * (size_t)ring.most + 1;
	ring.n_unused = ring.n;
	ring.chunk = need(NULL, ring.n * sizeof *ring.chunk);
	ring.unused = need(NULL, ring.n * sizeof *ring.unused);
	for (size_t i = 0; i < ring.n; i++)
		ring.unused[i] = NULL;
}

static void stream(struct job *j, struct point_source *s)
{
	answer_source(s->size);
	lock();
	if (ring.chunk == NULL)
		set_up(j);
	ring.source = s;
	ring.open = true;
	ring.first = is_binary(j->layout.in.format) ? FIRST_IS_READ :
						      FIRST_LINE;
	ring.begun = ring.answered = 0;
	run_chunks(false);
	unlock();
	free(s->rest.text);
}

void stream_file(struct job *j, const char *name, int fd)
{
	struct point_source s = source_of_file(name, fd);

	stream(j, &s);
}

void stream_text(struct job *j, const char *name, const char *text, size_t size)
{
	struct point_source s = { .name = name,
		.text = { text, text + size },
		.size = (off_t)size };

	stream(j, &s);
}
