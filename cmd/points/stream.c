/* for F_SETPIPE_SZ, where there is one */
#define _GNU_SOURCE
#include "stream.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <string.h>
#include <sys/stat.h>

#include "answer.h"
#include "chunk_do.h"
#include "piece.h"
#include "progress.h"
#include "../talk.h"

/* A chunk, and the text that it is of. */
struct slot {
	struct chunk *chunk;
	struct piece piece;
};

/* The k-th chunk of all sources goes through slot k % n: the reader, which is
 * the thread that calls stream_file, fills it, a thread does the job on it, and
 * the same thread answers, when those before are answered: so that no answer
 * waits for the reader. Each has the slot to itself until it counts the chunk
 * as filled, or answered. */
static struct {
	/* Of these only the reader knows, */
	int threads; /* running */
	/* these it sets before the first thread starts, and changes what is in
	 * the job only while no chunk is on its way, */
	struct job *job;
	struct slot *slots;
	size_t n;
	/* and these counts of chunks change under the lock: filled by the
	 * reader, who may read it without, the others by whoever is so far. */
	pthread_mutex_t lock;
	size_t filled, taken, answered;
	pthread_cond_t is_filled, is_answered; /* one more */
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
		chunk_do(ring.job, c);
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

/* The k-th chunk's slot, which must be free, with the bytes that are read but
 * not of the piece before. */
static struct slot *slot_of(size_t k, const struct piece *before,
    const char *end)
{
	struct slot *s = &ring.slots[k % ring.n];

	if (s->chunk == NULL)
		s->chunk = chunk_new();
	piece_begin(&s->piece, before, end);
	return s;
}

/* Fills the slot. Returns whether the source ends with it; results come before
 * what is wrong with the source. */
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

/* The first chunk of a source is done here, as it may be all there is, and all
 * are up to the header, from which the others have their columns. */
static void hand_over(struct job *j, struct chunk *c)
{
	bool here = c->first || c->header || j->threads < 2;

	if (!here)
		start_threads(j);
	here |= ring.threads == 0;
	if (here) {
		chunk_do(j, c);
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
		wait_for(ring.n - 2); /* for the next slot */
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
	chunk_do(j, c);
	answer_chunk(j, c);
	chunk_free(c);
}
