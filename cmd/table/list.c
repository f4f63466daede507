/* SPDX-License-Identifier: MIT */
#include "list.h"

#include "check.h"
#include "../json/text.h"
#include "../message/escape.h"
#include "../message/message.h"

/* The most bytes of which the stops are found together, so that 16 bits hold a
 * place. */
enum { LIST_BLOCK = 1 << 13 };

struct cutter {
	struct list *list;
	struct list_lines *to;
	const char *s;  /* the block */
	size_t at, end; /* the place, and the end, in the block */
	/* the stops of the block from `at` or before it on, and a last one beyond it */
	const uint16_t *stop;
	struct refusal *fault;
};

/* Makes the set of the bytes that change the state in an element. */
static struct byte_set list_stops(void)
{
	static const char bytes[] = "[]{}\"\\\n";
	struct byte_set set = { { 0 }, { 0 } };
	int bits = 0;

	for (const char *s = bytes; *s != '\0'; s++)
		byte_set_add(&set, &bits, (uint8_t)*s);
	return set;
}

/* Does what number_loops.find does, on any processor. */
static size_t find_stops(const struct byte_set *set, const char *s, size_t n,
    uint16_t *at)
{
	const struct number_loops *loops = number_loops_chosen();
	size_t found = 0;

	if (loops != NULL)
		return loops->find(set, s, n, at);
	for (size_t i = 0; i < n; i++) {
		const uint8_t b = (uint8_t)s[i];

		if ((set->low[b & 15] & set->high[b >> 4]) != 0)
			at[found++] = (uint16_t)i;
	}
	return found;
}

static struct list_place place_of(const struct cutter *c, size_t at)
{
	const struct list *l = c->list;

	return (struct list_place){ l->line, l->done + at - l->begin + 1, false };
}

static bool refuse_list(struct cutter *c, struct list_place place, const char *what)
{
	refusal_set(c->fault, NULL, what, NULL);
	c->fault->line = place.line;
	c->fault->column = place.column;
	return false;
}

/* Begins the next line at byte `at`. */
static void begin_line(struct cutter *c, size_t at)
{
	c->list->line++;
	c->list->begin = c->list->done + at;
}

static void put(struct cutter *c, const char *s, size_t n)
{
	memcpy(c->to->text + c->to->size, s, n);
	c->to->size += n;
}

static void end_element(struct cutter *c)
{
	struct list_lines *to = c->to;

	c->list->state = LIST_AFTER;
	to->place[to->n++] = c->list->from;
	to->text[to->size] = '\n';
	to->whole_size = ++to->size;
}

/* Makes one blank of a line end, which was passed, and the blanks before it; those
 * after it are skipped. */
static bool join_line(struct cutter *c)
{
	struct list_lines *to = c->to;

	if (c->list->quoted)
		return refuse_list(c, place_of(c, c->at - 1),
		    "a string is not closed on its line");
	while (to->size > to->whole_size && json_is_blank(to->text[to->size - 1]))
		to->size--;
	put(c, " ", 1);
	c->list->skips = c->list->from.joined = true;
	begin_line(c, c->at);
	return true;
}

/* Copies n bytes, mostly by moves of 32 bytes, for which there is room in the copy, and
 * if `more` bytes follow in the text. The sizes of points vary, and most are below 64
 * bytes: these take no branch. */
static inline void copy_run(char *to, const char *s, size_t n, size_t more)
{
	if (more < 64) {
		memcpy(to, s, n);
		return;
	}
	memcpy(to, s, 64);
	for (size_t i = 64; i < n; i += 32)
		memcpy(to + i, s + i, 32);
}

/* Takes a line end or a backslash. Returns false at a fault. */
static bool take_stop(struct cutter *c, char b)
{
	if (b == '\n')
		return join_line(c);
	put(c, &b, 1);
	c->list->escaped = c->list->quoted;
	return true;
}

/* Passes brackets, quotes and what is between them: to the end of the element, and
 * returns true; or to a line end, a backslash or the end of the block. Local variables
 * stay in registers: most of the time of a list is spent here. */
static inline bool pass_to_end(struct cutter *c)
{
	const char *const s = c->s;
	const size_t end = c->end;
	const uint16_t *stop = c->stop;
	int level = c->list->level;
	bool quoted = c->list->quoted, ended = false;

	while (*stop < c->at)
		stop++;
	while (!ended && *stop < end) {
		const char b = s[*stop];

		if (b == '\n' || b == '\\')
			break;
		stop++;
		quoted ^= b == '"';
		if (b == '"' || quoted)
			continue;
		/* of the brackets ] and } have a bit that [ and { have not */
		level += (b & 4) == 0 ? 1 : -1;
		ended = level == 0;
	}
	c->at = ended ? stop[-1] + 1u : *stop < end ? *stop : end;
	c->stop = stop;
	c->list->level = level;
	c->list->quoted = quoted;
	return ended;
}

/* Cuts the part of an array or object up to its end, or to where it pauses: a line end,
 * a backslash, the end of the block. */
static bool cut_element(struct cutter *c)
{
	struct list *l = c->list;

	if (l->escaped) {
		l->escaped = false;
		put(c, &c->s[c->at++], 1);
	}
	while (l->skips && c->at < c->end && json_is_blank(c->s[c->at]))
		if (c->s[c->at++] == '\n')
			begin_line(c, c->at);
	l->skips &= c->at == c->end;

	const size_t from = c->at;
	const bool ended = pass_to_end(c);
	const size_t n = c->at - from, size = c->to->size;

	c->to->size = size + n;
	copy_run(c->to->text + size, c->s + from, n, c->end - c->at);
	if (ended)
		end_element(c);
	return ended || c->at == c->end || take_stop(c, c->s[c->at++]);
}

/* Ends a value that is no point, which plan.c refuses; it has to be JSON, without which
 * the list can't go on. */
static bool end_scalar(struct cutter *c)
{
	const struct list_lines *to = c->to;
	const char *s = to->text + to->whole_size, *end = to->text + to->size;
	struct json_check check = { .at = s, .end = end };
	char shown[ESCAPED_MAX];

	if (json_check(&check)) {
		end_element(c);
		return true;
	}
	escape_short(shown, s, (size_t)(end - s));
	return refuse_list(c, c->list->from,
	    text("is no JSON: expected a value, not '%s'", shown));
}

/* Cuts a value that is no point: it ends at a blank, a comma or the end of the list. */
static bool cut_scalar(struct cutter *c)
{
	struct list *l = c->list;

	while (c->at < c->end && l->state == LIST_SCALAR) {
		const char b = c->s[c->at];

		if (b == '\n' ||
		    (!l->quoted && (json_is_blank(b) || b == ',' || b == ']')))
			return end_scalar(c);
		put(c, &b, 1);
		c->at++;
		l->quoted ^= b == '"' && !l->escaped;
		l->escaped = l->quoted && b == '\\' && !l->escaped;
	}
	return true;
}

/* Passes what is between elements, up to the next one or the end of the block. */
static bool cut_between(struct cutter *c)
{
	const char *const s = c->s;
	const size_t end = c->end;
	struct list *l = c->list;
	enum list_state state = l->state;
	size_t at = c->at;

	for (; at < end; at++) {
		if (state == LIST_AFTER && s[at] == ',')
			state = LIST_NEXT;
		else if (s[at] == '\n')
			begin_line(c, at + 1);
		else if (json_is_blank(s[at]))
			continue;
		else if (state == LIST_BEGIN)
			state = LIST_FIRST;
		else if (s[at] == ']' && (state == LIST_FIRST || state == LIST_AFTER))
			state = LIST_END;
		else
			break;
	}
	c->at = at;
	l->state = state;
	if (at == end)
		return true;
	l->from = place_of(c, at);
	if (state == LIST_END)
		return refuse_list(c, l->from, "more follows the end of the list");
	if (state == LIST_AFTER)
		return refuse_list(c, l->from,
		    "a comma or ] is wanted after an element");
	if (s[at] == ',' || s[at] == ']')
		return refuse_list(c, l->from, "an element of the list is missing");
	l->state = s[at] == '[' || s[at] == '{' ? LIST_ELEMENT : LIST_SCALAR;
	return true;
}

static bool cut_block(struct cutter *c)
{
	const struct list *l = c->list;
	bool ok = true;

	while (ok && c->at < c->end)
		ok = l->state == LIST_ELEMENT ? cut_element(c) :
		    l->state == LIST_SCALAR   ? cut_scalar(c) :
						cut_between(c);
	return ok;
}

bool list_cut(struct list *l, const char *s, size_t n, struct list_lines *to,
    struct refusal *fault)
{
	const struct byte_set stops = list_stops();
	struct cutter c = { .list = l, .to = to, .fault = fault };
	uint16_t stop[LIST_BLOCK + 128];

	if (n == 0)
		return l->state == LIST_END ||
		    refuse_list(&c, place_of(&c, 0), "the list has no ]");
	for (size_t done = 0; done < n; done += c.end) {
		c.s = s + done;
		c.at = 0;
		c.end = n - done < LIST_BLOCK ? n - done : LIST_BLOCK;
		stop[find_stops(&stops, c.s, c.end, stop)] = UINT16_MAX;
		c.stop = stop;
		if (!cut_block(&c))
			return false;
		l->done += c.end;
	}
	return true;
}

bool list_begins(struct span line, bool complete, bool *known)
{
	const struct dialect json = { FORMAT_JSON, ',' };
	const char *s = skip_blanks(json, line.s, line.end);

	*known = true;
	if (s < line.end && *s != '[')
		return false;
	s = skip_blanks(json, s + (s < line.end), line.end);
	*known = s < line.end || complete;
	return s == line.end || *s == '[' || *s == '{' ||
	    (*s == ']' && skip_blanks(json, s + 1, line.end) == line.end);
}
