/* SPDX-License-Identifier: MIT */
#include "operands.h"

#include <string.h>

#include "input.h"
#include "../message/message.h"

enum { DOCUMENT_MAX = 1 << 28 };

#define MARK "\xef\xbb\xbf"

static struct {
	const char *name;
	int fd; /* -1: all has been read */
	struct text text;
	long number; /* of the document, from 1 */
	/* Where it begins and, as far as has been looked, ends; with --scenes
	 * alone. Quotes and brackets of either kind say what belongs together,
	 * whatever else is wrong with it. */
	size_t begin, end;
	long line, lines; /* where it begins, from 1; that it goes on for */
	size_t column;    /* bytes before begin on its line */
	size_t tail;      /* and before end on that line */
	long level;
	bool quoted, escaped;
} params = { .line = 1 };

static void start(const struct options *o)
{
	bool typed = first_char(o->params) == '{';

	params.name = typed ? "PARAMS" : o->params;
	params.fd = typed ? -1 : open_input(o->params);
	if (typed)
		params.text = copy_operand(o->params);
}

/* Reads more of PARAMS behind the document; false at its end. */
static bool more(void)
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
		    "a document of more than 256 MiB; points may stand in a "
		    "file of their own");
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

/* And past byte order marks: files may have been put together. */
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

/* Whether what is left may become a byte order mark. */
static bool is_mark_begun(void)
{
	size_t left = params.text.have - params.begin;

	return left > 0 && left < 3 &&
	    memcmp(params.text.s + params.begin, MARK, left) == 0;
}

/* Looks on for the end of the document; false where that hasn't been read yet. */
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
		if (!more()) {
			params.end = params.text.have;
			return params.begin < params.end;
		}
	return true;
}

bool params_next(const struct options *o)
{
	if (params.number++ == 0)
		start(o);
	else if (!o->scenes)
		return false;
	if (!o->scenes)
		return true;
	bool found = next_scene();

	message_state.scene = (struct scene_place){ found ? params.number : 0,
		params.line };
	return found;
}

/* Copies the first line that is not blank or, as points may have it, a comment, as far
 * as there is room. */
static void first_line(char *out, size_t room)
{
	const char *s = params.text.s + params.begin;
	const char *end = params.text.s + params.end;
	size_t n = 0;

	while (s < end && (is_space(*s) || *s == '#')) {
		const char *newline = memchr(s, '\n', (size_t)(end - s));

		s = *s != '#' ? s + 1 : newline != NULL ? newline + 1 : end;
	}
	while (s < end && *s != '\n' && *s != '\r' && n + 1 < room)
		out[n++] = *s++;
	out[n] = '\0';
}

/* Refuses points in place of a scene: a line of numbers; or, where POINTS are
 * named, an array or binary points. The call is wrong, not the file. */
static void check_points(const struct options *o,
    const struct document_wants *wants)
{
	const struct place place = { .file = params.name };
	bool named = o->n_points > 0, points;
	char line[200];

	first_line(line, sizeof line);
	points = is_numbers(line) && *line != '[';
	if (named && params.begin < params.end)
		points |= *line == '[' || (is_binary(o->in) && *line != '{');
	if (!points)
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

	while (!o->scenes && more())
		continue;
	if (!o->scenes) {
		skip_spaces();
		params.end = params.text.have;
		check_points(o, wants);
	}
	w.line = params.line - 1;
	w.column = params.column;
	document_read(d, params.name, params.text.s + params.begin,
	    params.end - params.begin, &w);
	if (!o->scenes && d->points == NULL)
		text_free(&params.text);
}
