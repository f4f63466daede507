/* SPDX-License-Identifier: MIT */
#include "operands.h"

#include <string.h>

#include "../message/message.h"

enum { DOCUMENT_MAX = 1 << 28 };

#define MARK "\xef\xbb\xbf"

static struct {
	const char *name;
	int fd; /* -1: PARAMS is read to its end */
	struct text text;
	long number; /* of the document, from 1 */
	/* With --scenes: the offset of the document in text, and of the next byte in
	 * the search for its end. The search counts quotes and brackets only, so that
	 * it finds the end of invalid JSON, too. */
	size_t begin, end;
	long line;     /* of begin, from 1 */
	long lines;    /* newlines from begin to end */
	size_t column; /* bytes before begin on its line */
	size_t tail;   /* bytes before end on its line */
	long level;    /* open brackets at end */
	bool quoted, escaped;
} params = { .line = 1 };

static void params_open(const struct options *o)
{
	bool typed = first_char(o->params) == '{';

	params.name = typed ? "PARAMS" : o->params;
	params.fd = typed ? -1 : open_input(o->params);
	if (typed)
		params.text = copy_operand(o->params);
}

/* Reads more of PARAMS after the text in memory. Returns false at the end of PARAMS. */
static bool params_more(void)
{
	struct text *t = &params.text;

	if (params.fd < 0)
		return false;
	if (params.begin > 0) {
		t->have -= params.begin;
		params.end -= params.begin;
		memmove(t->s, t->s + params.begin, t->have);
		params.begin = 0;
	}
	if (t->have > DOCUMENT_MAX)
		die_at(EXIT_INPUT, &(struct place){ .file = params.name },
		    "longer than 256 MiB; give points in a file of their own, "
		    "as POINTS");
	if (read_more(t, params.fd, params.name))
		return true;
	close_input(params.fd);
	params.fd = -1;
	return false;
}

static bool is_space(char c)
{
	return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/* Moves begin past white space, and past byte order marks, which stand between files
 * that were concatenated. */
static void skip_spaces(void)
{
	const char *s = params.text.s + params.begin;
	const char *end = params.text.s + params.text.have;

	for (;;) {
		if (s < end && is_space(*s)) {
			params.line += *s == '\n';
			params.tail = *s++ == '\n' ? 0 : params.tail + 1;
		} else if (end - s >= 3 && memcmp(s, MARK, 3) == 0) {
			s += 3;
			params.tail += 3;
		} else {
			break;
		}
	}
	params.column = params.tail;
	params.begin = params.end = (size_t)(s - params.text.s);
}

/* Returns whether the text that is left is the beginning of a byte order mark. */
static bool is_mark_begun(void)
{
	size_t left = params.text.have - params.begin;

	return left > 0 && left < 3 &&
	    memcmp(params.text.s + params.begin, MARK, left) == 0;
}

/* Continues the search for the end of the document in text. Returns false if the end is
 * not in text yet. */
static bool find_end(void)
{
	if (params.end == params.begin) {
		skip_spaces();
		if (is_mark_begun())
			return false;
	}
	while (params.end < params.text.have) {
		char c = params.text.s[params.end];

		if (!params.quoted && params.level == 0 && is_space(c))
			return true;
		params.end++;
		params.lines += c == '\n';
		params.tail = c == '\n' ? 0 : params.tail + 1;
		if (params.escaped) {
			params.escaped = false;
		} else if (params.quoted) {
			params.escaped = c == '\\';
			params.quoted = c != '"';
		} else if (c == '"') {
			params.quoted = true;
		} else if (c == '{' || c == '[') {
			params.level++;
		} else if ((c == '}' || c == ']') && --params.level <= 0) {
			return true;
		}
	}
	return false;
}

static bool next_scene(void)
{
	params.begin = params.end;
	params.line += params.lines;
	params.level = params.lines = 0;
	params.quoted = params.escaped = false;
	message_state.scene = (struct scene_place){ params.number,
		params.line };
	while (!find_end())
		if (!params_more()) {
			params.end = params.text.have;
			return params.begin < params.end;
		}
	return true;
}

bool params_next(const struct options *o)
{
	if (params.number++ == 0)
		params_open(o);
	else if (!o->scenes)
		return false;
	if (!o->scenes)
		return true;
	bool found = next_scene();

	message_state.scene = (struct scene_place){ found ? params.number : 0,
		params.line };
	return found;
}

/* Returns whether a line has nothing but numbers, brackets, and separators of numbers. */
static bool is_numbers(const char *line)
{
	const char *digit = strpbrk(line, "0123456789");
	const char *end = line + strspn(line, "0123456789+-.eE,; \t()[]");

	return digit != NULL && digit < end && strchr("\r\n", *end) != NULL;
}

/* Returns whether PARAMS holds points in place of a scene: its first line that is not
 * blank or a comment has numbers alone; or, as POINTS are named, it begins as an array
 * or binary points do. */
static bool params_are_points(const struct options *o)
{
	const char *s = params.text.s + params.begin;

	while (*(s += strspn(s, " \t\r\n")) == '#')
		s += strcspn(s, "\n");
	if (o->n_points > 0 && params.begin < params.end &&
	    (*s == '[' || (is_binary(o->in) && *s != '{')))
		return true;
	return *s != '[' && is_numbers(s);
}

/* Refuses points in place of a scene with EXIT_USAGE: the call is wrong, not the file. */
static void check_points(const struct options *o,
    const struct document_wants *wants)
{
	const struct place place = { .file = params.name };
	bool named = o->n_points > 0;

	if (!params_are_points(o))
		return;
	if ((wants->used & SCENE_POINTS) == 0)
		die_at(EXIT_USAGE, &place, "holds points; a scene is wanted");
	die_at(EXIT_USAGE, &place,
	    "holds points, and a scene is wanted first; name its file: %s %s",
	    named ? o->points[0] : "scene.json", params.name);
}

void params_read(const struct options *o, const struct document_wants *wants,
    struct document *d)
{
	struct document_wants w = *wants;

	while (!o->scenes && params_more())
		continue;
	if (!o->scenes) {
		skip_spaces();
		params.end = params.text.have;
		params.text.s[params.end] = '\0';
		check_points(o, wants);
	}
	w.line = params.line - 1;
	w.column = params.column;
	document_read(d, params.name, params.text.s + params.begin,
	    params.end - params.begin, &w);
	if (!o->scenes && d->points == NULL)
		text_free(&params.text);
}
