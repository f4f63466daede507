/* for F_SETPIPE_SZ, where there is one */
#define _GNU_SOURCE
#include "stream.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>

#include "../talk.h"
#include "answer.h"
#include "progress.h"
#include "threads.h"

/* Reads the chunk's piece; returns whether the source ends with it. What was
 * read before is answered before an error of the source ends the program. */
static bool fill(const struct job *j, struct chunk *c, int fd)
{
	enum piece_state state = piece_fill(&c->piece, &j->layout, fd);
	int error = errno;

	if (state == PIECE_FULL || state == PIECE_LAST)
		return state == PIECE_LAST;
	threads_wait();
	if (j->flush != NULL)
		j->flush(j);
	if (state == PIECE_TOO_LONG)
		die(EXIT_INPUT, "%s:%zu: a line of more than 64 MiB", c->name,
		    answer_line());
	die(EXIT_SYSTEM, "%s: %s", c->name, strerror(error));
}

/* The size of a file; 0 if fd is none. */
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
	struct chunk *c, *next;

#ifdef F_SETPIPE_SZ
	/* fewer and larger reads; if the system refuses, it is just slower */
	fcntl(fd, F_SETPIPE_SZ, 1 << 20);
#endif
	progress_source(size_of(fd));
	answer_source();
	c = threads_first(j);
	piece_begin(&c->piece, NULL, NULL);
	for (; !ended; c = next) {
		const struct piece *p = &c->piece;

		c->name = name;
		c->first = first;
		c->header = header;
		ended = fill(j, c, fd);
		c->text = p->text;
		c->end = p->text + (ended ? p->have : p->whole);
		c->bytes = (size_t)(c->end - c->text);
		/* takes over what is not whole yet, while p is still ours */
		next = threads_next();
		piece_begin(&next->piece, p, c->end);
		threads_hand_over(j, c);
		header = header && c->header;
		first = false;
	}
	threads_wait();
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
