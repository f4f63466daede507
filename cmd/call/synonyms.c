/* SPDX-License-Identifier: MIT */
#include "synonyms.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "../message/message.h"
#include "../message/words.h"
#include "input.h"
#include "option_row.h"
#include "../scene/members.h"

enum {
	NAMES_MAX = 240,    /* commands, members, and members of members */
	UNKNOWN_ROOM = 512, /* bytes for "unknown command ..." */
	QUOTED_ROOM = 64,   /* bytes for a member's name in quotes */
};

/* Returns the member called `name`; if there is none and `aliases` is true, a member
 * with the alias `name`; else NULL. Searches the members of a scene that have bits in
 * `objects`, from the last to the first, and the members of each that objects of `variant`
 * have. Sets *object as synonym_find does. */
static const struct member *find_member(unsigned objects, int variant,
    const char *name, bool aliases, const struct member **object)
{
	for (int alias = 0; alias < (aliases ? 2 : 1); alias++)
		for (int k = 31; k >= 0; k--) {
			if ((objects >> k & 1) == 0)
				continue;
			const struct member *s = *object = &scene_members[k];
			const struct member *m = member_named(scene_members,
			    ANY_VARIANT, name, alias);

			if (m != s)
				m = member_named(s->members, variant, name,
				    alias);
			if (m != NULL)
				return m;
		}
	return NULL;
}

const struct member *synonym_find(const char *name,
    const struct member **object)
{
	const struct member *m = NULL;

	/* prefers a name to an alias, and projections of variant 0 (persp) to others */
	for (int i = 0; i < 4 && m == NULL; i++)
		m = find_member(SCENE_ALL, i % 2 == 0 ? 0 : ANY_VARIANT, name,
		    i >= 2, object);
	return m;
}

/* Refuses a word that means m. `object` is a member of the scene, and m is `object` or
 * one of its members. The message begins with `unknown` ("unknown topic 'eye'"). It
 * shows object->example if it has m or m is `object`, else the topic of help about it.
 * `reads` has, as bits, the members of the scene that the command reads. */
static _Noreturn void refuse_member(const char *unknown, unsigned reads,
    const struct member *m, const struct member *object)
{
	const char *of = m == object ? "scene" : object->name;
	const char *where = reads >> (object - scene_members) & 1 ?
	    "in PARAMS" :
	    "for other commands";
	char quoted[QUOTED_ROOM];

	snprintf(quoted, sizeof quoted, "\"%s\"", m->name);
	if (object->example == NULL ||
	    (m != object && strstr(object->example, quoted) == NULL))
		die(EXIT_USAGE,
		    "%s; %s is a member of the %s %s; 'projcalc help %s' "
		    "describes it",
		    unknown, quoted, of, where, object->name);
	die(EXIT_USAGE, "%s; %s is a member of the %s %s: '{\"%s\": %s}'",
	    unknown, quoted, of, where, object->name, object->example);
}

/* Writes to `list` which commands take an option: "fit and trace". Returns `list`. */
static const char *option_takers(const struct option_row *r,
    char list[LIST_ROOM])
{
	/* in the order of the bits of enum command_kind */
	static const char *const names[] = { "the 3D matrix commands",
		"project", "pick", "fit", "inspect", "trace", "the 2D commands",
		"help" };
	const char *takers[sizeof names / sizeof *names + 1] = { NULL };
	int n = 0;

	for (unsigned i = 0; i < sizeof names / sizeof *names; i++)
		if (r->kinds >> i & 1)
			takers[n++] = names[i];
	return join_words(list, takers, " and ", "");
}

/* Refuses `name`. The message is `unknown`, then `hint`, a text like those that
 * word_hint returns. If the hint is an option, and c lacks it or is NULL, the message
 * lists the commands that take the option. */
static _Noreturn void refuse_synonym(const struct command *c,
    const char *unknown, const char *name, const char *hint)
{
	const size_t n = strcspn(hint, "*");
	char list[LIST_ROOM], call[LIST_ROOM];

	if (*hint == ':')
		die(EXIT_USAGE, "%s; %s", unknown, hint + 2);
	snprintf(call, sizeof call, "%.*s%s", (int)n, hint,
	    hint[n] == '*' ? name : "");
	if (*hint != '-')
		die(EXIT_USAGE, "%s; did you mean 'projcalc %s'?", unknown,
		    call);
	const struct option_row *r = option_find(call + 2);

	if (option_is_for(r, c))
		die(EXIT_USAGE, "%s; did you mean %s?", unknown, call);
	die(EXIT_USAGE, "%s; %s is an option of %s", unknown, call,
	    option_takers(r, list));
}

/* Refuses `name` if it means an option or a member, or if word_hint has a hint for it.
 * The user typed it as an option of c or, if c is NULL, as a command or a topic. */
static void refuse_known_word(const struct command *c, const char *unknown,
    const char *name)
{
	static const struct document_wants nothing;
	const struct document_wants *w = c != NULL ? &c->wants : &nothing;
	const unsigned reads = c != NULL ? document_used_members(w) : 0;
	const struct option_row *r = option_find(name);
	/* skips SCENE_SPATIAL if an option has the name: in a call of project, --at is
	 * more likely meant as the option of pick than as camera.at */
	const unsigned objects[] = { w->lone_member,
		reads & ~(r != NULL ? SCENE_SPATIAL : 0u) };
	/* searches the members of persp if the command implies no type of projection */
	const int type = (int)w->source.implied_type,
		  variant = type > 0 ? type - 1 : 0;
	const struct member *m, *object;
	const char *hint;

	if (option_is_for(r, c))
		refuse_synonym(c, unknown, r->name, "--*");
	hint = word_hint(name, '-');
	if (hint != NULL && option_is_for(option_find(hint + 2), c))
		refuse_synonym(c, unknown, name, hint);
	/* searches aliases, too, unless an option has the name */
	for (int i = 0; i < 2; i++) {
		m = find_member(objects[i], variant, name, r == NULL, &object);
		if (m != NULL)
			refuse_member(unknown, reads, m, object);
	}
	hint = word_hint(name, '\0');
	if (hint != NULL)
		refuse_synonym(c, unknown, name, hint);
	if (r != NULL)
		refuse_synonym(c, unknown, r->name, "--*");
	m = synonym_find(name, &object);
	if (m != NULL)
		refuse_member(unknown, c != NULL ? reads : SCENE_ALL, m,
		    object);
}

void synonym_check_option(const struct command *c, const char *option,
    const char *name)
{
	char unknown[UNKNOWN_ROOM];

	snprintf(unknown, sizeof unknown, "%s: unknown option %s", c->name,
	    option);
	refuse_known_word(c, unknown, name);
}

/* Returns the command, member, "--help" or "--version" nearest to `word`; or NULL. */
static const char *nearest_known(const struct command *commands,
    const char *word)
{
	const char *names[NAMES_MAX + 1] = { "--help", "--version" };
	int n = 2;

	for (const struct command *c = commands; c->name != NULL; c++)
		names[n++] = c->name;
	for (const struct member *s = scene_members; s->name != NULL; s++) {
		names[n++] = s->name;
		for (const struct member *m = s->members;
		     m != NULL && m->name != NULL && n < NAMES_MAX; m++)
			names[n++] = m->name;
	}
	names[n] = NULL;
	return word_nearest(word, names);
}

void synonym_refuse_word(const struct command *commands, bool topic,
    const char *word)
{
	const char first = input_first_char(word), *near = NULL;
	const bool option = *word == '-' &&
	    (word[1] != '-' || option_find(word + 2) != NULL);
	/* `word` looks like an option or operand, which has to follow a command */
	const bool early = !topic &&
	    (option || first == '{' || first == '[' ||
		strpbrk(word, "./") != NULL || access(word, R_OK) == 0);
	char unknown[UNKNOWN_ROOM];

	snprintf(unknown, sizeof unknown, "unknown %s '%.400s'",
	    topic ? "topic" : "command", word);
	if (!early) {
		refuse_known_word(NULL, unknown, word);
		near = nearest_known(commands, word);
	}
	if (near != NULL && *near != '-' &&
	    command_find(commands, near) == NULL)
		topic = true;
	if (near != NULL)
		die(EXIT_USAGE, "%s; did you mean 'projcalc %s%s'?", unknown,
		    topic ? "help " : "", near);
	die(EXIT_USAGE, "%s; %s'projcalc help' lists commands%s", unknown,
	    early ? "a command comes first, such as project or lookat; " : "",
	    topic ? ", and 'projcalc help scene' members" : "");
}
