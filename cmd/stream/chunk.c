/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../message/message.h"
#include "job.h"

struct chunk *chunk_new(void)
{
	void *c;

	/* columns want to be aligned */
	if (posix_memalign(&c, _Alignof(struct chunk), sizeof(struct chunk)) !=
	    0)
		die(EXIT_SYSTEM, "out of memory");
	return memset(c, 0, sizeof(struct chunk));
}

char *chunk_reserve(struct chunk *c, size_t more)
{
	if (c->size + more > c->room) {
		c->room = c->room / 2 + c->size + more;
		c->out = xrealloc(c->out, c->room);
	}
	return c->out + c->size;
}

bool chunk_complain(const struct job *j, struct chunk *c, size_t line,
    const char *reason)
{
	bool goes_on = j->keep_going && !c->refused;

	if (c->n_complaints < TOLD) {
		struct complaint *to = &c->complaint[c->n_complaints];

		to->line = line;
		snprintf(to->reason, sizeof to->reason, "%s", reason);
	}
	c->n_complaints++;
	if (!goes_on)
		c->text = c->end;
	return goes_on;
}
