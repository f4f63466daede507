/* SPDX-License-Identifier: MIT */
/* Options that are none: members of a scene, and what others call options. */
#include <stdio.h>
#include <string.h>

#include "../message/escape.h"
#include "mistaken.h"
#include "../scene/members.h"
#include "../message/message.h"
#include "typed.h"

enum { VALUE_MAX = 200 };

/* Writes what was meant for a member's value as JSON, or what may stand there where
 * that is nothing, or too long to be shown. */
static void write_value(char out[VALUE_MAX], const struct member *m,
    const char *text)
{
	/* so that no number is left out of one that is short enough */
	char list[2 * VALUE_MAX] = "";

	snprintf(out, VALUE_MAX, "%s", m->example != NULL ? m->example : "...");
	if (m->type == &type_flag)
		strcpy(out, strcmp(text, "false") == 0 ? "false" : "true");
	else if (*text == '\0')
		return;
	else if (strchr("[{", *text) != NULL)
		snprintf(out, VALUE_MAX, "%s", text);
	else if (!is_numbers(text)) {
		escape_json(list, VALUE_MAX - 4, text, strlen(text));
		snprintf(out, VALUE_MAX, "\"%.*s\"", VALUE_MAX - 4, list);
	} else if (add_numbers(list, 0, sizeof list, text) < VALUE_MAX - 2)
		snprintf(out, VALUE_MAX,
		    strchr(list, ',') != NULL ? "[%.*s]" : "%.*s",
		    VALUE_MAX - 3, list);
}

/* The name in an option, "--eye=0,0,5" or "-eye". */
static void name_of(char out[64], const char *word)
{
	word += strspn(word, "-");
	snprintf(out, 64, "%.*s", (int)strcspn(word, "="), word);
}

/* Whether a word behind an option may be its value: JSON, or a word, which the name of
 * a file, such as scene.json, is not. */
static bool is_value(const struct member *m, const char *word)
{
	if (m->type == &type_flag)
		return strcmp(word, "true") == 0 || strcmp(word, "false") == 0;
	return strchr("[{", *word) != NULL ||
	    (*word != '-' && strpbrk(word, "./ ") == NULL);
}

/* What is too long to be shown is left out. */
static void copy(char out[VALUE_MAX], const char *text)
{
	strcpy(out, strlen(text) < VALUE_MAX ? text : "");
}

/* The text behind it: after =, or the next word, or as many as are of numbers.
 * Returns where the words go on. */
static char **text_of(char out[VALUE_MAX], const struct member *m, char **words)
{
	const char *equals = strchr(*words++, '=');
	size_t at = 0;

	copy(out, equals != NULL ? equals + 1 : "");
	if (equals != NULL || *words == NULL)
		return words;
	if (m->type == &type_flag || !is_numbers(*words)) {
		if (is_value(m, *words))
			copy(out, *words++);
	} else {
		while (*words != NULL && is_numbers(*words))
			at = add_numbers(out, at, VALUE_MAX, *words++);
	}
	return words;
}

/* The member that is called so, or where aliases is true is so by others, in one of
 * the objects that bits are; or such an object itself. A projection's is one of that
 * kind. The later object has it rather: the viewport its width, the projection has
 * another. */
static const struct member *find_in(unsigned bits, int kind, const char *name,
    bool aliases, const struct member **object)
{
	for (int k = 31; k >= 0; k--) {
		const struct member *s = *object = &scene_members[k], *m;

		if ((bits >> k & 1) == 0)
			continue;
		if (strcmp(name, s->name) == 0 ||
		    (aliases &&
			s == member_named(scene_members, ANY_KIND, name)))
			return s;
		m = s->members == NULL ? NULL :
		    aliases            ? member_named(s->members, kind, name) :
					 member_of(s->members, kind, name);
		if (m != NULL)
			return m;
	}
	return NULL;
}

/* Finds a member of that name: in the object that the command reads alone; in others
 * that it reads; and, where that need not be its exact name, in the camera, which is
 * what others give options for, and then anywhere. *object is the scene's member
 * that has it, or is it. */
static const struct member *find(const struct command *c, const char *name,
    bool exact, const struct member **object)
{
	const struct document_wants *w = &c->wants;
	/* project --at is rather meant for pick than for the camera */
	const unsigned used = w->used & ~(exact ? (unsigned)SCENE_SPATIAL : 0u);
	const int own = w->projection > 0 ? w->projection - 1 : 0;
	const struct {
		unsigned bits;
		int kind;
	} tries[] = { { w->bare, own }, { used, own },
		{ document_reads(w), own }, { SCENE_CAMERA, own },
		{ SCENE_SPATIAL, own }, { used, ANY_KIND },
		{ SCENE_ALL, ANY_KIND } };
	const struct member *m = NULL;

	for (int i = 0; m == NULL && i < (exact ? 2 : 7); i++)
		for (int aliases = 0; m == NULL && aliases < 2 - exact;
		     aliases++)
			m = find_in(tries[i].bits, tries[i].kind, name, aliases,
			    object);
	return m;
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
		words = text_of(text, m, words);
		write_value(value, m, text);
		if (at < room)
			at += (size_t)snprintf(out + at, room - at,
			    "%s\"%s\": %s", n > 0 ? ", " : "", m->name, value);
	}
	if ((n == 1 || (*words != NULL && **words == '-')) && at < room)
		snprintf(out + at, room - at, ", ...");
}

/* Refuses a member of the scene whose value is the name of a file. */
static void check_file(const struct command *c, char **words,
    const struct member *m)
{
	const char *equals = strchr(*words, '=');
	const char *file = equals != NULL ? equals + 1 : words[1];
	const int n = (int)strcspn(*words, "=");

	if (file == NULL || strchr("-[{", *file) != NULL || is_numbers(file) ||
	    strpbrk(file, "./") == NULL)
		return;
	if (c->wants.bare >> (m - scene_members) & 1)
		die(EXIT_USAGE,
		    "%s: unknown option %.*s; it stands alone: projcalc %s %s",
		    c->name, n, *words, c->name, file);
	die(EXIT_USAGE,
	    "%s: unknown option %.*s; \"%s\" is a member of the scene, as jq "
	    "'{%s: .}' %s writes it",
	    c->name, n, *words, m->name, m->name, file);
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
	if ((document_reads(&c->wants) & bit) == 0)
		die(EXIT_USAGE,
		    "%s: unknown option %.*s%s; \"%s\" is a member of the %s "
		    "that %s does not read; 'projcalc help %s' tells of it",
		    c->name, dashes, *words, name, m->name,
		    m == object ? "scene" : object->name, c->name,
		    object->name);
	if (m == object)
		check_file(c, words, m);
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
		{ "delimiter", "separator" },
	};

	for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
		if (strcmp(pairs[i][0], name) == 0)
			return pairs[i][1];
	return NULL;
}
