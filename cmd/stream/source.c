/* SPDX-License-Identifier: MIT */
#include "source.h"

#include <errno.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../message/message.h"

struct point_source source_of_file(const char *name, int fd)
{
	struct point_source s = { .name = name, .fd = fd };
	struct stat st;

	widen_pipe(fd, PIPE_ROOM);
	s.start = lseek(fd, 0, SEEK_CUR);
	/* Of a file that has no more than a piece, no thread but one would have
	 * something to read; among them are those that the system makes up, with
	 * a size of 0. */
	if (s.start >= 0 && fstat(fd, &st) == 0 && S_ISREG(st.st_mode) &&
	    st.st_size - s.start > PIECE_ROOM)
		s.kind = SOURCE_FILE;
	return s;
}

struct point_source source_of_text(const char *name, const char *text,
    size_t size)
{
	return (struct point_source){ .name = name,
		.kind = SOURCE_TEXT,
		.text = text,
		.end = text + size };
}

static void take_piece(struct chunk *c, enum piece_state state)
{
	c->state = state;
	c->error = errno;
	c->text = c->piece.text + c->piece.begin;
	c->end = c->piece.text + c->piece.whole;
}

void source_begin(struct point_source *s, const struct layout *l,
    struct chunk *c)
{
	c->name = s->name;
	c->state = PIECE_FULL; /* until it is read */
	if (s->kind == SOURCE_STREAM)
		take_piece(c, piece_fill(&c->piece, l, s->fd, &s->rest));
	if (s->kind != SOURCE_TEXT)
		return;
	size_t size = (size_t)(s->end - s->text);

	c->text = s->text;
	c->state = piece_of_text(l, s->text, &size);
	c->end = s->text += size;
}

void source_read(const struct point_source *s, const struct layout *l,
    struct chunk *c)
{
	if (s->kind == SOURCE_FILE)
		take_piece(c,
		    piece_cut(&c->piece, l, s->fd, s->start, c->number));
	c->bytes = (size_t)(c->end - c->text);
}

void source_end(struct point_source *s, const struct chunk *last)
{
	const struct piece *p = &last->piece;

	if (s->kind == SOURCE_FILE)
		lseek(s->fd, p->at + (off_t)p->have, SEEK_SET);
	piece_free(&s->rest);
}
