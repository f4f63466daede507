#include "chunk.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../talk.h"

/* As need() does, where columns want to be. */
static void *need_aligned(size_t size)
{
	void *p = aligned_alloc(_Alignof(struct chunk), size);

	if (p == NULL)
		die(EXIT_SYSTEM, "out of memory");
	return p;
}

struct chunk *chunk_new(void)
{
	struct chunk *c = need_aligned(sizeof *c);

	memset(c, 0, sizeof *c);
	return c;
}

void chunk_free(struct chunk *c)
{
	piece_free(&c->piece);
	free(c->out);
	free(c->complaints);
	free(c);
}

void chunk_clear(struct chunk *c)
{
	c->n_lines = c->size = c->n_complaints = c->n_passed = 0;
	c->imageless = 0;
	c->stretch.at = c->stretch.end = 0;
	c->stretch.readable = c->text;
}

char *chunk_reserve(struct chunk *c, size_t more)
{
	if (c->size + more > c->room) {
		c->room = c->room / 2 * 3 + more;
		c->out = need(c->out, c->room);
	}
	return c->out + c->size;
}

void chunk_complain(struct chunk *c, size_t line, const char *reason)
{
	size_t n = c->n_complaints++;

	/* grown at powers of two */
	if ((n & (n - 1)) == 0)
		c->complaints = need(c->complaints,
		    (2 * n + 1) * sizeof *c->complaints);
	c->complaints[n].line = line;
	snprintf(c->complaints[n].reason, REASON_MAX, "%s", reason);
}

static bool was_refused(struct chunk *c, size_t line)
{
	while (c->n_passed < c->n_complaints &&
	    c->complaints[c->n_passed].line < line)
		c->n_passed++;
	return c->n_passed < c->n_complaints &&
	    c->complaints[c->n_passed].line == line;
}

void chunk_mark(struct chunk *c, const struct layout *l, size_t p, size_t line)
{
	bool nan = false, narrow = l->out == FORMAT_F32;

	for (int k = 0; k < l->writes; k++) {
		double v = c->image[k][p];

		/* what is midway from the largest float to 2^128 may have
		 * been rounded there */
		if (!isfinite(v) || (narrow && fabs(v) > 0x1.ffffffp127)) {
			c->image[k][p] = (double)NAN;
			nan = true;
		}
	}
	if (nan && !was_refused(c, line) && c->imageless++ == 0)
		c->first_imageless = line;
}
