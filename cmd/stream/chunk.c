/* SPDX-License-Identifier: MIT */
#include "chunk.h"

#include <stdlib.h>

#include "job.h"

struct chunk *chunk_new(void)
{
	/* cleared, as vector loops read beyond the last point */
	const size_t alignment = _Alignof(struct chunk);
	char *memory = calloc(1, sizeof(struct chunk) + alignment);

	if (memory == NULL)
		die(EXIT_SYSTEM, "out of memory", NULL);
	struct chunk *c = (void *)(memory + alignment - (uintptr_t)memory % alignment);

	piece_resize(&c->piece, PIECE_ROOM);
	/* most output fits: to allocate more costs a thread an arena */
	c->room = 16 * PIECE_ROOM;
	c->out = xrealloc(NULL, c->room);
	/* cppcheck-suppress memleak; c keeps the allocated bytes */
	return c;
}

char *chunk_reserve(struct chunk *c, size_t n)
{
	if (c->size + n > c->room) {
		c->room = c->room / 2 + c->size + n;
		c->out = xrealloc(c->out, c->room);
	}
	return c->out + c->size;
}

bool chunk_complain(const struct job *j, struct chunk *c, const struct refusal *r)
{
	bool goes_on = j->keep_going && !c->refused;
	struct refusal *to =
	    &c->complaint[c->n_complaints < COMPLAINTS_MAX ? c->n_complaints :
							     COMPLAINTS_MAX];

	*to = *r;
	to->line = (long long)(c->n_lines + c->block_lines);
	if (c->is_list && c->piece.place[to->line].joined)
		to->column = c->piece.place[to->line].column;
	else if (c->is_list)
		to->column += c->piece.place[to->line].column - 1;
	c->n_complaints++;
	if (!goes_on)
		c->text = c->end;
	return goes_on;
}

long long chunk_line(const struct chunk *c, size_t line)
{
	return c->is_list ? c->piece.place[line].line : c->place.line + (long long)line;
}
