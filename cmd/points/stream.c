/* for F_SETPIPE_SZ, where there is one */
#define _GNU_SOURCE
#include "stream.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "progress.h"
#include "../talk.h"

/* Large enough that handing over costs nothing, small enough for caches. */
enum { CHUNK_TEXT = 1 << 17, THREADS_MAX = 256 };

/* One longer line than this is no line of points. */
#define LINE_MAX_BYTES ((size_t)1 << 26)

/* A chunk with text of its own. */
struct slot {
	struct chunk *chunk;
	char *text;
	size_t room, have;
	size_t whole; /* up to where its last whole line or point ends */
};

/* Slots are filled, done and written in turn: slot k % n is the k-th chunk's.
 * The reader fills, threads do, whoever has done the next one writes it, so
 * that no answer waits for the reader. */
static struct {
	pthread_mutex_t lock;
	pthread_cond_t filled, written;
	struct slot *slots;
	size_t n;
	size_t fill, take, write; /* counts of chunks */
	struct job *job;
	int threads; /* running */
} ring = {
	.lock = PTHREAD_MUTEX_INITIALIZER,
	.filled = PTHREAD_COND_INITIALIZER,
	.written = PTHREAD_COND_INITIALIZER,
};

/* Told at the end. */
static size_t imageless;
static char first_imageless[300];
static bool bad;

/* Where the next chunk of the source begins, counted from 1. */
static size_t next_line;

/* Results first, then what was wrong with the line after them. Chunks come
 * here in order, and their lines are counted on. */
static void finish(const struct job *j, const struct chunk *c)
{
	static bool unended; /* a last line without its newline */

	if (c->size > 0 && j->collect == NULL) {
		if (unended)
			put_all("\n", 1);
		unended = !is_binary(j->layout.out) &&
		    c->out[c->size - 1] != '\n';
	}
	if (j->collect != NULL)
		j->collect(j, c, next_line);
	else
		put_all(c->out, c->size);
	if (j->count_imageless && c->imageless > 0) {
		if (imageless == 0)
			snprintf(first_imageless, sizeof first_imageless,
			    "%.250s:%zu", c->name,
			    next_line + c->first_imageless);
		imageless += c->imageless;
	}
	bool stop = c->n_complaints > 0 && !j->keep_going;

	if (stop && j->flush != NULL)
		j->flush(j);
	if (c->n_complaints > 0)
		progress_clear();
	for (size_t i = 0; i < c->n_complaints; i++)
		say("%s:%zu: %s", c->name, next_line + c->complaints[i].line,
		    c->complaints[i].reason);
	bad |= c->n_complaints > 0;
	if (stop) {
		close_output();
		quit(EXIT_INPUT);
	}
	next_line += c->lines;
	progress_add(c->lines, c->bytes);
}

static void *work(void *unused)
{
	pthread_mutex_lock(&ring.lock);
	for (;;) {
		while (ring.take == ring.fill)
			pthread_cond_wait(&ring.filled, &ring.lock);
		size_t k = ring.take++;
		struct chunk *c = ring.slots[k % ring.n].chunk;

		pthread_mutex_unlock(&ring.lock);
		chunk_do(ring.job, c);
		pthread_mutex_lock(&ring.lock);
		while (ring.write != k)
			pthread_cond_wait(&ring.written, &ring.lock);
		pthread_mutex_unlock(&ring.lock);
		finish(ring.job, c);
		pthread_mutex_lock(&ring.lock);
		ring.write++;
		pthread_cond_broadcast(&ring.written);
	}
	return unused;
}

/* Waits until at most n chunks are on their way. */
static void wait_for(size_t n)
{
	pthread_mutex_lock(&ring.lock);
	while (ring.fill - ring.write > n)
		pthread_cond_wait(&ring.written, &ring.lock);
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

static struct slot *slot_of(size_t k)
{
	struct slot *s = &ring.slots[k % ring.n];

	if (s->chunk == NULL) {
		s->chunk = chunk_new();
		s->room = CHUNK_TEXT;
		s->text = need(NULL, s->room);
	}
	return s;
}

/* Results come before what is wrong with the source. */
static void settle(const struct job *j)
{
	wait_for(0);
	if (j->flush != NULL)
		j->flush(j);
}

static size_t read_some(const struct job *j, const char *name, int fd, char *at,
    size_t room)
{
	ssize_t n;

	do
		n = read(fd, at, room);
	while (n < 0 && go_on(fd, POLLIN));
	if (n < 0) {
		int error = errno;

		settle(j);
		die(EXIT_SYSTEM, "%s: %s", name, strerror(error));
	}
	return (size_t)n;
}

/* Whether a read would wait, or that can't be told. */
static bool would_wait(int fd)
{
	struct pollfd p = { .fd = fd, .events = POLLIN };

	return poll(&p, 1, 0) <= 0;
}

/* Takes in n more bytes. Only those are searched, or a long line that comes
 * in small pieces would take the square of its time. */
static void take_in(const struct job *j, struct slot *s, size_t n)
{
	size_t end = s->have + n;

	if (is_binary(j->layout.in)) {
		s->have = end;
		s->whole = end - end % point_size(&j->layout, j->layout.in);
		return;
	}
	while (end > s->have && s->text[end - 1] != '\n')
		end--;
	if (end > s->have)
		s->whole = end;
	s->have += n;
}

/* Fills the slot until it holds a whole line and is full, or the next read
 * would wait, or the source ends, which it returns. */
static bool fill(const struct job *j, const char *name, int fd, struct slot *s)
{
	for (;;) {
		if (s->have == s->room) {
			if (s->whole > 0)
				return false;
			if (s->room >= LINE_MAX_BYTES) {
				settle(j);
				die(EXIT_INPUT,
				    "%s:%zu: a line of more than "
				    "64 MiB",
				    name, next_line);
			}
			s->text = need(s->text, s->room *= 2);
		}
		size_t n = read_some(j, name, fd, s->text + s->have,
		    s->room - s->have);

		if (n == 0)
			return true;
		take_in(j, s, n);
		if (s->whole > 0 && would_wait(fd))
			return false;
	}
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
		finish(j, c);
	}
	pthread_mutex_lock(&ring.lock);
	ring.fill++;
	if (here) {
		ring.take++;
		ring.write++;
	} else {
		pthread_cond_signal(&ring.filled);
	}
	pthread_mutex_unlock(&ring.lock);
}

/* The slot after s, free, with what s holds behind end. */
static struct slot *next_slot(const struct slot *s, const char *end)
{
	size_t rest = (size_t)(s->text + s->have - end);

	wait_for(ring.n - 2);
	struct slot *next = slot_of(ring.fill + 1);

	if (next->room < rest) {
		next->room = s->room;
		next->text = need(next->text, next->room);
	}
	memcpy(next->text, end, rest);
	next->have = rest;
	next->whole = 0;
	return next;
}

void stream_file(struct job *j, const char *name, int fd)
{
	bool ended = false, first = true;
	bool header = j->layout.in == FORMAT_CSV;

#ifdef F_SETPIPE_SZ
	/* fewer and larger reads; where it is refused, all is as it was */
	fcntl(fd, F_SETPIPE_SZ, 1 << 20);
#endif
	struct stat st;

	progress_source(fstat(fd, &st) == 0 && S_ISREG(st.st_mode) ?
		(size_t)st.st_size :
		0);
	make_ring(j);
	struct slot *s = slot_of(ring.fill), *next;

	next_line = 1;
	s->have = s->whole = 0;
	for (; !ended; s = next) {
		struct chunk *c = s->chunk;

		c->name = name;
		c->first = first;
		c->header = header;
		ended = fill(j, name, fd, s);
		c->text = s->text;
		c->end = s->text + (ended ? s->have : s->whole);
		c->bytes = (size_t)(c->end - c->text);
		next = next_slot(s, c->end);
		hand_over(j, c);
		header = header && c->header;
		first = false;
	}
	wait_for(0);
}

void stream_text(struct job *j, const char *name, const char *text, size_t size)
{
	struct chunk *c = chunk_new();

	next_line = 1;
	c->name = name;
	c->first = true;
	c->text = text;
	c->end = text + size;
	chunk_do(j, c);
	finish(j, c);
	chunk_free(c);
}

int stream_end(const struct job *j)
{
	progress_end();
	if (j->flush != NULL)
		j->flush(j);
	if (imageless == 1)
		say("1 point has no image: %s", first_imageless);
	else if (imageless > 1)
		say("%zu points have no image, the first in %s", imageless,
		    first_imageless);
	close_output();
	return bad ? EXIT_INPUT : EXIT_OK;
}
