/* SPDX-License-Identifier: MIT */
#include "source.h"

#include <errno.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../message/message.h"
#include "../lines/line.h"

/* A piece of a file reads so much more than its range, to have the end of the
 * line that begins there, too. */
enum { LINE_REST = 1 << 12 };

/* No line of points is longer than this, with its newline. */
#define LINE_MAX_BYTES ((size_t)1 << 26)

/* Makes room for so many bytes of text; what was read stays. */
static void reserve_text(struct piece *p, size_t room)
{
	p->text = need(p->text, room + PIECE_MARGIN);
	p->room = room;
}

/* Begins p anew, with what q has behind what is whole. */
static void begin_text(struct piece *p, const struct piece *q)
{
	size_t rest = q->have - q->whole;
	size_t room = PIECE_ROOM;

	while (room < rest)
		room *= 2;
	/* it may have more from a long line */
	if (p->room != room)
		reserve_text(p, room);
	if (rest > 0)
		memcpy(p->text, q->text + q->whole, rest);
	p->have = rest;
	p->begin = p->whole = 0;
}

/* Whether a read would wait; true, too, where that can't be told. */
static bool would_wait(int fd)
{
	struct pollfd p = { .fd = fd, .events = POLLIN };

	return poll(&p, 1, 0) <= 0 || (p.revents & POLLNVAL) != 0;
}

/* Past the last newline of s[from..to); 0 where there is none. */
static size_t last_line_end(const char *s, size_t from, size_t to)
{
	while (to > from && s[to - 1] != '\n')
		to--;
	return to > from ? to : 0;
}

/* Counts in n more bytes. Only those are searched for a newline: to search all
 * of a long line for every few bytes that come would take quadratic time. */
static void take_in(struct piece *p, const struct layout *l, size_t n)
{
	size_t end = p->have + n, whole;

	if (is_binary(l->in.format))
		whole = end - end % layout_record(l);
	else
		whole = last_line_end(p->text, p->have, end);
	if (whole > 0)
		p->whole = whole;
	p->have = end;
}

/* Reads until the source ends; or until there is a whole line or point and either the
 * piece is full or the next read would wait. */
static enum piece_state fill(struct piece *p, const struct layout *l, int fd)
{
	do {
		if (p->have == p->room && p->room >= LINE_MAX_BYTES)
			return PIECE_TOO_LONG;
		if (p->have == p->room)
			reserve_text(p, 2 * p->room);
		ssize_t n;

		do
			n = read(fd, p->text + p->have, p->room - p->have);
		while (n < 0 && go_on(fd, POLLIN));
		if (n < 0)
			return PIECE_FAILED;
		if (n == 0) {
			p->whole = p->have;
			return PIECE_LAST;
		}
		take_in(p, l, (size_t)n);
		if (p->whole > 0 && p->have < p->room && would_wait(fd))
			return PIECE_EARLY;
	} while (p->whole == 0 || p->have < p->room);
	return PIECE_FULL;
}

/* Reads on until the piece has no more room or the file ends. */
static enum piece_state read_on(struct piece *p, int fd)
{
	while (p->have < p->room) {
		ssize_t n = pread(fd, p->text + p->have, p->room - p->have,
		    p->at + (off_t)p->have);

		if (n < 0 && go_on(fd, POLLIN))
			continue;
		if (n < 0)
			return PIECE_FAILED;
		if (n == 0)
			return PIECE_LAST;
		p->have += (size_t)n;
	}
	return PIECE_FULL;
}

/* Past the first newline of s[from..to); 0 where there is none. */
static size_t first_line_end(const char *s, size_t from, size_t to)
{
	const char *newline = from < to ? memchr(s + from, '\n', to - from) :
					  NULL;

	return newline != NULL ? (size_t)(newline - s) + 1 : 0;
}

/* Reads the lines that begin in a range; before is 1 if the piece begins a byte
 * earlier, as a line begins where there is a newline before. */
static enum piece_state cut_lines(struct piece *p, int fd, size_t before,
    size_t range)
{
	enum piece_state state = read_on(p, fd);
	size_t last = before + range - 1, line;

	if (before > 0)
		p->begin = first_line_end(p->text, 0,
		    p->have < range ? p->have : range);
	/* All of it is of a line that began earlier; what is behind the range may
	 * end that and begin others. */
	if (p->begin < before)
		return state == PIECE_LAST && p->have > range ? PIECE_FULL :
								state;
	line = last_line_end(p->text, p->begin,
	    p->have < last ? p->have : last);
	if (line < p->begin)
		line = p->begin;
	for (size_t seen = last;; seen = p->have, state = read_on(p, fd)) {
		size_t end = first_line_end(p->text, seen, p->have);
		size_t stop = end > 0 ? end : p->have;

		p->whole = line;
		/* without its newline it would be longer by one at least */
		if (stop - line + (end == 0) > LINE_MAX_BYTES)
			return PIECE_TOO_LONG;
		if (end == 0 && state == PIECE_FAILED)
			return state;
		if (end > 0 || state == PIECE_LAST) {
			p->whole = stop;
			return end > 0 ? PIECE_FULL : state;
		}
		reserve_text(p, 2 * p->room);
	}
}

/* Reads the lines or points that begin in the k-th of ranges of equal size of a file
 * whose points begin at start. */
static enum piece_state cut_file(struct piece *p, const struct layout *l,
    int fd, off_t start, size_t k)
{
	bool binary = is_binary(l->in.format);
	size_t before = k > 0 && !binary;
	size_t range = PIECE_ROOM - LINE_REST;
	size_t point = binary ? layout_record(l) : 1;

	range -= range % point;
	reserve_text(p, binary ? range : PIECE_ROOM);
	p->at = start + (off_t)k * (off_t)range - (off_t)before;
	p->have = p->begin = p->whole = 0;
	if (!binary)
		return cut_lines(p, fd, before, range);
	enum piece_state state = read_on(p, fd);

	/* a point that the file's end cuts is told of, but not one that a failed
	 * read does */
	p->whole = state == PIECE_FAILED ? p->have - p->have % point : p->have;
	return state;
}

/* Cuts *size, of a text in memory, to the piece that it begins with. */
static enum piece_state cut_text(const struct layout *l, const char *text,
    size_t *size)
{
	size_t all = *size, end = 0, line = 0;

	if (all > PIECE_ROOM && is_binary(l->in.format)) {
		*size = PIECE_ROOM - PIECE_ROOM % layout_record(l);
		return PIECE_FULL;
	}
	if (all > PIECE_ROOM) {
		line = last_line_end(text, 0, PIECE_ROOM - 1);
		end = first_line_end(text, PIECE_ROOM - 1, all);
	}
	*size = end > 0 ? end : all;
	if (*size - line + (end == 0) > LINE_MAX_BYTES) {
		*size = line;
		return PIECE_TOO_LONG;
	}
	return *size < all ? PIECE_FULL : PIECE_LAST;
}

struct point_source source_of_file(const char *name, int fd)
{
	struct point_source s = { .name = name, .fd = fd };
	struct stat st;

	widen_pipe(fd, PIPE_ROOM);
	s.start = lseek(fd, 0, SEEK_CUR);
	if (s.start >= 0 && fstat(fd, &st) == 0 && S_ISREG(st.st_mode) &&
	    st.st_size > s.start)
		s.size = st.st_size - s.start;
	/* Of a file that has no more than a piece, no thread but one would have
	 * something to read; among them are those that the system makes up, with
	 * a size of 0. */
	if (s.size > PIECE_ROOM)
		s.kind = SOURCE_FILE;
	return s;
}

static void take_text(struct piece *p, enum piece_state state)
{
	p->state = state;
	p->error = errno;
	p->got = (struct span){ p->text + p->begin, p->text + p->whole };
}

void source_begin(struct point_source *s, const struct layout *l,
    struct piece *p)
{
	p->state = PIECE_FULL; /* until it is read */
	if (s->kind == SOURCE_STREAM) {
		begin_text(p, &s->rest);
		take_text(p, fill(p, l, s->fd));
		if (p->state < PIECE_LAST)
			begin_text(&s->rest, p);
	}
	if (s->kind == SOURCE_TEXT) {
		size_t size = (size_t)(s->end - s->text);

		p->state = cut_text(l, s->text, &size);
		p->got = (struct span){ s->text, s->text + size };
		s->text += size;
	}
}

void source_read(const struct point_source *s, const struct layout *l,
    struct piece *p, size_t k)
{
	if (s->kind == SOURCE_FILE)
		take_text(p, cut_file(p, l, s->fd, s->start, k));
}

void source_end(struct point_source *s, const struct piece *last)
{
	if (s->kind == SOURCE_FILE)
		lseek(s->fd, last->at + (off_t)last->have, SEEK_SET);
	free(s->rest.text);
}
