/* SPDX-License-Identifier: MIT */
#include "chunk.h"

#include <stdlib.h>
#include <string.h>

#include "../message/message.h"

struct chunk *chunk_new(void)
{
	void *c;

	/* columns want to be aligned */
	if (posix_memalign(&c, _Alignof(struct chunk), sizeof(struct chunk)) !=
	    0)
		die(EXIT_SYSTEM, "out of memory");
	return memset(c, 0, sizeof(struct chunk));
}

void chunk_free(struct chunk *c)
{
	free(c->piece.text);
	free(c->out);
	free(c->complaints);
	free(c->reasons);
	free(c);
}

/* More than the output of most pieces takes, and than what is wrong with a piece of
 * which every line is bad. */
enum { KEPT_ROOM = 1 << 21 };

static void *keep_small(void *p, size_t *room, size_t size)
{
	if (*room * size <= KEPT_ROOM)
		return p;
	free(p);
	*room = 0;
	return NULL;
}

void chunk_clear(struct chunk *c)
{
	c->n_lines = c->size = c->n_complaints = 0;
	c->imageless = c->reasons_size = 0;
	c->refused = false;
	c->out = keep_small(c->out, &c->room, 1);
	c->reasons = keep_small(c->reasons, &c->reasons_room, 1);
	c->complaints = keep_small(c->complaints, &c->complaints_room,
	    sizeof *c->complaints);
	c->stretch.at = c->stretch.end = 0;
	c->stretch.readable = c->text;
}

/* Makes room for so many things of a size, half as many again than there was. */
static void *grow(void *p, size_t *room, size_t wanted, size_t size)
{
	if (wanted <= *room)
		return p;
	*room = *room / 2 + wanted;
	return need(p, *room * size);
}

char *chunk_reserve(struct chunk *c, size_t more)
{
	c->out = grow(c->out, &c->room, c->size + more, 1);
	return c->out + c->size;
}

void chunk_complain(struct chunk *c, size_t line, const char *reason)
{
	size_t n = c->n_complaints++, size = strlen(reason) + 1;
	size_t at = n > 0 ? c->complaints[n - 1].reason : 0;

	c->complaints = grow(c->complaints, &c->complaints_room, n + 1,
	    sizeof *c->complaints);
	/* most often it is what is wrong with the line before, too */
	if (n == 0 || strcmp(c->reasons + at, reason) != 0) {
		at = c->reasons_size;
		c->reasons_size += size;
		c->reasons = grow(c->reasons, &c->reasons_room, c->reasons_size,
		    1);
		memcpy(c->reasons + at, reason, size);
	}
	c->complaints[n] = (struct complaint){ line, at };
}
