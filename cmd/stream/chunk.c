/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../message/message.h"
#include "job.h"

struct chunk *chunk_new(void)
{
	struct chunk *c = aligned_alloc(_Alignof(struct chunk), sizeof *c);

	if (c == NULL)
		die(EXIT_SYSTEM, "out of memory");
	memset(c, 0, offsetof(struct chunk, stretch));
	piece_resize(&c->piece, PIECE_ROOM);
	/* enough for most output, so that a new thread need not allocate,
	 * for which the C library would first map an arena */
	c->room = 4 * PIECE_ROOM;
	c->out = xrealloc(NULL, c->room);
	return c;
}

char *chunk_reserve(struct chunk *c, size_t more)
{
	if (c->size + more > c->room) {
		c->room = c->room / 2 + c->size + more;
		c->out = xrealloc(c->out, c->room);
	}
	return c->out + c->size;
}

bool chunk_complain(const struct job *j, struct chunk *c, const char *reason)
{
	bool goes_on = j->keep_going && !c->refused;

	if (c->n_complaints < COMPLAINTS_MAX) {
		struct complaint *to = &c->complaint[c->n_complaints];

		to->line = c->n_lines + c->block_lines;
		snprintf(to->reason, sizeof to->reason, "%s", reason);
	}
	c->n_complaints++;
	if (!goes_on)
		c->text = c->end;
	return goes_on;
}

/* Returns the name of a set of planes: "in", or such as "left+near". */
static struct word make_word(unsigned outside)
{
	static const struct word names[] = { { "left", 4 }, { "right", 5 },
		{ "bottom", 6 }, { "top", 3 }, { "near", 4 }, { "far", 3 },
		{ "behind", 6 }, { "nan", 3 } };
	struct word w = { "in", 2 };

	for (int k = 0; k < 8; k++) {
		if ((outside >> k & 1) == 0)
			continue;
		if (outside & ((1u << k) - 1))
			w.s[w.size++] = '+';
		else
			w.size = 0;
		memcpy(w.s + w.size, names[k].s, names[k].size);
		w.size += names[k].size;
	}
	return w;
}

const struct word *chunk_word(struct chunk *c, unsigned outside)
{
	struct word *w = &c->word[outside];

	if (w->size == 0)
		*w = make_word(outside);
	return w;
}
