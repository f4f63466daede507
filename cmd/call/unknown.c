/* SPDX-License-Identifier: MIT */
#include "unknown.h"

#include <string.h>
#include <unistd.h>

#include "../message/message.h"
#include "../message/utf8.h"
#include "../message/words.h"
#include "input.h"
#include "option_row.h"

const struct member *unknown_find_member(const char *name, const struct member **object)
{
	*object = member_named(scene_members, 0, name);
	if (*object != NULL)
		return *object;
	for (int pass = 0; pass < 3; pass++)
		for (int k = SCENE_ROWS - 1; k >= 0; k--) {
			const struct member *m = member_named(scene_members[k].members,
			    pass == 0 ? 0 : ANY_VARIANT, name);

			*object = &scene_members[k];
			if (m != NULL && (pass == 2 || word_equals(m->name, name)))
				return m;
		}
	return NULL;
}

/* Returns the remark on a word, or NULL. */
static const char *remark_text(const char *word, enum word_place place)
{
	const struct remark *remark = word_remark(word, place, NULL);

	return remark != NULL ? remark->text : NULL;
}

/* Returns what to write instead of `name`, an option that c, which may be NULL, lacks:
 * an option of c, or one that other commands take; or NULL. */
static const char *find_option(const struct command *c, const char *name)
{
	/* in the order of the bits of enum command_kind */
	static const char *const kinds[] = { "the 3D matrix commands", "project",
		"pick", "fit", "inspect", "trace", "the 2D commands", "draw", "help" };
	enum { KINDS = sizeof kinds / sizeof *kinds };
	const struct option_row *r = option_find(name);
	const char *takers[KINDS + 1] = { NULL };
	char list[LIST_ROOM];
	int n = 0;

	_Static_assert(1 << KINDS == COMMAND_ALL + 1, "each kind has a name");
	if (r == NULL)
		return NULL;
	if (option_is_for(r, c))
		return text("did you mean --%s?", r->name);
	for (unsigned i = 0; i < KINDS; i++)
		if (r->kinds >> i & 1)
			takers[n++] = kinds[i];
	return text("--%s is an option of %s%s", r->name,
	    words_join(list, takers, " and ", ""),
	    strcmp(r->name, "output") == 0 ? "; > writes a file" : "");
}

/* Returns where `name`, which is no option, belongs as a member of a scene; or NULL. */
static const char *find_member(const char *name)
{
	const struct member *object, *m = unknown_find_member(name, &object);

	if (m == NULL)
		return NULL;
	return text(
	    "\"%s\" is a member of the %s in PARAMS; 'projcalc help %s' describes it",
	    m->name, m == object ? "scene" : object->name, object->name);
}

void unknown_check_option(const struct command *c, const char *word, const char *name,
    bool is_unknown)
{
	const char *names[OPTIONS_MAX + 1], *remedy = NULL;
	int n = 0;

	/* one letter that no option has is too short to be looked up */
	if (word[2] != '\0' || strcmp(word + 1, name) != 0) {
		if (option_is_for(option_find(name), c))
			remedy = find_option(c, name);
		if (remedy == NULL)
			remedy = remark_text(name, WORD_OPTION);
		if (remedy == NULL)
			remedy = find_option(c, name);
		if (remedy == NULL)
			remedy = find_member(name);
	}
	if (remedy == NULL && !is_unknown)
		return;
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (option_is_for(r, c))
			names[n++] = r->name;
	names[n] = NULL;
	const char *near = word_nearest(name, names, NULL);

	if (remedy == NULL)
		remedy = near != NULL ? text("did you mean --%s?", near) :
					text("'projcalc help %s' lists them", c->name);
	die(EXIT_USAGE, text("%s: unknown option %s", c->name, word), remedy);
}

/* Returns the command or topic that is nearest to a word, as a remedy; or NULL. */
static const char *find_near(const struct command *commands, bool topic,
    const char *word)
{
	enum { NAMES_MAX = 256 };
	const char *names[NAMES_MAX + 1] = { "--help", "--version" }, *near;
	int n = 2;

	for (const struct command *c = commands; c->name != NULL && n < NAMES_MAX; c++)
		names[n++] = c->name;
	names[n] = NULL;
	near = word_nearest(word, names, NULL);
	if (near != NULL)
		return text("did you mean 'projcalc %s%s'?", topic ? "help " : "",
		    near);
	n = 0;
	for (const struct member *s = scene_members; s->name != NULL; s++) {
		if (n < NAMES_MAX)
			names[n++] = s->name;
		for (const struct member *m = s->members;
		     m != NULL && m->name != NULL && n < NAMES_MAX; m++)
			names[n++] = m->name;
	}
	names[n] = NULL;
	near = word_nearest(word, names, NULL);
	return near != NULL ? text("did you mean 'projcalc help %s'?", near) : NULL;
}

void unknown_refuse_command(const struct command *commands, bool topic,
    const char *word)
{
	const char first = input_first_char(word);
	const bool option = *word == '-' &&
	    (word[1] != '-' || option_find(word + 2) != NULL);
	const char *remedy = remark_text(word, WORD_COMMAND);

	/* `word` looks like an option or operand, which has to follow a command */
	if (!topic && remedy == NULL &&
	    (option || first == '{' || first == '[' || strpbrk(word, "./") != NULL ||
		access(word, R_OK) == 0))
		die(EXIT_USAGE,
		    text("unknown command '%.*s'", (int)utf8_fit(word, 400), word),
		    "a command comes first, such as project or lookat; 'projcalc help' "
		    "lists commands");
	if (remedy == NULL)
		remedy = find_option(NULL, word);
	if (remedy == NULL)
		remedy = find_member(word);
	if (remedy == NULL)
		remedy = find_near(commands, topic, word);
	if (remedy == NULL)
		remedy = topic ? "'projcalc help' lists commands, and 'projcalc help "
				 "scene' members" :
				 "'projcalc help' lists commands";
	die(EXIT_USAGE,
	    text("unknown %s '%.*s'", topic ? "topic" : "command",
		(int)utf8_fit(word, 400), word),
	    remedy);
}
