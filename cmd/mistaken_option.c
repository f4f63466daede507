/* SPDX-License-Identifier: MIT */
/* Options that are none: members of a scene, and what others call options. */
#include <stdio.h>
#include <string.h>

#include "mistaken.h"
#include "scene/members.h"
#include "talk.h"
#include "typed.h"

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
	/* project --at is rather meant for pick than for the camera */
	const unsigned bits[] = { c->wants.bare,
		c->wants.used & (exact ? ~(unsigned)SCENE_SPATIAL : ~0u), ~0u };
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
