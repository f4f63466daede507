/* SPDX-License-Identifier: MIT */
#include "operands.h"

#include <ctype.h>
#include <string.h>
#include <unistd.h>

#include "../json/text.h"
#include "../message/message.h"
#include "../scene/types.h"

enum { DOCUMENT_MAX = 1 << 28 };

static struct {
	const char *name;
	int fd; /* -1: PARAMS is read to its end */
	struct text text;
	long number; /* of the document, from 1 */
	/* With --scenes: the offset of the document in text, and of the next byte in
	 * the search for its end. The search counts quotes and brackets only, so that
	 * it finds the end of invalid JSON, too. */
	size_t begin, end;
	/* The line of begin and of end, and the byte in that line, from 1. next_scene
	 * counts them before the readers of the document change its text. */
	long long line, end_line;
	size_t column, end_column;
	long level; /* open brackets at end */
	bool quoted, escaped;
} params = { .line = 1, .column = 1, .end_line = 1, .end_column = 1 };

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
	close(params.fd);
	params.fd = -1;
	return false;
}

/* Moves begin past white space, and past byte order marks, which stand between files
 * that were concatenated. Returns false if text ends there, or within such a mark. */
static bool skip_spaces(void)
{
	const char *s, *next = params.text.s + params.begin;
	const char *end = params.text.s + params.text.have;

	do {
		s = next;
		next = skip_mark(json_skip_blanks(s, end), end);
	} while (next != s);
	json_count_lines(params.text.s + params.begin, s, &params.line,
	    &params.column);
	params.begin = params.end = (size_t)(s - params.text.s);
	return s < end && strncmp(s, "\xef\xbb\xbf", (size_t)(end - s)) != 0;
}

/* Continues the search for the end of the document in text. Returns false if the end is
 * not in text yet. */
static bool find_end(void)
{
	if (params.end == params.begin && !skip_spaces())
		return false;
	while (params.end < params.text.have) {
		char c = params.text.s[params.end];

		if (!params.quoted && params.level == 0 && json_is_blank(c))
			return true;
		params.end++;
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
	params.line = params.end_line;
	params.column = params.end_column;
	params.level = 0;
	params.quoted = params.escaped = false;
	message_state.scene = (struct scene_place){ params.number,
		(long)params.line };
	while (!find_end())
		if (!params_more()) {
			params.end = params.text.have;
			break;
		}
	params.end_line = params.line;
	params.end_column = params.column;
	json_count_lines(params.text.s + params.begin,
	    params.text.s + params.end, &params.end_line, &params.end_column);
	const bool found = params.begin < params.end;

	message_state.scene.number = found ? params.number : 0;
	message_state.scene.line = (long)params.line;
	return found;
}

bool params_next(const struct options *o)
{
	if (params.number++ == 0)
		params_open(o);
	else if (!o->scenes)
		return false;
	return !o->scenes || next_scene();
}

/* Refuses points in place of a scene with EXIT_USAGE, as the call is wrong, not the
 * file. A text of points begins with a number, after blank lines and comments; or, if
 * POINTS are named, with [ or, if they are binary, not with {. */
static void check_points(const struct command *c, const struct options *o)
{
	const struct place place = { .file = params.name };
	const char *s = params.text.s + params.begin;
	const bool named = o->n_points > 0;

	while (*(s += strspn(s, " \t\r\n")) == '#')
		s += strcspn(s, "\n");
	if (!isdigit((unsigned char)s[strspn(s, "+-.(")]) &&
	    !(named && params.begin < params.end &&
		(*s == '[' || (is_binary(o->in) && *s != '{'))))
		return;
	if (!command_reads_points(c))
		die_at(EXIT_USAGE, &place, "holds points; a scene is wanted");
	die_at(EXIT_USAGE, &place,
	    "holds points, and a scene is wanted first; name its file: %s %s",
	    named && first_char(o->points[0]) != '[' ? o->points[0] :
						       "scene.json",
	    params.name);
}

/* Returns a hint for messages about points of two numbers, or NULL. Such points may be
 * positions on the device, for which pick and project have options. */
static const char *two_numbers_hint(const struct command *c,
    const struct options *o)
{
	if (c->kind == PICK)
		return POSITION_HINT;
	if (c->kind != PROJECT || o->from != SPACE_DEVICE || o->homogeneous ||
	    (o->has_to && o->to != SPACE_WORLD))
		return NULL;
	return "; for points x y, --ray prints their rays, and --plane A,B,C,D "
	       "where the rays meet a plane";
}

void read_document(const struct command *c, const struct options *o,
    struct document *d)
{
	struct document_wants wants = c->wants;

	while (!o->scenes && params_more())
		continue;
	if (!o->scenes) {
		skip_spaces();
		params.end = params.text.have;
		params.text.s[params.end] = '\0';
		check_points(c, o);
	}
	wants.lines_before = (long)params.line - 1;
	wants.bytes_before = params.column - 1;
	wants.hint_for_two = two_numbers_hint(c, o);
	if (o->has_convention)
		wants.convention = &conventions[o->convention];
	/* operands replace the document's points, which are not read then */
	if (command_reads_points(c) && !o->matrix && o->n_points == 0)
		wants.coordinates = coordinates_of(c, o);
	document_read(d, params.name, params.text.s + params.begin,
	    params.end - params.begin, &wants);
	if (!o->scenes && d->points == NULL)
		text_free(&params.text);
}
