#include "piece.h"

#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../talk.h"

/* Large enough that handing over costs nothing, small enough for caches. */
enum { PIECE_ROOM = 1 << 17 };

/* No line of points is longer than this. */
#define LINE_MAX_BYTES ((size_t)1 << 26)

void piece_reserve(struct piece *p, size_t room)
{
	char *old = p->text != NULL ? p->text - PIECE_MARGIN : NULL;
	char *all = need(old, PIECE_MARGIN + room + PIECE_MARGIN);

	if (old == NULL)
		memset(all, ' ', PIECE_MARGIN);
	p->text = all + PIECE_MARGIN;
	p->room = room;
	memset(p->text + room, ' ', PIECE_MARGIN);
}

void piece_free(struct piece *p)
{
	if (p->text != NULL)
		free(p->text - PIECE_MARGIN);
}

void piece_begin(struct piece *p, const struct piece *before, const char *end)
{
	size_t rest = before == NULL ?
	    0 :
	    (size_t)(before->text + before->have - end);

	if (p->room < rest || p->room == 0)
		piece_reserve(p, rest > PIECE_ROOM ? before->room : PIECE_ROOM);
	if (rest > 0)
		memcpy(p->text, end, rest);
	p->have = rest;
	p->whole = 0;
}

/* Whether a read would wait; true, too, where that can't be told. */
static bool would_wait(int fd)
{
	struct pollfd p = { .fd = fd, .events = POLLIN };

	return poll(&p, 1, 0) <= 0;
}

/* Counts in n more bytes. Only those are searched for a newline: to search all
 * of a long line for every few bytes that come would take quadratic time. */
static void take_in(struct piece *p, const struct layout *l, size_t n)
{
	size_t end = p->have + n;

	if (is_binary(l->in)) {
		p->have = end;
		p->whole = end - end % point_size(l->in, l->reads);
		return;
	}
	while (end > p->have && p->text[end - 1] != '\n')
		end--;
	if (end > p->have)
		p->whole = end;
	p->have += n;
}

enum piece_state piece_fill(struct piece *p, const struct layout *l, int fd)
{
	do {
		if (p->have == p->room) {
			if (p->whole > 0)
				return PIECE_FULL;
			if (p->room >= LINE_MAX_BYTES)
				return PIECE_TOO_LONG;
			piece_reserve(p, 2 * p->room);
		}
		ssize_t n;

		do
			n = read(fd, p->text + p->have, p->room - p->have);
		while (n < 0 && go_on(fd, POLLIN));
		if (n < 0)
			return PIECE_FAILED;
		if (n == 0)
			return PIECE_LAST;
		take_in(p, l, (size_t)n);
	} while (p->whole == 0 || !would_wait(fd));
	return PIECE_FULL;
}
