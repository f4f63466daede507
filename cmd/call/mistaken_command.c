/* SPDX-License-Identifier: MIT */
/* A word that stands where a command should. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "input.h"
#include "mistaken.h"
#include "../message/nearest.h"
#include "../scene/members.h"
#include "../message/message.h"

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

/* Commands, members of a scene, and theirs. */
enum { NAMES_MAX = 200 };

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

/* The command that reads what is typed: its first member says which. Those of a scene
 * that leads from model space to the device are for project, as are any scene's. */
static const char *command_of(const char *typed)
{
	const unsigned any = SCENE_SPATIAL | SCENE_CONVENTION |
	    SCENE_ANGLE_UNIT | SCENE_POINTS;
	const struct member *row, *s;
	char name[64] = "";
	static char word[64];

	sscanf(typed, " { \"%63[a-z_]", name);
	row = member_of(scene_members, ANY_KIND, name);
	if (row != NULL && (1u << (row - scene_members) & any) != 0)
		return "project";
	for (s = scene_members; row == NULL && s->name != NULL; s++)
		if (s->members != NULL &&
		    member_named(s->members, ANY_KIND, name) != NULL)
			row = s;
	sscanf(row != NULL ? row->command : "project", "%63s", word);
	return word;
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
		    find_command(commands, *w) != NULL)
			die(EXIT_USAGE,
			    "'%s' stands before the command; write projcalc "
			    "%s %s ...",
			    *words, *w, *words);
	if (strncmp(*words, "--", 2) == 0 && option_named(*words + 2) != NULL)
		die(EXIT_USAGE,
		    "no command behind '%s'; 'projcalc help' lists them",
		    *words);
	if (first_char(*words) == '[')
		die(EXIT_USAGE,
		    "'%s' is no command; write projcalc project scene.json "
		    "'%s', or what 'projcalc help' lists",
		    *words, *words);
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
	for (const struct member *s = scene_members; s->name != NULL; s++)
		names[n++] = s->name;
	for (const struct member *s = scene_members; s->name != NULL; s++)
		for (const struct member *m = s->members;
		     m != NULL && m->name != NULL && n + 1 < NAMES_MAX; m++)
			names[n++] = m->name;
	unknown(word, names);
}
