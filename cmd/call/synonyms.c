/* SPDX-License-Identifier: MIT */
#include "synonyms.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "input.h"
#include "../message/message.h"
#include "../message/nearest.h"
#include "../scene/members.h"

/* What others call by a word: an option, "--jobs"; a remark, ": ..."; or a call.
 * What others call a member stands in the tables of members. */
static const struct synonym {
	const char *word, *is;
} synonyms[] = {
	{ "unproject", "project --from device --to world" },
	{ "backproject", "project --from device --to world" },
	{ "inverse", "project --from device --to world" },
	{ "invert", "project --from device --to world" },
	{ "ray", "project --ray" },
	{ "raycast", "project --ray" },
	{ "transform", "project" },
	{ "points", "project" },
	{ "mvp", "project -m --to clip" },
	{ "matrix", "project -m --to clip" },
	{ "pose", "project -m --from view --to world" },
	{ "viewport", "project --from ndc --to device" },
	{ "camera", "lookat" },
	{ "view", "lookat" },
	{ "lookat", "lookat" },
	{ "look_at", "lookat" },
	{ "look-at", "lookat" },
	{ "perspective", "persp" },
	{ "projection", "persp" },
	{ "frustum",
	    ": persp makes one of its left, right, bottom, top, near and far, "
	    "and inspect tells of one" },
	{ "orthographic", "ortho" },
	{ "cavalier", "oblique" },
	{ "cabinet", "oblique" },
	{ "window", "w2n" },
	{ "device", "n2d" },
	{ "bounds", "fit" },
	{ "zoom", "fit" },
	{ "extent", "fit" },
	{ "info", "inspect" },
	{ "click", "pick" },
	{ "explain", "trace" },
	{ "usage", "help" },
	{ "man", "help" },

	{ "format", "--output" },
	{ "json", "--output json" },
	{ "csv", "--input csv" },
	{ "delimiter", "--separator" },
	{ "cols", "--columns" },
	{ "space", "--to" },
	{ "threads", "--jobs" },
	{ "round", "--decimals" },
	{ "places", "--decimals" },
	{ "epsilon", "--tolerance" },
	{ "cull", "--visible" },
	{ "verbose", "--progress" },
	{ "convert", "--convention gl" },
	{ "gl", "--convention gl" },
	{ "opengl", "--convention gl" },
	{ "d3d", "--convention d3d" },
	{ "directx", "--convention d3d" },
	{ "vulkan", "--convention vulkan" },
	{ "webgpu", "--convention webgpu" },
	{ "opencv", "--convention opencv" },

	{ "distortion", ": lenses are not modelled; undistort points first" },
	{ "undistort", ": lenses are not modelled; undistort points first" },
	{ "lens", ": lenses are not modelled; undistort points first" },
	{ "k1", ": lenses are not modelled; undistort points first" },
	{ "stdin", ": standard input is - in place of PARAMS or POINTS" },
	{ "quiet", ": notes go to standard error; 2>/dev/null hides them" },
};

enum {
	SYNONYMS = sizeof synonyms / sizeof *synonyms,
	NAMES_MAX = 240, /* of commands, members of a scene, and theirs */
	UNKNOWN_MAX = 512,
	NAME_SHOWN = 64,
};

/* Returns the member of that name, or that has that alias, in one of the objects that
 * bits are; or such an object itself; or NULL. */
static const struct member *find_member(unsigned bits, int kind,
    const char *name, bool alias, const struct member **object)
{
	const struct member *(*find)(const struct member *, int,
	    const char *) = alias ? member_named : member_of;

	for (int k = 31; k >= 0; k--) {
		const struct member *s = *object = &scene_members[k], *m;

		if ((bits >> k & 1) == 0)
			continue;
		if (find(scene_members, ANY_KIND, name) == s)
			return s;
		m = s->members != NULL ? find(s->members, kind, name) : NULL;
		if (m != NULL)
			return m;
	}
	return NULL;
}

const struct member *synonym_find(const char *name,
    const struct member **object)
{
	const struct member *m = NULL;

	for (int i = 0; i < 4 && m == NULL; i++)
		m = find_member(SCENE_ALL, i % 2 == 0 ? 0 : ANY_KIND, name,
		    i >= 2, object);
	return m;
}

/* Refuses a word, which unknown says, that is a member: shows how it is written where
 * its object's example has it. */
static _Noreturn void refuse_member(const char *unknown, unsigned reads,
    const struct member *m, const struct member *object)
{
	const char *of = m == object ? "scene" : object->name;
	const char *where = reads >> (object - scene_members) & 1 ?
	    "in PARAMS" :
	    "for other commands";
	char quoted[NAME_SHOWN];

	snprintf(quoted, sizeof quoted, "\"%s\"", m->name);
	if (object->example == NULL ||
	    (m != object && strstr(object->example, quoted) == NULL))
		die(EXIT_USAGE,
		    "%s; %s is a member of the %s %s; 'projcalc help %s' "
		    "tells of it",
		    unknown, quoted, of, where, object->name);
	die(EXIT_USAGE, "%s; %s is a member of the %s %s: '{\"%s\": %s}'",
	    unknown, quoted, of, where, object->name, object->example);
}

/* Refuses the word by what it is called here. An option of other commands than c, or
 * where that is NULL of any, is told with its commands. */
static _Noreturn void refuse_by(const struct command *c, const char *unknown,
    const char *is)
{
	const struct option_row *r = *is == '-' ? option_named(is + 2) : NULL;
	char list[LISTED];

	if (*is == ':')
		die(EXIT_USAGE, "%s; %s", unknown, is + 2);
	if (r != NULL && c != NULL && option_is_for(r, c))
		die(EXIT_USAGE, "%s; did you mean %s?", unknown, is);
	if (r != NULL)
		die(EXIT_USAGE, "%s; %s is an option of %s", unknown, is,
		    option_takers(r, list));
	die(EXIT_USAGE, "%s; did you mean 'projcalc %s'?", unknown, is);
}

static void try_rows(const struct command *c, const char *unknown,
    const char *name)
{
	for (int i = 0; i < SYNONYMS; i++)
		if (strcasecmp(synonyms[i].word, name) == 0)
			refuse_by(c, unknown, synonyms[i].is);
}

/* Refuses an option that is a member of objects that bits are; or an alias, where
 * aliases is true. */
static void try_members(const struct command *c, const char *unknown,
    unsigned bits, bool aliases, const char *name)
{
	/* of a projection that is any, persp is the usual kind */
	const int own = c->wants.projection > 0 ? c->wants.projection - 1 : 0;
	const struct member *m, *object;

	for (int alias = 0; alias < (aliases ? 2 : 1); alias++) {
		m = find_member(bits, own, name, alias, &object);
		if (m != NULL)
			refuse_member(unknown, bits, m, object);
	}
}

void synonym_option(const struct command *c, const char *option, bool elsewhere)
{
	/* project --at is rather meant for pick than for the camera */
	const unsigned reads = document_reads(&c->wants) &
	    (elsewhere ? ~(unsigned)SCENE_SPATIAL : ~0u);
	const char *word = option + strspn(option, "-");
	const struct member *m, *object;
	char name[NAME_SHOWN], unknown[UNKNOWN_MAX];

	snprintf(unknown, sizeof unknown, "%s: unknown option %.*s", c->name,
	    (int)strcspn(option, "="), option);
	snprintf(name, sizeof name, "%.*s", (int)strcspn(word, "="), word);
	try_members(c, unknown, c->wants.bare, !elsewhere, name);
	try_members(c, unknown, reads, !elsewhere, name);
	try_rows(c, unknown, name);
	m = elsewhere ? NULL : synonym_find(name, &object);
	if (m != NULL)
		refuse_member(unknown, reads, m, object);
}

/* Returns the nearest of all commands and members, or NULL. */
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
	return nearest_word(word, names);
}

void synonym_word(const struct command *commands, bool topic, const char *word)
{
	const char *near = nearest_known(commands, word);
	const struct member *m, *object;
	char unknown[UNKNOWN_MAX], is[UNKNOWN_MAX];

	snprintf(unknown, sizeof unknown, "unknown %s '%s'",
	    topic ? "topic" : "command", word);
	try_rows(NULL, unknown, word);
	snprintf(is, sizeof is, "--%s", word);
	if (option_named(word) != NULL)
		refuse_by(NULL, unknown, is);
	m = synonym_find(word, &object);
	if (m != NULL)
		refuse_member(unknown, SCENE_ALL, m, object);
	if (near != NULL && *near != '-' &&
	    find_command(commands, near) == NULL)
		topic = true;
	if (near != NULL)
		die(EXIT_USAGE, "%s; did you mean 'projcalc %s%s'?", unknown,
		    topic ? "help " : "", near);
	die(EXIT_USAGE, "%s; 'projcalc help' lists commands", unknown);
}

void synonym_command(const struct command *commands, const char *word)
{
	const char first = first_char(word);
	bool operand = first == '{' || first == '[' ||
	    strpbrk(word, "./") != NULL || access(word, R_OK) == 0;

	if (operand ||
	    (*word == '-' &&
		(word[1] != '-' || option_named(word + 2) != NULL)))
		die(EXIT_USAGE,
		    "'%s' is no command; one comes first, such as project "
		    "or lookat, and all else behind it; 'projcalc help' lists "
		    "them",
		    word);
	synonym_word(commands, false, word);
}
