/* SPDX-License-Identifier: MIT */
#include "unknown.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "../message/message.h"
#include "../message/words.h"
#include "../scene/types.h"
#include "input.h"
#include "option_row.h"

/* Returns a member called `name`, or NULL. Searches the members of a scene that have bits
 * in `objects`, from the last to the first, and the members of each: by `passes` first
 * for one letter, then for the next. n is a name that objects of `variant` have, a an
 * alias, N and A are those of any variant. Sets *object as unknown_find_member does. */
static const struct member *find_member(unsigned objects, int variant, const char *name,
    const char *passes, const struct member **object)
{
	for (; *passes != '\0'; passes++) {
		const bool any = strchr("NA", *passes) != NULL;
		const bool alias = strchr("aA", *passes) != NULL;

		for (int k = 31; k >= 0; k--) {
			if ((objects >> k & 1) == 0)
				continue;
			const struct member *s = *object = &scene_members[k];
			const struct member *m = member_named(scene_members,
			    ANY_VARIANT, name, alias);

			if (m != s)
				m = member_named(s->members,
				    any ? ANY_VARIANT : variant, name, alias);
			if (m != NULL)
				return m;
		}
	}
	return NULL;
}

const struct member *unknown_find_member(const char *name, const struct member **object)
{
	return find_member(SCENE_ALL, 0, name, "nNaA", object);
}

/* Offers what find_member finds, by the example of its object if that has the member,
 * else by a topic of help. `reads` are the scene's members that the command reads. */
static void offer_member(struct word_guess *g, unsigned objects, int variant,
    const char *passes, unsigned reads)
{
	const struct member *s, *m = find_member(objects, variant, g->word, passes, &s);
	char says[128], quoted[64];

	if (m == NULL)
		return;
	snprintf(quoted, sizeof quoted, "\"%s\"", m->name);
	snprintf(says, sizeof says, "%s is a member of the %s %s", quoted,
	    m == s ? "scene" : s->name,
	    reads >> (s - scene_members) & 1 ? "in PARAMS" : "for other commands");
	if (s->example != NULL && (m == s || strstr(s->example, quoted) != NULL))
		word_offer(g, WORD_KNOWN, "%s: '{\"%s\": %s}'", says, s->name,
		    s->example);
	else
		word_offer(g, WORD_KNOWN, "%s; 'projcalc help %s' describes it", says,
		    s->name);
}

/* Offers a hint of word_hint. If the hint is an option, and c lacks it or is NULL, says
 * which commands take the option. */
static void offer_hint(struct word_guess *g, const struct command *c, const char *hint)
{
	/* in the order of the bits of enum command_kind */
	static const char *const names[] = { "the 3D matrix commands", "project",
		"pick", "fit", "inspect", "trace", "the 2D commands", "help" };
	enum { KINDS = sizeof names / sizeof *names };
	const char *takers[KINDS + 1] = { NULL };
	const size_t n = strcspn(hint, "*");
	char list[LIST_ROOM], call[LIST_ROOM];
	int count = 0;

	_Static_assert(1 << KINDS == COMMAND_ALL + 1, "each kind has a name");
	snprintf(call, sizeof call, "%.*s%s", (int)n, hint,
	    hint[n] == '*' ? g->word : "");
	const struct option_row *r = option_find(call + 2);

	for (unsigned i = 0; r != NULL && i < KINDS; i++)
		if (r->kinds >> i & 1)
			takers[count++] = names[i];
	if (*hint == ':')
		word_offer(g, WORD_KNOWN, "%s", hint + 2);
	else if (*hint != '-')
		word_offer(g, WORD_KNOWN, "did you mean 'projcalc %s'?", call);
	else if (option_is_for(r, c))
		word_offer(g, WORD_KNOWN, "did you mean %s?", call);
	else
		word_offer(g, WORD_KNOWN, "%s is an option of %s", call,
		    words_join(list, takers, " and ", ""));
}

/* Offers options, members and hints that g->word names, the likeliest first. The user
 * typed it as an option of c or, if c is NULL, as a command or a topic. */
static void offer_known(struct word_guess *g, const struct command *c)
{
	static const struct document_wants nothing;
	const struct document_wants *w = c != NULL ? &c->wants : &nothing;
	const unsigned reads = c != NULL ? document_used_members(w) : 0;
	const enum word_place place = c != NULL ? WORD_OPTION : WORD_COMMAND;
	const struct option_row *r = option_find(g->word);
	const char *option = word_hint(g->word, place, '-');
	const char *hint = word_hint(g->word, place, '\0');
	/* if an option has the name, searches no aliases, and not SCENE_SPATIAL: in a
	 * call of project, --at is more likely the option of pick than camera.at */
	const char *passes = r == NULL ? "na" : "n";
	const unsigned other = r == NULL ? reads : reads & ~(unsigned)SCENE_SPATIAL;
	/* searches the members of persp if the command implies no type of projection */
	const int type = (int)w->source.implied_type, variant = type - (type > 0);

	const char *remark = word_hint(g->word, place, ':');
	const struct member *s;

	if (option_is_for(r, c))
		offer_hint(g, c, "--*");
	/* of members only a name is likelier than a remark */
	if (remark != NULL && find_member(reads, ANY_VARIANT, g->word, "n", &s) == NULL)
		offer_hint(g, c, remark);
	if (option != NULL && option_is_for(option_find(option + 2), c))
		offer_hint(g, c, option);
	offer_member(g, w->lone_member, variant, passes, reads);
	/* a hint leads further than a step's operation of the same name */
	offer_member(g, hint != NULL ? other & ~(unsigned)SCENE_WORLD : other, variant,
	    passes, reads);
	if (hint != NULL)
		offer_hint(g, c, hint);
	if (r != NULL)
		offer_hint(g, c, "--*");
	offer_member(g, SCENE_ALL, 0, "nNaA", c != NULL ? reads : SCENE_ALL);
}

void unknown_check_option(const struct command *c, const char *word, const char *name,
    bool is_unknown)
{
	struct word_guess g = { .word = name };

	/* one letter that no option has is too short to be looked up as a member */
	if (word[2] != '\0' || strcmp(word + 1, name) != 0)
		offer_known(&g, c);
	if (g.closeness == 0 && !is_unknown)
		return;
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (option_is_for(r, c))
			word_offer(&g, word_closeness(name, r->name),
			    "did you mean --%s?", r->name);
	word_offer(&g, WORD_ELSE, "'projcalc help %s' lists them", c->name);
	die(EXIT_USAGE, "%s: unknown option %s; %s", c->name, word, g.remedy);
}

static void offer_near(struct word_guess *g, const char *help, const char *name)
{
	word_offer(g, word_closeness(g->word, name), "did you mean 'projcalc %s%s'?",
	    help, name);
}

void unknown_refuse_command(const struct command *commands, bool topic,
    const char *word)
{
	const char first = input_first_char(word);
	const bool option = *word == '-' &&
	    (word[1] != '-' || option_find(word + 2) != NULL);
	/* `word` looks like an option or operand, which has to follow a command */
	const bool early = !topic &&
	    (word_hint(word, WORD_COMMAND, '\0') == NULL ||
		(*word == '-' && word[1] != '-')) &&
	    (option || first == '{' || first == '[' || strpbrk(word, "./") != NULL ||
		access(word, R_OK) == 0);
	const char *const help = topic ? "help " : "";
	struct word_guess g = { .word = word };
	const struct member *s, *m;

	if (early)
		die(EXIT_USAGE,
		    "unknown command '%.400s'; a command comes first, such as project "
		    "or lookat; 'projcalc help' lists commands",
		    word);
	offer_known(&g, NULL);
	offer_near(&g, help, "--help");
	offer_near(&g, help, "--version");
	for (const struct command *c = commands; c->name != NULL; c++)
		offer_near(&g, help, c->name);
	for (s = scene_members; s->name != NULL; s++) {
		offer_near(&g, "help ", s->name);
		for (m = s->members; m != NULL && m->name != NULL; m++)
			offer_near(&g, "help ", m->name);
	}
	word_offer(&g, WORD_ELSE, "'projcalc help' lists commands%s",
	    topic ? ", and 'projcalc help scene' members" : "");
	die(EXIT_USAGE, "unknown %s '%.400s'; %s", topic ? "topic" : "command", word,
	    g.remedy);
}
