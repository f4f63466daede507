/* SPDX-License-Identifier: MIT */
#include "params.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "../json/text.h"
#include "../message/message.h"
#include "../message/utf8.h"
#include "../scene/convention_member.h"
#include "input.h"

enum { DOCUMENT_MAX = 1 << 28 };

static struct {
	const char *name;
	int fd; /* -1: nothing of PARAMS is left to read */
	struct input_text text;
	long number; /* index of the document, from 1 */
	/* Offsets in text: the document begins at `begin`, and the search for its end,
	 * which counts quotes and brackets only, continues at `end`. */
	size_t begin, end;
	/* The line and column (in bytes) of `begin`, from 1. Before the readers of the
	 * document change the text, they become those of `end`. */
	long long line;
	size_t column;
	long level;           /* number of brackets open at `end` */
	bool quoted, escaped; /* `end` is in a string; follows a backslash */
} params = { .line = 1, .column = 1 };

static void params_open(const struct options *o)
{
	bool typed = input_first_char(o->params) == '{';

	params.name = typed ? "PARAMS" : o->params;
	params.fd = typed ? -1 : input_open(o->params);
	if (typed)
		params.text = input_of_operand(o->params);
}

/* Appends more of PARAMS to params.text. Returns false at the end of PARAMS. */
static bool params_more(void)
{
	struct input_text *t = &params.text;

	if (params.fd < 0)
		return false;
	if (params.begin > 0) {
		t->size -= params.begin;
		params.end -= params.begin;
		memmove(t->s, t->s + params.begin, t->size);
		params.begin = 0;
	}
	if (t->size > DOCUMENT_MAX)
		die_at(EXIT_INPUT, &(struct place){ .file = params.name },
		    "longer than 256 MiB", "give points in a file of their own");
	if (input_append(t, params.fd, params.name))
		return true;
	close(params.fd);
	params.fd = -1;
	return false;
}

/* Byte order marks may stand between concatenated files. Returns false if params.text
 * ends with the blanks, or in such a mark. */
static bool params_skip_blanks(void)
{
	const char *s, *next = params.text.s + params.begin;
	const char *end = params.text.s + params.text.size;

	do {
		s = next;
		next = skip_bom(json_skip_blanks(s, end), end);
	} while (next != s);
	json_count_lines(params.text.s + params.begin, s, &params.line, &params.column);
	params.begin = params.end = (size_t)(s - params.text.s);
	return s < end && strncmp(s, "\xef\xbb\xbf", (size_t)(end - s)) != 0;
}

/* Moves params.end to the document's end. Returns false if the text ends before it.
 * Goes on where it stopped, as a string may take many reads. */
static bool params_find_end(void)
{
	if (params.end == params.begin && !params_skip_blanks())
		return false;
	while (params.end < params.text.size) {
		const char c = params.text.s[params.end];

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
	params.level = 0;
	message_state.scene = (struct scene_place){ params.number, (long)params.line };
	while (!params_find_end())
		if (!params_more()) {
			params.end = params.text.size;
			break;
		}
	const bool found = params.begin < params.end;

	message_state.scene = (struct scene_place){ found ? params.number : 0,
		(long)params.line };
	return found;
}

bool params_next_document(const struct options *o)
{
	if (params.number++ == 0)
		params_open(o);
	else if (!o->scenes)
		return false;
	return !o->scenes || next_scene();
}

const char *params_points_remedy(const struct options *o, const char *points)
{
	const struct command *c = o->command;

	return command_reads_points(c) ?
	    text("a scene comes first, as in: projcalc %s scene.json %.*s", c->name,
		(int)utf8_fit(points, 200), points) :
	    text("a scene is wanted, as in: projcalc %s %s", c->name, c->example);
}

/* Returns whether the line at s begins with a missing value and, behind it, a field. */
static bool begins_missing(const char *s)
{
	static const char *const words[] = { "nan", "na", "n/a", "null" };
	const size_t n = strcspn(s += strspn(s, "+-\"("), "\" \t\r\n,;");

	for (size_t i = 0; i < sizeof words / sizeof *words; i++)
		if (n == strlen(words[i]) && strncasecmp(s, words[i], n) == 0)
			return strspn(s + n, "\" \t,;") < strcspn(s + n, "\r\n");
	return false;
}

/* Returns whether the line at s begins like one of points: with a number, which may be
 * in brackets, or a missing one, or with v, as in OBJ. */
static bool begins_point(const char *s)
{
	s += strspn(s, " \t");
	if (*s == '[' || (*s == 'v' && (s[1] == ' ' || s[1] == '\t')))
		return true;
	return isdigit((unsigned char)s[strspn(s, "+-.(\"")]) || begins_missing(s);
}

/* Returns whether two numbers or missing values are at s, in brackets or not. */
static bool is_row(const char *s)
{
	s += strspn(s, " \t[");
	if (*s == '\0' || *s == '\n' || !begins_point(s))
		return false;
	s += strcspn(s, " \t,;\r\n");
	s += strspn(s, " \t,;");
	return *s != '[' && *s != '{' && begins_point(s);
}

/* Returns whether a name, from its opening quote on, is that of a coordinate: c, or
 * S_c, as --append writes it. */
static bool is_coordinate(const char *quote, char c)
{
	static const char *const spaces[] = { "", "model_", "world_", "view_", "clip_",
		"ndc_", "device_", "window_" };

	for (size_t i = 0; i < sizeof spaces / sizeof *spaces; i++) {
		const char *const s = quote + 1 + strlen(spaces[i]);

		if (strncmp(quote + 1, spaces[i], strlen(spaces[i])) == 0 &&
		    tolower((unsigned char)*s) == c && s[1] == '"')
			return true;
	}
	return false;
}

/* Returns whether the object at s is a point: it has x and y, and nothing that is in
 * brackets, as all objects of a scene but a device are. */
static bool is_point(const char *s)
{
	const char *const end = s + 1 + strcspn(s + 1, "[]{}");
	const char *quote = *end == '}' ? s : end;
	bool has[2] = { false };

	for (; (quote = memchr(quote, '"', (size_t)(end - quote))) != NULL; quote++)
		for (int i = 0; i < 2; i++)
			has[i] |= is_coordinate(quote, "xy"[i]);
	return has[0] && has[1];
}

/* Returns whether the text at s is points in place of a scene: it is an object that is
 * a point; or none, and one of its first lines begins like a point, or the first has
 * fields with separators. A device has x and y, too. */
static bool begins_with_points(const char *s, bool may_be_device)
{
	enum { LINES = 4 };

	for (int i = 0; i < LINES && *s != '\0'; s += strcspn(s, "\n")) {
		const char *const line = s += strspn(s, " \t\r\n");
		const size_t n = strcspn(line, "\n"), field = strcspn(line, ",\t;");

		if (*line == '#')
			continue;
		if (i == 0 && *line == '{' && !may_be_device && is_point(line))
			return true;
		if (i == 0 && (*line == '{' || strchr("%<-", *line) != NULL) &&
		    !begins_point(line))
			return false;
		if (begins_point(line) ||
		    (i == 0 && field < n && memchr(line, ':', n) == NULL))
			return true;
		i++;
	}
	return false;
}

/* Returns whether text begins like binary numbers: with bytes that no text has, but not
 * as the files do that have a name. */
static bool is_binary(const char *s, size_t n)
{
	const char *at = s, *const end = s + (n < 32 ? n : 32);
	struct refusal foreign;
	unsigned code;

	for (int k; at < end && *at != '{'; at += k) {
		k = utf8_read(at, s + n, &code);
		if (k == 0 || (code < ' ' && !json_is_blank(*at)))
			return n % sizeof(float) == 0 &&
			    !format_is_foreign(s, n, false, &foreign);
	}
	return false;
}

/* Returns whether PARAMS hold points, in any format. Of a later document of --scenes
 * only what it begins with is looked at. */
static bool hold_points(const struct options *o)
{
	const char *s = params.text.s + params.begin;
	const enum format f = format_of_name(params.name);
	const bool table = f == FORMAT_OBJ || format_rows[f].table;
	const bool may_be_device = o->command->wants.lone_member == SCENE_DEVICE;

	if (params.begin == params.end)
		return false;
	if (params.number > 1)
		return *s == '{' ? !may_be_device && is_point(s) : is_row(s);
	return (*s != '{' && (table || format_is_binary(o->in))) ||
	    begins_with_points(s, may_be_device) ||
	    is_binary(s, params.text.size - params.begin);
}

/* Refuses PARAMS that hold points, for all scenes. */
static bool check_not_points(const struct options *o, struct document *d)
{
	if (!hold_points(o))
		return true;
	d->is_usage = d->ends_run = true;
	return document_refuse(d, NULL, "holds points",
	    params_points_remedy(o,
		input_first_char(o->params) == '{' ? "points.json" : params.name));
}

/* Refuses PARAMS in UTF-16, as some shells write JSON, and files of NumPy, for all
 * scenes. A later scene does not begin the file, which tells it. */
static bool check_not_foreign(struct document *d)
{
	const char *const s = params.text.s + params.begin;
	const size_t n = params.end - params.begin;
	struct refusal foreign;

	if (params.number > 1 || !format_is_foreign(s, n, true, &foreign))
		return true;
	d->ends_run = true;
	return document_refuse(d, NULL, foreign.what, foreign.remedy);
}

/* Returns whether the options read or print positions on the device. */
static bool wants_device(const struct options *o)
{
	const bool back = o->ray || o->plane.n > 0;
	const bool from = o->has_from ? o->from == SPACE_DEVICE : back;
	const bool to = o->has_to && o->to == SPACE_DEVICE;

	return (from || to) && !(from && to);
}

/* Returns a hint for points of two numbers, which may be positions; or NULL. */
static const char *find_two_numbers_hint(const struct options *o)
{
	if (o->command->kind == COMMAND_PICK)
		return POSITION_HINT;
	if (o->command->kind != COMMAND_PROJECT || o->from != SPACE_DEVICE ||
	    o->homogeneous || (o->has_to && o->to != SPACE_WORLD))
		return NULL;
	return "for x y, --ray prints rays, and --plane A,B,C,D where they meet it";
}

bool params_read_document(const struct options *o, struct document *d,
    struct refusals *faults)
{
	struct document_wants wants = o->command->wants;

	if (!o->scenes) {
		while (params_more())
			continue;
		params_skip_blanks();
		params.end = params.text.size;
	}
	params.text.s[params.text.size] = '\0';
	wants.source.faults = faults;
	wants.source.lines_before = (long)params.line - 1;
	wants.source.bytes_before = params.column - 1;
	if (o->scenes)
		json_count_lines(params.text.s + params.begin,
		    params.text.s + params.end, &params.line, &params.column);
	*d = (struct document){ .source = wants.source };
	d->source.name = params.name;
	if (!check_not_points(o, d) || !check_not_foreign(d))
		return false;
	wants.source.two_numbers_hint = find_two_numbers_hint(o);
	if (o->plane.n > 0)
		wants.source.task = TASK_PLANE;
	if (wants_device(o))
		wants.needed |= SCENE_VIEWPORT;
	if (o->has_convention)
		wants.convention = &conventions[o->convention];
	/* the document's points are not read if operands replace them */
	if (command_reads_points(o->command) && !o->matrix && o->n_points == 0)
		wants.coordinates = options_coordinates(o);
	const bool good = document_read(d, params.name, params.text.s + params.begin,
	    params.end - params.begin, &wants);

	if (!o->scenes && d->points == NULL)
		input_free(&params.text);
	return good;
}
