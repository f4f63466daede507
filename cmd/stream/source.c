/* SPDX-License-Identifier: MIT */
#include "source.h"

#include <errno.h>
#include <poll.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../message/message.h"

/* The most bytes that a line of points may have, with its newline. */
#define LINE_MAX_BYTES ((size_t)1 << 26)

/* The first pieces of a source have PIECE_FIRST bytes, so that a short source uses
 * little fresh memory. A later one has 1 / PIECE_SHARE of the bytes before it, up to
 * PIECE_ROOM: the last pieces are small, and all threads end at about the same time. */
enum { PIECE_FIRST = 1 << 15, PIECE_SHARE = 64 };

void piece_resize(struct piece *p, size_t room)
{
	p->text = xrealloc(p->text, room + LINE_MARGIN);
	p->room = room;
}

/* Begins p with the rest of the last piece, maybe p itself. Returns its full size. */
static size_t begin_piece(struct piece *p, const struct point_source *s)
{
	size_t n = span_size(s->rest), full = PIECE_FIRST;

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

static ssize_t read_file(const struct point_source *s, char *to, size_t room)
{
	ssize_t n;

	do
		n = read(s->fd, to, room);
	while (n < 0 && io_retry(s->fd, POLLIN));
	return n;
}

/* Reads up to `room` bytes. Returns, as read(2), their number, 0 at the end, or -1. */
static ssize_t read_some(struct point_source *s, char *to, size_t room)
{
	struct span *memory = s->text.s != NULL ? &s->text : &s->head;
	const size_t left = span_size(*memory);

	if (left == 0 && s->text.s == NULL && !s->has_ended)
		return read_file(s, to, room);
	room = left < room ? left : room;
	if (room > 0)
		memcpy(to, memory->s, room);
	memory->s += room;
	return (ssize_t)room;
}

/* Returns whether a read would wait, or true if poll fails. */
static bool would_wait(const struct point_source *s)
{
	struct pollfd p = { .fd = s->fd, .events = POLLIN };

	return s->text.s == NULL && s->head.s == s->head.end && !s->has_ended &&
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
		if (p->whole_size > 0 && p->size < full && would_wait(s))
			return PIECE_EARLY;
	}
	return PIECE_FULL;
}

/* Makes room for n more bytes of a list, and for the places of its elements. */
static void list_reserve(struct piece *p, const struct list_lines *to, size_t n)
{
	if (to->size + n + LIST_MARGIN > p->room)
		piece_resize(p, 2 * (to->size + n + LIST_MARGIN));
	if (to->n + n / 2 + 1 > p->place_room) {
		p->place_room = 2 * (to->n + n);
		p->place = xrealloc(p->place, p->place_room * sizeof *p->place);
	}
}

/* Does what fill_piece does for a list. */
static enum piece_state fill_list(struct point_source *s, struct piece *p)
{
	enum { PART = 1 << 15 };
	static char part[PART]; /* one source at a time is read */
	const size_t full = begin_piece(p, s);
	struct list_lines to = { .size = p->size };
	enum piece_state state = PIECE_FULL;
	ssize_t n = 1;

	if (s->bytes_read == 0 && s->has_bom) {
		memcpy(p->text, "\xef\xbb\xbf", 3);
		to.size = to.whole_size = 3;
	}
	while (n > 0 && state == PIECE_FULL && (to.n == 0 || to.size < full)) {
		n = read_some(s, part, PART);
		if (n < 0) {
			state = PIECE_FAILED;
			break;
		}
		s->bytes_read += (size_t)n;
		list_reserve(p, &to, (size_t)n);
		to.text = p->text;
		to.place = p->place;
		if (!list_cut(&s->list, part, (size_t)n, &to, &p->fault))
			state = PIECE_BROKEN;
		else if (n == 0)
			state = PIECE_LAST;
		else if (to.size - to.whole_size > LINE_MAX_BYTES)
			state = PIECE_TOO_LONG;
		else if (to.n > 0 && would_wait(s))
			state = PIECE_EARLY;
	}
	p->size = to.size;
	p->whole_size = to.whole_size;
	return state;
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

/* Returns whether a file of these bytes may go on as .npy. */
static bool may_be_npy(const char *s, size_t n)
{
	return n < NPY_HEADER && memcmp(s, NPY_MAGIC, n < 6 ? n : 6) == 0;
}

/* Passes whole lines that are blank or comments. Returns the line behind them, up to
 * its newline or to what there is of it. */
static struct span find_first_line(const char *s, const char *end)
{
	for (;;) {
		const char *newline = memchr(s, '\n', (size_t)(end - s)), *at = s;
		const struct span line = { s, newline != NULL ? newline : end };

		while (at < line.end && is_blank(*at))
			at++;
		if (newline == NULL || (at < line.end && *at != '#'))
			return line;
		s = newline + 1;
	}
}

/* Returns whether the bytes tell all that source_begin is to know, as they do if they
 * are `all`; sets the plan. *passed is the size of the lines before the first that
 * tells the format, so far. */
static bool begin_plan(struct point_source *s, struct layout *l, struct span bytes,
    size_t *passed, bool all)
{
	const size_t n = span_size(bytes);
	const bool list_possible = l->in.format == FORMAT_JSON ||
	    l->in.format == FORMAT_SNIFF;
	bool known = true;

	if (!all && may_be_npy(bytes.s, n))
		return false;
	if (format_is_binary(l->in.format))
		return all || n >= layout_record_size(l);
	if (!list_possible)
		return all || memchr(bytes.s, '\n', n) != NULL;
	if (*passed == 0) /* a mark may arrive byte by byte */
		*passed = (size_t)(skip_bom(bytes.s, bytes.end) - bytes.s);
	const struct span line = find_first_line(bytes.s + *passed, bytes.end);
	const bool whole = all || line.end < bytes.end || n > LINE_MAX_BYTES ||
	    memchr(line.s, '\0', span_size(line)) != NULL;

	*passed = (size_t)(line.s - bytes.s);
	l->plan.is_list = line.s < line.end && list_begins(line, whole, &known);
	if (!(l->plan.is_list && known) && !whole)
		return false;
	if (l->in.format == FORMAT_SNIFF) {
		l->plan.sniffed = true;
		l->plan.has_none = line.s == line.end;
		l->in = dialect_of(format_of_line(line), ',');
		l->plan.is_list &= l->in.format == FORMAT_JSON;
	}
	if (l->plan.is_list)
		plan_comments(l, (struct span){ skip_bom(bytes.s, line.s), line.s });
	s->has_bom = skip_bom(bytes.s, bytes.end) > bytes.s;
	s->list = (struct list){ .line = 1 };
	for (const char *c = bytes.s; c < line.s; c++)
		s->list.line += *c == '\n';
	return true;
}

/* Reads more of a file to its head; sets has_ended at its end. Returns false there and
 * after an error, which the next read meets again, and tells. */
static bool read_head(struct point_source *s)
{
	static char *head;
	static size_t room;
	const size_t n = span_size(s->head);

	if (n == room) {
		room = room > 0 ? 2 * room : PIECE_FIRST;
		head = xrealloc(head, room);
	}
	const ssize_t more = read_file(s, head + n, room - n);

	s->head = (struct span){ head, head + n + (more > 0 ? (size_t)more : 0) };
	s->has_ended = more == 0;
	return more > 0;
}

bool source_begin(struct point_source *s, struct layout *l, struct refusal *r)
{
	struct span *const bytes = s->text.s != NULL ? &s->text : &s->head;
	bool all = s->text.s != NULL;
	size_t passed = 0;

	plan_begin(l);
	if (s->is_ours)
		return true;
	if (!all)
		all = !read_head(s);
	while (!begin_plan(s, l, *bytes, &passed, all))
		all = !read_head(s);
	if (format_is_foreign(bytes->s, span_size(*bytes),
		format_is_binary(l->in.format), r))
		return false;
	if (l->plan.is_list)
		bytes->s += passed;
	return true;
}

void source_read(struct point_source *s, const struct layout *l, struct piece *p)
{
	p->state = l->plan.is_list ? fill_list(s, p) : fill_piece(s, l, p);
	p->error = errno;
	if (!l->plan.is_list)
		s->bytes_read += p->size;
	s->rest = (struct span){ p->text + p->whole_size, p->text + p->size };
}
