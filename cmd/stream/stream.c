/* SPDX-License-Identifier: MIT */
/* for sched_getaffinity, where there is one, and elsewhere for sysconf's count of
 * processors, which POSIX has not */
#define _GNU_SOURCE
#define _DARWIN_C_SOURCE
#define __BSD_VISIBLE 1
#include "stream.h"

#include <pthread.h>
#include <sched.h>
#include <unistd.h>

#include "stack.h"
#include "../message/message.h"
#include "answer.h"
#include "progress.h"

/* What a thread does again and again: in its turn it begins a chunk, which may
 * be to wait for a stream; it does the job on it; and if nobody is answering, it
 * answers all chunks that are done and next. So nobody waits for another to
 * answer, and no answer for the source.
 *
 * A chunk is one thread's, from its beginning until it is done and from then on
 * that of who answers. All else changes under the lock. */
static struct {
	/* These stay. */
	struct job *job;
	int most;              /* threads that there may be */
	size_t n;              /* chunks that there may be */
	struct chunk **chunk;  /* the k-th of the source is chunk[k % n] */
	struct chunk **unused; /* those used last are last */

	pthread_mutex_t lock;
	pthread_cond_t may_begin, all_answered;
	int threads, idle; /* that run, and of them that wait to begin */

	/* Of the source in hand. */
	struct point_source *source;
	bool open;   /* there may be more */
	bool shared; /* the threads may take part */
	bool first;  /* the source's first line that counts is still to come */
	bool beginning, answering; /* somebody is */
	struct chunk *last; /* its last, when that is answered; else NULL */
	size_t begun, answered, n_unused; /* chunks */
} ring = {
	.lock = PTHREAD_MUTEX_INITIALIZER,
	.may_begin = PTHREAD_COND_INITIALIZER,
	.all_answered = PTHREAD_COND_INITIALIZER,
};

/* may_begin to do_chunk, and can_share, are called with the lock held, and return
 * with it. */
static void lock(void)
{
	pthread_mutex_lock(&ring.lock);
}

static void unlock(void)
{
	pthread_mutex_unlock(&ring.lock);
}

static bool may_begin(void)
{
	return ring.open && !ring.beginning && ring.n_unused > 0;
}

static void *work(void *);

/* Starts a thread if there can be one more. */
static bool start_thread(void)
{
	pthread_t t;

	if (ring.threads == ring.most)
		return false;
	if (start_with_stack(&t, work, NULL) != 0) {
		ring.most = ring.threads;
		return false;
	}
	pthread_detach(t);
	ring.threads++;
	return true;
}

/* Lets one more thread begin a chunk, if it can. */
static void call_thread(void)
{
	if (!ring.shared || !may_begin())
		return;
	if (ring.idle > 0)
		pthread_cond_signal(&ring.may_begin);
	else
		start_thread();
}

static struct chunk *stream_begin(void)
{
	struct chunk **c = &ring.unused[--ring.n_unused];

	if (*c == NULL)
		*c = chunk_new();
	struct chunk *mine = *c;

	mine->number = ring.begun;
	mine->name = ring.source->name;
	mine->first = ring.first;
	mine->done = false;
	ring.beginning = true;
	unlock();
	source_begin(ring.source, &ring.job->layout, &mine->piece);
	lock();
	ring.beginning = false;
	ring.chunk[ring.begun++ % ring.n] = mine;
	return mine;
}

/* Answers the chunks that are next, as far as they are done. What was read
 * behind the end of a file that changes meanwhile doesn't count. */
static void stream_answer(void)
{
	struct chunk *c;

	if (ring.answering)
		return;
	ring.answering = true;
	while (ring.answered < ring.begun &&
	    (c = ring.chunk[ring.answered % ring.n])->done) {
		if (ring.last == NULL) {
			unlock();
			answer_chunk(ring.job, c);
			lock();
			if (c->piece.state == PIECE_LAST)
				ring.last = c;
		}
		ring.unused[ring.n_unused] = c;
		ring.answered++;
		if (ring.n_unused++ == 0)
			call_thread();
	}
	ring.answering = false;
}

static bool is_finished(void)
{
	return !ring.open && !ring.beginning && ring.answered == ring.begun;
}

static void do_chunk(void)
{
	struct chunk *c = stream_begin();

	ring.open = ring.open && c->piece.state < PIECE_LAST;
	/* where a stream has no more yet, this thread may be back in time */
	if (c->piece.state != PIECE_EARLY)
		call_thread();
	unlock();
	source_read(ring.source, &ring.job->layout, &c->piece, c->number);
	c->text = c->piece.got.s;
	c->end = c->piece.got.end;
	job_do(ring.job, c);
	lock();
	ring.open = ring.open && c->piece.state < PIECE_LAST;
	ring.first = c->first;
	c->done = true;
	stream_answer();
	if (is_finished())
		pthread_cond_signal(&ring.all_answered);
}

static void *work(void *unused)
{
	lock();
	for (;;) {
		while (!ring.shared || !may_begin()) {
			ring.idle++;
			pthread_cond_wait(&ring.may_begin, &ring.lock);
			ring.idle--;
		}
		do_chunk();
	}
	return unused;
}

int stream_processors(void)
{
#ifdef CPU_COUNT
	cpu_set_t set;

	if (sched_getaffinity(0, sizeof set, &set) == 0)
		return CPU_COUNT(&set);
#endif
	return (int)sysconf(_SC_NPROCESSORS_ONLN);
}

/* More than one for each processor would only take its caches from each other: a
 * sixteenth more CPU time, and a tenth more of the clock's. */
static int useful_threads(int wanted)
{
	int most = stream_processors();

	return wanted < 2 ? 0 : wanted < most ? wanted : most;
}

static void set_up(struct job *j)
{
	ring.job = j;
	ring.most = useful_threads(j->threads);
	/* one for each thread, and as many that wait to be answered */
	ring.n = 2 * (size_t)ring.most + 1;
	ring.n_unused = ring.n;
	ring.chunk = need(NULL, ring.n * sizeof *ring.chunk);
	ring.unused = need(NULL, ring.n * sizeof *ring.unused);
	for (size_t i = 0; i < ring.n; i++)
		ring.unused[i] = NULL;
}

/* Whether the threads can go on with the source: its first chunk, which may be
 * all there is, is done without them, and each up to the one with the first line
 * that counts, as only a csv header tells where in all others the columns are. */
static bool can_share(void)
{
	return !ring.open ||
	    (!ring.first && (ring.threads > 0 || start_thread()));
}

static void stream(struct job *j, struct point_source *s)
{
	progress_source(s->size);
	answer_source();
	if (ring.chunk == NULL)
		set_up(j);
	lock();
	ring.source = s;
	ring.open = true;
	ring.first = !is_binary(j->layout.in.format);
	ring.last = NULL;
	ring.begun = ring.answered = 0;
	do
		do_chunk();
	while (!can_share());
	ring.shared = true;
	call_thread();
	while (!is_finished())
		pthread_cond_wait(&ring.all_answered, &ring.lock);
	ring.shared = false;
	unlock();
	source_end(s, &ring.last->piece);
}

void stream_file(struct job *j, const char *name, int fd)
{
	struct point_source s = source_of_file(name, fd);

	stream(j, &s);
}

void stream_text(struct job *j, const char *name, const char *text, size_t size)
{
	struct point_source s = { .name = name,
		.kind = SOURCE_TEXT,
		.size = (off_t)size,
		.text = text,
		.end = text + size };

	stream(j, &s);
}
