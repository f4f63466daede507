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
	/* the stops of the block from `at` or before it on, and a last one beyond the
	 * block; NULL: the processor has no vector code */
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

/* Returns the place of the next byte from c->at on that changes the state. */
static inline size_t next_stop(struct cutter *c)
{
	size_t at = c->at;

	if (c->stop == NULL) {
		while (at < c->end && strchr("[]{}\"\\\n", c->s[at]) == NULL)
			at++;
		return at;
	}
	while (*c->stop < at)
		c->stop++;
	return *c->stop < c->end ? *c->stop : c->end;
}

static void put(struct cutter *c, const char *s, size_t n)
{
	memcpy(c->to->text + c->to->size, s, n);
	c->to->size += n;
}

static void end_element(struct cutter *c)
{
	struct list_lines *to = c->to;

	to->text[to->size++] = '\n';
	to->whole_size = to->size;
	to->place[to->n++] = c->list->from;
	c->list->state = LIST_AFTER;
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
	const char *s = c->s;
	const size_t end = c->end;
	int level = c->list->level;
	bool quoted = c->list->quoted, ended = false;
	size_t stop = next_stop(c);

	while (stop < end && s[stop] != '\n' && s[stop] != '\\') {
		const char b = s[stop++];

		/* of the brackets ] and } have a bit that [ and { have not */
		quoted ^= b == '"';
		if (!quoted && b != '"')
			level += (b & 4) == 0 ? 1 : -1;
		c->at = stop;
		ended = level == 0;
		if (ended)
			break;
		stop = next_stop(c);
	}
	if (!ended)
		c->at = stop;
	c->list->level = level;
	c->list->quoted = quoted;
	return ended;
}

/* Cuts the part of an array or object up to its end or that of the block. */
static bool cut_element(struct cutter *c)
{
	struct list *l = c->list;

	while (c->at < c->end && l->state == LIST_ELEMENT) {
		if (l->escaped) {
			l->escaped = false;
			put(c, &c->s[c->at++], 1);
			continue;
		}
		while (l->skips && c->at < c->end && json_is_blank(c->s[c->at]))
			if (c->s[c->at++] == '\n')
				begin_line(c, c->at);
		l->skips &= c->at == c->end;
		const size_t from = c->at;
		const bool ended = pass_to_end(c);

		copy_run(c->to->text + c->to->size, c->s + from, c->at - from,
		    c->end - c->at);
		c->to->size += c->at - from;
		if (ended)
			end_element(c);
		else if (c->at < c->end && !take_stop(c, c->s[c->at++]))
			return false;
	}
	return true;
}

/* Ends a value that is no point, which plan.c refuses; it has to be JSON, without which
 * the list can't go on. */
static bool end_scalar(struct cutter *c)
{
	const struct list_lines *to = c->to;
	const char *s = to->text + to->whole_size, *end = to->text + to->size;
	struct json_check check = { .s = s, .end = end };
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

static void begin_element(struct cutter *c, char b)
{
	struct list *l = c->list;

	l->from = place_of(c, c->at);
	l->level = 0;
	l->quoted = l->escaped = l->skips = false;
	l->state = b == '[' || b == '{' ? LIST_ELEMENT : LIST_SCALAR;
}

/* Takes the byte b between elements. */
static bool cut_between(struct cutter *c, char b)
{
	struct list *l = c->list;

	if (json_is_blank(b)) {
		if (b == '\n')
			begin_line(c, c->at + 1);
	} else if (l->state == LIST_BEGIN) {
		l->state = LIST_FIRST;
	} else if (l->state == LIST_END) {
		return refuse_list(c, place_of(c, c->at),
		    "more follows the end of the list");
	} else if (b == ']' && l->state != LIST_NEXT) {
		l->state = LIST_END;
	} else if (l->state == LIST_AFTER) {
		if (b != ',')
			return refuse_list(c, place_of(c, c->at),
			    "a comma or ] is wanted after an element");
		l->state = LIST_NEXT;
	} else if (b == ',' || b == ']') {
		return refuse_list(c, place_of(c, c->at),
		    "an element of the list is missing");
	} else {
		begin_element(c, b);
		return true;
	}
	c->at++;
	return true;
}

/* Returns the end of the array or object whose bracket is the next stop, if it ends in
 * the line and before `end`, without a backslash; else 0. */
static inline size_t usual_end(const char *s, size_t end, const uint16_t **stop)
{
	const uint16_t *at = *stop;
	int level = 0;

	do {
		char b = *at < end ? s[*at] : '\n';

		if (b == '"')
			do {
				b = *++at < end ? s[*at] : '\n';
				if (b == '\n' || b == '\\')
					return 0;
			} while (b != '"');
		else if (b == '\n' || b == '\\')
			return 0;
		else
			level += (b & 4) == 0 ? 1 : -1;
		at++;
	} while (level > 0);
	*stop = at;
	return at[-1] + 1u;
}

/* Cuts elements that end in their line, as most do, and in the block. What it leaves,
 * the other functions cut; they give the same lines, as cmd/test/lines_test.t compares
 * for the processors, of which the baseline has no stops. */
static void cut_usual(struct cutter *c)
{
	struct list *l = c->list;
	struct list_lines to = *c->to;
	const char *const s = c->s;
	const uint16_t *stop = c->stop;
	size_t at = c->at;

	while (stop != NULL) {
		bool comma = l->state != LIST_AFTER;
		size_t begin = l->begin;
		long long line = l->line;

		for (;
		     at < c->end && (json_is_blank(s[at]) || (s[at] == ',' && !comma));
		     at++) {
			line += s[at] == '\n';
			begin = s[at] == '\n' ? l->done + at + 1 : begin;
			comma |= s[at] == ',';
		}
		if (at == c->end || !comma || (s[at] != '[' && s[at] != '{'))
			break;
		while (*stop < at)
			stop++;
		const size_t end = usual_end(s, c->end, &stop);

		if (end == 0)
			break;
		copy_run(to.text + to.size, s + at, end - at, c->end - end);
		to.size += end - at;
		to.text[to.size++] = '\n';
		to.place[to.n++] = (struct list_place){ line, l->done + at - begin + 1,
			false };
		to.whole_size = to.size;
		c->at = at = end;
		c->stop = stop;
		l->line = line;
		l->begin = begin;
		l->state = LIST_AFTER;
	}
	*c->to = to;
}

static bool is_between(enum list_state state)
{
	return state == LIST_FIRST || state == LIST_AFTER || state == LIST_NEXT;
}

static bool cut_block(struct cutter *c)
{
	const struct list *l = c->list;
	bool tried = false;

	while (c->at < c->end) {
		if (!tried && is_between(l->state)) {
			tried = true;
			cut_usual(c);
			continue;
		}
		tried = tried && is_between(l->state);
		if (!(l->state == LIST_SCALAR        ? cut_scalar(c) :
			    l->state == LIST_ELEMENT ? cut_element(c) :
						       cut_between(c, c->s[c->at])))
			return false;
	}
	return true;
}

bool list_cut(struct list *l, const char *s, size_t n, struct list_lines *to,
    struct refusal *fault)
{
	const struct number_loops *loops = number_loops_chosen();
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
		if (loops != NULL) {
			stop[loops->find(&stops, c.s, c.end, stop)] = UINT16_MAX;
			c.stop = stop;
		}
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
