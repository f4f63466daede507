/* SPDX-License-Identifier: MIT */
#include "source.h"

#include <errno.h>
#include <poll.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../lines/layout.h"
#include "../message/message.h"

/* The most bytes that a line of points may have, with its newline. */
#define LINE_MAX_BYTES ((size_t)1 << 26)

/* The first pieces of a source have PIECE_FIRST bytes, so that a short source uses
 * little fresh memory. A later one has 1 / PIECE_SHARE of the bytes before it, up to
 * PIECE_ROOM: the last pieces are small, and all threads end at about the same time. */
enum { PIECE_FIRST = 1 << 15, PIECE_SHARE = 64 };

void piece_resize(struct piece *p, size_t room)
{
	p->text = xrealloc(p->text, room + PIECE_MARGIN);
	p->room = room;
}

/* Begins p with the rest of the last piece, maybe p itself. Returns its full size. */
static size_t begin_piece(struct piece *p, const struct point_source *s)
{
	size_t n = (size_t)(s->rest.end - s->rest.s), full = PIECE_FIRST;

	while (full < n || (full < PIECE_ROOM && full * PIECE_SHARE < s->bytes_read))
		full *= 2;
	size_t room = full > PIECE_ROOM ? full : PIECE_ROOM;

	if (p->room < room)
		piece_resize(p, room);
	if (n > 0)
		memmove(p->text, s->rest.s, n);
	if (p->room > room)
		piece_resize(p, room);
	p->size = n;
	p->whole_size = 0;
	return full;
}

/* Reads up to `room` bytes. Returns, as read(2), their number, 0 at the end, or -1. */
static ssize_t read_some(struct point_source *s, char *to, size_t room)
{
	size_t left = (size_t)(s->text.end - s->text.s);
	ssize_t n;

	if (s->text.s != NULL) {
		room = left < room ? left : room;
		memcpy(to, s->text.s, room);
		s->text.s += room;
		return (ssize_t)room;
	}
	do
		n = read(s->fd, to, room);
	while (n < 0 && io_retry(s->fd, POLLIN));
	return n;
}

/* Returns whether a read would wait, or true if poll fails. */
static bool would_wait(const struct point_source *s)
{
	struct pollfd p = { .fd = s->fd, .events = POLLIN };

	return s->text.s == NULL &&
	    (poll(&p, 1, 0) <= 0 || (p.revents & POLLNVAL) != 0);
}

/* Searches only the n new bytes for a newline, as a line may take many reads. */
static void update_sizes(struct piece *p, const struct layout *l, size_t n)
{
	size_t end = p->size + n, whole = end;

	if (format_is_binary(l->in.format))
		whole -= end % layout_record_size(l);
	else
		while (whole > p->size && p->text[whole - 1] != '\n')
			whole--;
	if (whole > p->size)
		p->whole_size = whole;
	p->size = end;
}

/* Returns whether a source of the bytes of p may go on as a .npy file, whose first
 * NPY_HEADER bytes tell its header's size. A newline can be one of them; the beginnings
 * of other foreign formats end before or with the first newline. */
static bool may_be_npy(const struct piece *p)
{
	return p->size < NPY_HEADER &&
	    memcmp(p->text, NPY_MAGIC, p->size < 6 ? p->size : 6) == 0;
}

/* Reads until the source ends, or p has a whole line and is full or would wait. */
static enum piece_state fill_piece(struct point_source *s, const struct layout *l,
    struct piece *p)
{
	size_t full = begin_piece(p, s);

	while (p->whole_size == 0 || p->size < full) {
		if (p->size == full)
			full *= 2;
		if (full > LINE_MAX_BYTES)
			return PIECE_TOO_LONG;
		if (full > p->room)
			piece_resize(p, full);
		ssize_t n = read_some(s, p->text + p->size, full - p->size);

		if (n < 0)
			return PIECE_FAILED;
		if (n == 0) {
			p->whole_size = p->size;
			return PIECE_LAST;
		}
		update_sizes(p, l, (size_t)n);
		if (p->whole_size > 0 && p->size < full &&
		    !(s->bytes_read == 0 && may_be_npy(p)) && would_wait(s))
			return PIECE_EARLY;
	}
	return PIECE_FULL;
}

struct point_source source_of_file(const char *name, int fd)
{
	struct point_source s = { .name = name, .fd = fd };
	const off_t start = lseek(fd, 0, SEEK_CUR);
	struct stat st;

	pipe_enlarge(fd, PIPE_ROOM);
	if (start >= 0 && fstat(fd, &st) == 0 && S_ISREG(st.st_mode) &&
	    st.st_size > start)
		s.size = st.st_size - start;
	return s;
}

struct point_source source_of_text(const char *name, const char *text, size_t size)
{
	return (struct point_source){ .name = name,
		.text = { text, text + size },
		.size = (off_t)size };
}

void source_read(struct point_source *s, const struct layout *l, struct piece *p)
{
	p->state = fill_piece(s, l, p);
	p->error = errno;
	s->bytes_read += p->size;
	s->rest = (struct span){ p->text + p->whole_size, p->text + p->size };
}
