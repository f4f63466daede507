#include "mistaken.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "input.h"
#include "nearest.h"
#include "scene/members.h"
#include "talk.h"

/* What others call it. */
static const struct {
	const char *word, *call;
} others[] = {
	{ "unproject", "project --from device --to world" },
	{ "backproject", "project --from device --to world" },
	{ "ray", "project --ray" },
	{ "raycast", "project --ray" },
	{ "transform", "project" },
	{ "convert", "project" },
	{ "points", "project" },
	{ "camera", "lookat" },
	{ "view", "lookat" },
	{ "perspective", "persp" },
	{ "projection", "persp" },
	{ "frustum", "persp" },
	{ "orthographic", "ortho" },
	{ "cavalier", "oblique" },
	{ "cabinet", "oblique" },
	{ "mvp", "project -m --to clip" },
	{ "matrix", "project -m --to clip" },
	{ "inverse", "project -m --from view --to world" },
	{ "invert", "project -m --from view --to world" },
	{ "pose", "project -m --from view --to world" },
	{ "viewport", "project --from ndc --to device" },
	{ "window", "w2n" },
	{ "device", "n2d" },
	{ "bounds", "fit" },
	{ "zoom", "fit" },
	{ "info", "inspect" },
	{ "click", "pick" },
	{ "explain", "trace" },
	{ "usage", "help" },
	{ "man", "help" },
	{ "-V", "--version" },
	{ "-v", "--version" },
};

enum { NAMES_MAX = 64 };

static bool is_command(const struct command *c, const char *word)
{
	while (c->name != NULL && strcmp(c->name, word) != 0)
		c++;
	return c->name != NULL;
}

static _Noreturn void unknown(const char *word, const char *const *names)
{
	const char *near = NULL;

	for (size_t i = 0; i < sizeof others / sizeof *others; i++)
		if (strcmp(others[i].word, word) == 0)
			near = others[i].call;
	if (near == NULL)
		near = nearest(word, names);
	if (near != NULL)
		die(EXIT_USAGE, "unknown command '%s'; did you mean '%s'?",
		    word, near);
	die(EXIT_USAGE, "unknown command '%s'; 'projcalc help' lists them",
	    word);
}

/* The command that reads what is typed: its first member says which. */
static const char *command_of(const char *typed)
{
	char name[64] = "";
	static char word[64];

	sscanf(typed, " { \"%63[a-z_]", name);
	for (const struct member *s = scene_members; s->name != NULL; s++)
		if (strcmp(s->name, name) == 0)
			return "project";
	for (const struct member *s = scene_members; s->name != NULL; s++)
		if (s->members != NULL && member_named(s->members, name)) {
			sscanf(s->command, "%63s", word);
			return word;
		}
	return "project";
}

/* Whether a word is rather an operand. */
static bool is_operand(const char *word)
{
	char first = first_char(word);

	return first == '{' || first == '[' || strpbrk(word, "./") != NULL ||
	    access(word, R_OK) == 0;
}

void mistaken_command(const struct command *commands, char **words)
{
	const char *names[NAMES_MAX] = { "--help", "--version" };
	int n = 2;

	for (const struct command *c = commands; c->name != NULL; c++)
		names[n++] = c->name;
	for (char **w = words + 1; *w != NULL; w++)
		if ((**words == '-' || is_operand(*words)) &&
		    is_command(commands, *w))
			die(EXIT_USAGE,
			    "'%s' stands before the command; write projcalc "
			    "%s %s ...",
			    *words, *w, *words);
	if (is_operand(*words))
		die(EXIT_USAGE,
		    "'%s' is no command; write projcalc %s %s, or what "
		    "'projcalc help' lists",
		    *words, command_of(*words),
		    first_char(*words) == '{' ? "'{...}'" : *words);
	unknown(*words, names);
}

void mistaken_topic(const struct command *commands, const char *word)
{
	const char *names[NAMES_MAX] = { NULL };
	int n = 0;

	for (const struct command *c = commands; c->name != NULL; c++)
		names[n++] = c->name;
	for (const struct member *m = scene_members; m->name != NULL; m++)
		names[n++] = m->name;
	unknown(word, names);
}

/* Whether a text is of numbers, and of what stands between and around them. */
static bool is_numbers(const char *s)
{
	return strpbrk(s, "0123456789") != NULL &&
	    s[strspn(s, "0123456789+-.eE,; \t\n()[]")] == '\0';
}

/* Adds the numbers of s to a list, with a comma before each but the first. */
static size_t add_numbers(char *list, size_t at, size_t room, const char *s)
{
	const char between[] = ",; \t\n()[]";

	for (s += strspn(s, between); *s != '\0'; s += strspn(s, between)) {
		size_t n = strcspn(s, between);

		if (at + n + 2 > room)
			break;
		at += (size_t)sprintf(list + at, "%s%.*s", at > 0 ? "," : "",
		    (int)n, s);
		s += n;
	}
	return at;
}

enum { VALUE_MAX = 200 };

/* Writes what was meant for a member's value as JSON. */
static void write_value(char out[VALUE_MAX], const struct member *m,
    const char *text)
{
	char list[VALUE_MAX - 4] = "";

	if (*text == '\0')
		snprintf(out, VALUE_MAX, "%s",
		    m->example != NULL ? m->example : "...");
	else if (strcmp(text, "true") == 0 || strcmp(text, "false") == 0 ||
	    strchr("[{", *text) != NULL)
		snprintf(out, VALUE_MAX, "%s", text);
	else if (!is_numbers(text))
		snprintf(out, VALUE_MAX, "\"%.*s\"", VALUE_MAX - 3, text);
	else if (add_numbers(list, 0, sizeof list, text) > 0)
		snprintf(out, VALUE_MAX,
		    strchr(list, ',') != NULL ? "[%s]" : "%s", list);
}

/* The name in an option, "--eye=0,0,5" or "-eye". */
static void name_of(char out[64], const char *word)
{
	word += strspn(word, "-");
	snprintf(out, 64, "%.*s", (int)strcspn(word, "="), word);
}

/* The text behind it: after =, or the next word, or as many as are of numbers.
 * Returns where the words go on. */
static char **text_of(char out[VALUE_MAX], char **words)
{
	const char *equals = strchr(*words++, '=');
	size_t at = 0;

	snprintf(out, VALUE_MAX, "%s", equals != NULL ? equals + 1 : "");
	if (equals != NULL || *words == NULL)
		return words;
	if (!is_numbers(*words) && **words != '-')
		snprintf(out, VALUE_MAX, "%s", *words++);
	else
		while (*words != NULL && is_numbers(*words))
			at = add_numbers(out, at, VALUE_MAX, *words++);
	return words;
}

/* In the object's table. */
static const struct member *find_in(const struct member *object,
    const char *name, bool exact)
{
	const struct member *m = object->members != NULL ?
	    member_named(object->members, name) :
	    NULL;

	if (strcmp(name, object->name) == 0)
		return object;
	return m != NULL && exact && strcmp(m->name, name) != 0 ? NULL : m;
}

/* Finds a member of that name: in the object that the command reads alone; in
 * another that it reads, width rather in the viewport than in the projection before
 * it, eye rather in the camera than in a kind of projection; and, where that need
 * not be its exact name, in any. *object is the scene's member that has it, or is
 * it. */
static const struct member *find(const struct command *c, const char *name,
    bool exact, const struct member **object)
{
	const unsigned bits[] = { c->wants.bare, c->wants.used, ~0u };
	const struct member *m;

	for (int i = 0; i < (exact ? 2 : 3); i++) {
		for (int k = 31; i == 1 && k >= 0; k--) {
			if ((bits[i] >> k & 1) == 0)
				continue;
			*object = &scene_members[k];
			if ((*object)->members != NULL &&
			    member_bit((*object)->members, 0, name) != 0)
				return find_in(*object, name, true);
		}
		for (int k = 0; scene_members[k].name != NULL; k++) {
			*object = &scene_members[k];
			m = bits[i] >> k & 1 ? find_in(*object, name, exact) :
					       NULL;
			if (m != NULL)
				return m;
		}
	}
	return NULL;
}

/* The command for the kind of projection that has the member. */
static const char *command_for(const struct command *c, const struct member *m,
    const struct member *object)
{
	int kind = 0;

	if (c->wants.projection == 0 || m->kinds == 0 ||
	    m->kinds >> (c->wants.projection - 1) & 1)
		return c->name;
	while ((m->kinds >> kind & 1) == 0)
		kind++;
	return object->members->words[kind];
}

/* The members of one object that the words are options of, as JSON. */
static void write_members(char *out, size_t room, const struct command *c,
    char **words)
{
	const struct member *object = NULL, *other, *m;
	char name[64], text[VALUE_MAX], value[VALUE_MAX];
	size_t at = 0;
	int n = 0;

	for (*out = '\0'; *words != NULL && **words == '-'; n++) {
		name_of(name, *words);
		m = find(c, name, false, &other);
		if (m == NULL || (object != NULL && other != object))
			break;
		object = other;
		words = text_of(text, words);
		write_value(value, m, text);
		if (at < room)
			at += (size_t)snprintf(out + at, room - at,
			    "%s\"%s\": %s", n > 0 ? ", " : "", m->name, value);
	}
	if ((n == 1 || (*words != NULL && **words == '-')) && at < room)
		snprintf(out + at, room - at, ", ...");
}

void mistaken_member(const struct command *c, char **words, bool exact)
{
	const struct member *object, *m;
	char name[64], members[800];
	const int dashes = (int)strspn(*words, "-");

	name_of(name, *words);
	m = find(c, name, exact, &object);
	if (m == NULL)
		return;
	unsigned bit = 1u << (object - scene_members);
	bool bare = m == object || (c->wants.bare & bit) != 0;

	if (bit == SCENE_POINTS)
		die(EXIT_USAGE,
		    "%s: unknown option %.*s%s; POINTS stand after PARAMS: "
		    "projcalc %s scene.json points.txt",
		    c->name, dashes, *words, name, c->name);
	if ((c->wants.used & bit) == 0 && !(bit & SCENE_CONVENTION))
		die(EXIT_USAGE,
		    "%s: unknown option %.*s%s; \"%s\" is a member of the "
		    "scene that %s does not read; 'projcalc help %s' tells of "
		    "it",
		    c->name, dashes, *words, name, object->name, c->name,
		    object->name);
	write_members(members, sizeof members, c, words);
	die(EXIT_USAGE,
	    "%s: unknown option %.*s%s; \"%s\" is a member of the %s: "
	    "projcalc %s '{%s%s%s%s%s}'",
	    c->name, dashes, *words, name, m->name,
	    m == object ? "scene" : object->name, command_for(c, m, object),
	    bare ? "" : "\"", bare ? "" : object->name, bare ? "" : "\": {",
	    members, bare ? "" : "}, ...");
}

const char *mistaken_option(const char *name)
{
	static const char *const pairs[][2] = {
		{ "format", "output" },
		{ "space", "to" },
		{ "threads", "jobs" },
		{ "round", "decimals" },
		{ "places", "decimals" },
		{ "epsilon", "tolerance" },
		{ "unproject", "from" },
		{ "json", "output" },
		{ "csv", "input" },
	};

	for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
		if (strcmp(pairs[i][0], name) == 0)
			return pairs[i][1];
	return NULL;
}

enum { GLANCE_MAX = 256 };

/* The beginning of a regular file, or what is typed, without blanks before it;
 * "" for what can be read but once, or not at all. Returns out. */
static const char *glance(const char *name, char out[GLANCE_MAX])
{
	char typed = first_char(name);
	struct stat st;
	ssize_t n = 0;

	snprintf(out, GLANCE_MAX, "%s", name);
	if (typed != '{' && typed != '[') {
		if (!is_stdin(name) && stat(name, &st) == 0 &&
		    S_ISREG(st.st_mode) && access(name, R_OK) == 0) {
			int fd = open_input(name);

			n = read(fd, out, GLANCE_MAX - 1);
			close_input(fd);
		}
		out[n > 0 ? n : 0] = '\0';
	}
	if (strncmp(out, "\xef\xbb\xbf", 3) == 0)
		out += 3;
	return out + strspn(out, " \t\r\n");
}

/* PARAMS that are points, and POINTS that are a scene or are not there. */
static void check_traded(const struct command *c, const struct options *o)
{
	char first[GLANCE_MAX], second[GLANCE_MAX];
	const char *params = glance(o->params, first);
	const char *points = o->n_points > 0 ? o->points[0] : "scene.json";
	const char *quote = *params == '[' ? "'" : "";

	if (*params == '{' || (*params == '\0' && !is_numbers(o->params)))
		return;
	if (o->n_points > 0 ? *glance(points, second) != '{' :
			      strpbrk(params, "{[\"") != NULL)
		return;
	if (first_char(points) == '{')
		points = "'{...}'";
	die(EXIT_USAGE,
	    "'%s' holds points, and the scene comes first; write projcalc %s "
	    "%s %s%s%s",
	    o->params, c->name, points, quote, o->params, quote);
}

/* JSON that the shell has taken apart: {"eye": [0,0,5]} without quotes. */
static bool is_torn(const struct options *o)
{
	if (strchr(o->params, '}') != NULL)
		return false;
	for (int i = 0; i < o->n_points; i++)
		if (strchr(o->points[i], '}') != NULL)
			return true;
	return false;
}

void mistaken_params(const struct command *c, const struct options *o)
{
	const char *name = o->params;
	bool typed = first_char(name) == '{';

	if (is_stdin(name) || (typed && !is_torn(o)))
		return;
	if (!typed && access(name, F_OK) == 0) {
		check_traded(c, o);
		return;
	}
	if (is_numbers(name) && o->n_points > 0)
		check_traded(c, o);
	if (typed || is_numbers(name) || strpbrk(name, "\":{=") != NULL ||
	    strcmp(name, "help") == 0)
		die(EXIT_USAGE,
		    "'%s' is no scene; PARAMS is a JSON file, - or JSON in "
		    "quotes: projcalc %s %s",
		    name, c->name, c->example != NULL ? c->example : "'{...}'");
}

void mistaken_points(const struct options *o, int i)
{
	const char *name = o->points[i];
	const struct place place = { .file = name };
	struct stat st;
	char list[200] = "";
	size_t at = 0;

	if (stat(name, &st) == 0 && S_ISDIR(st.st_mode))
		die_at(EXIT_USAGE, &place, "is a directory");
	if (access(name, R_OK) == 0)
		return;
	const char *why = strerror(errno);

	for (; i < o->n_points && is_numbers(o->points[i]); i++)
		at = add_numbers(list, at, sizeof list, o->points[i]);
	if (at > 0)
		die_at(EXIT_USAGE, &place, "%s; POINTS are a file, - or '[%s]'",
		    why, list);
	if (strpbrk(name, "{\"") != NULL)
		die_at(EXIT_USAGE, &place,
		    "%s; POINTS are a file, - or '[0,0,0]'", why);
	die_at(EXIT_USAGE, &place, "%s", why);
}
