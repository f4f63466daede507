/* for F_SETPIPE_SZ, where there is one */
#define _GNU_SOURCE
#include "stream.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <string.h>
#include <sys/stat.h>

#include "answer.h"
#include "piece.h"
#include "progress.h"
#include "../talk.h"

/* A chunk, and the piece of the source that its text is in. */
struct slot {
	struct chunk *chunk;
	struct piece piece;
};

/* The k-th chunk of all goes through slot k % n. The reader, which is the
 * thread that calls stream_file, fills the slot; one of the threads takes the
 * chunk, does the job on it and, once the chunk before is answered, answers it,
 * so that no answer waits for the reader. Nobody else looks into a slot that is
 * the reader's, until its chunk counts as filled, or a thread's, until the
 * chunk counts as answered. */
static struct {
	int threads; /* that run; the reader alone asks */

	/* Set before the first thread starts. The job's contents change only
	 * while no chunk is on its way. */
	struct job *job;
	struct slot *slots;
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
		struct chunk *c = ring.slots[k % ring.n].chunk;

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

/* As many as there can be, perhaps none. */
static void start_threads(const struct job *j)
{
	pthread_t t;

	for (; ring.threads < j->threads; ring.threads++) {
		if (pthread_create(&t, NULL, work, NULL) != 0)
			break;
		pthread_detach(t);
	}
}

static void make_ring(struct job *j)
{
	if (ring.slots != NULL)
		return;
	ring.job = j;
	ring.n = (size_t)j->threads + 2;
	ring.slots = need(NULL, ring.n * sizeof *ring.slots);
	memset(ring.slots, 0, ring.n * sizeof *ring.slots);
}

/* The slot for the k-th chunk, which no other is in any more; what the piece
 * before holds behind end is in it. */
static struct slot *slot_of(size_t k, const struct piece *before,
    const char *end)
{
	struct slot *s = &ring.slots[k % ring.n];

	if (s->chunk == NULL)
		s->chunk = chunk_new();
	piece_begin(&s->piece, before, end);
	return s;
}

/* Fills the slot; returns whether the source ends with it. What was read is
 * answered before an error of the source ends the program. */
static bool fill(const struct job *j, const char *name, int fd, struct slot *s)
{
	enum piece_state state = piece_fill(&s->piece, &j->layout, fd);
	int error = errno;

	if (state == PIECE_FULL || state == PIECE_LAST)
		return state == PIECE_LAST;
	wait_for(0);
	if (j->flush != NULL)
		j->flush(j);
	if (state == PIECE_TOO_LONG)
		die(EXIT_INPUT, "%s:%zu: a line of more than 64 MiB", name,
		    answer_line());
	die(EXIT_SYSTEM, "%s: %s", name, strerror(error));
}

/* The reader itself does the first chunk of a source, which may be all there
 * is, and each up to the one with a csv header, as only that tells where in the
 * lines of all others the columns are. */
static void hand_over(struct job *j, struct chunk *c)
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

/* The size of a file; 0 of what is none. */
static size_t size_of(int fd)
{
	struct stat st;

	return fstat(fd, &st) == 0 && S_ISREG(st.st_mode) ? (size_t)st.st_size :
							    0;
}

void stream_file(struct job *j, const char *name, int fd)
{
	bool ended = false, first = true;
	bool header = j->layout.in == FORMAT_CSV;

#ifdef F_SETPIPE_SZ
	/* fewer and larger reads; where it is refused, all is as it was */
	fcntl(fd, F_SETPIPE_SZ, 1 << 20);
#endif
	progress_source(size_of(fd));
	answer_source();
	make_ring(j);
	struct slot *s = slot_of(ring.filled, NULL, NULL), *next;

	for (; !ended; s = next) {
		struct chunk *c = s->chunk;
		const struct piece *p = &s->piece;

		c->name = name;
		c->first = first;
		c->header = header;
		ended = fill(j, name, fd, s);
		c->text = p->text;
		c->end = p->text + (ended ? p->have : p->whole);
		c->bytes = (size_t)(c->end - c->text);
		wait_for(ring.n - 2); /* until the next slot is free */
		next = slot_of(ring.filled + 1, p, c->end);
		hand_over(j, c);
		header = header && c->header;
		first = false;
	}
	wait_for(0);
}

void stream_text(struct job *j, const char *name, const char *text, size_t size)
{
	struct chunk *c = chunk_new();

	answer_source();
	c->name = name;
	c->first = true;
	c->text = text;
	c->end = text + size;
	job_do(j, c);
	answer_chunk(j, c);
	chunk_free(c);
}
