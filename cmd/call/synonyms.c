/* SPDX-License-Identifier: MIT */
#include "synonyms.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "input.h"
#include "../message/message.h"
#include "../message/nearest.h"
#include "../scene/members.h"

/* What others call by a word. The form of "is" says what it is: "--jobs" is an
 * option, "camera.eye" a member of that object, "scene.camera" one of the scene
 * itself, ": ..." a remark; anything else is a call. Of a word's rows the first
 * that is legal where the word stands is taken. */
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
	{ "extent", "scene.bounds" },
	{ "info", "inspect" },
	{ "click", "pick" },
	{ "explain", "trace" },
	{ "usage", "help" },
	{ "man", "help" },
	{ "-V", "--version" },
	{ "-v", "--version" },

	{ "format", "--output" },
	{ "json", "--output json" },
	{ "json", ": it prints JSON as it is" },
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

	{ "radians", "scene.angle_unit" },
	{ "transpose", "convention.vectors" },
	{ "column-major", "convention.vectors" },
	{ "near_far", "projection.near" },
	{ "near-far", "projection.near" },

	{ "distortion",
	    ": projcalc has no lens distortion; undistort points first" },
	{ "undistort",
	    ": projcalc has no lens distortion; undistort points first" },
	{ "lens", ": projcalc has no lens distortion; undistort points first" },
	{ "k1", ": projcalc has no lens distortion; undistort points first" },
	{ "stdin", ": standard input is - in place of PARAMS or POINTS" },
	{ "quiet", ": notes go to standard error; 2>/dev/null hides them" },
};

enum {
	SYNONYMS = sizeof synonyms / sizeof *synonyms,
	NAMES_MAX = 240, /* of commands, members of a scene, and theirs */
	CALL_MAX = 80,
	NAME_SHOWN = 64,
};

static bool is_remark(const char *is)
{
	return *is == ':';
}

/* The member that a row names, "camera.eye", and in *object the scene's member
 * that has it or is it; or NULL. */
static const struct member *member_at(const char *is,
    const struct member **object)
{
	char of[NAME_SHOWN], name[NAME_SHOWN];

	if (sscanf(is, "%63[a-z_].%63s", of, name) < 2)
		return NULL;
	if (strcmp(of, "scene") == 0)
		return *object = member_of(scene_members, ANY_KIND, name);
	*object = member_of(scene_members, ANY_KIND, of);
	return member_of((*object)->members, ANY_KIND, name);
}

/* The member of that name, or where aliases is true also that others call so,
 * in one of the objects that bits are; or such an object itself. The later
 * object has it rather: the viewport its width, the projection has another. */
static const struct member *find_in(unsigned bits, int kind, const char *name,
    bool aliases, const struct member **object)
{
	const struct member *(*find)(const struct member *, int,
	    const char *) = aliases ? member_named : member_of;

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

/* The member that an option is meant for, and its object; or NULL. By its exact
 * name it is looked for in what the command reads, less what but says; else
 * also in the camera, which is what others give options for, and anywhere. */
static const struct member *find_member(const struct command *c,
    const char *name, bool exact, unsigned but, const struct member **object)
{
	const struct document_wants *w = &c->wants;
	const int own = w->projection > 0 ? w->projection - 1 : 0;
	const struct {
		unsigned bits;
		int kind;
	} tries[] = { { w->bare, own }, { w->used & ~but, own },
		{ document_reads(w) & ~but, own }, { SCENE_CAMERA, own },
		{ SCENE_SPATIAL, own }, { w->used, ANY_KIND },
		{ SCENE_ALL, ANY_KIND } };
	const struct member *m = NULL;

	for (int i = 0; m == NULL && i < (exact ? 3 : 7); i++)
		for (int alias = 0; m == NULL && alias < 2 - exact; alias++)
			m = find_in(tries[i].bits, tries[i].kind, name, alias,
			    object);
	return m;
}

/* An option in messages: without its value. */
static int shown_length(const char *option)
{
	return (int)strcspn(option, "=");
}

#define UNKNOWN "%s: unknown option %.*s; "
#define MEMBER UNKNOWN "\"%s\" is a member of the %s"

/* Refuses an option that is a member, and shows how it is written where an
 * example has it: the command's, if it reads the object alone, or the row's. */
static _Noreturn void refuse_member(const struct command *c, const char *option,
    const struct member *m, const struct member *object)
{
	const char *of = m == object ? "scene" : object->name;
	const unsigned bit = 1u << (object - scene_members);
	bool alone = m != object && (c->wants.bare & bit) != 0;
	const char *example = alone ? c->example : object->example;
	const int n = shown_length(option);
	char quoted[NAME_SHOWN];

	snprintf(quoted, sizeof quoted, "\"%s\"", m->name);
	if (bit == SCENE_POINTS)
		die(EXIT_USAGE,
		    UNKNOWN "POINTS stand after PARAMS: projcalc %s scene.json "
			    "points.txt",
		    c->name, n, option, c->name);
	if ((document_reads(&c->wants) & bit) == 0)
		die(EXIT_USAGE,
		    MEMBER " that %s does not read; 'projcalc help %s' tells "
			   "of it",
		    c->name, n, option, m->name, of, c->name, object->name);
	if (example == NULL || (m != object && !strstr(example, quoted)))
		die(EXIT_USAGE, MEMBER "; 'projcalc help %s' tells of it",
		    c->name, n, option, m->name, of, object->name);
	if (alone)
		die(EXIT_USAGE, MEMBER ": projcalc %s %s", c->name, n, option,
		    m->name, of, c->name, example);
	die(EXIT_USAGE, MEMBER ": \"%s\": %s", c->name, n, option, m->name, of,
	    object->name, example);
}

/* Writes what may stand behind "projcalc", for a row that is no remark. */
static void write_call(char out[CALL_MAX], const char *is, bool topic)
{
	const struct member *object;
	const struct option_row *r = *is == '-' ? option_named(is + 2) : NULL;
	const char *taker = "";

	if (r != NULL && (r->argument != NULL || !(r->commands & HELP)))
		taker = (r->commands & PROJECT) ? "project " :
		    (r->commands & PICK)        ? "pick " :
						  "inspect ";
	else if (member_at(is, &object) != NULL)
		taker = "help ", is = object->name;
	else if (topic && r == NULL && strchr(is, ' ') == NULL)
		taker = "help ";
	snprintf(out, CALL_MAX, "%s%s", taker, is);
}

/* Refuses an option by a row that is legal here: an option of this command, a
 * call of it, a member that it reads, or a remark. A call of another command
 * is taken if elsewhere is true. */
static void try_row(const struct command *c, const char *option, const char *is,
    bool elsewhere)
{
	const size_t length = strlen(c->name);
	const struct option_row *r = *is == '-' ? option_named(is + 2) : NULL;
	const struct member *object, *m = member_at(is, &object);
	const int n = shown_length(option);
	char call[CALL_MAX];

	if (strncmp(is, c->name, length) == 0 && is[length] == ' ')
		is += length + 1;
	if (is_remark(is))
		die(EXIT_USAGE, UNKNOWN "%s", c->name, n, option, is + 2);
	if (*is == '-' && (r == NULL || option_is_for(r, c)))
		die(EXIT_USAGE, UNKNOWN "did you mean %s?", c->name, n, option,
		    is);
	if (m != NULL &&
	    (elsewhere ||
		document_reads(&c->wants) >> (object - scene_members) & 1))
		refuse_member(c, option, m, object);
	if (!elsewhere || strcmp(is, c->name) == 0)
		return;
	write_call(call, is, false);
	die(EXIT_USAGE, UNKNOWN "did you mean 'projcalc %s'?", c->name, n,
	    option, call);
}

static void try_rows(const struct command *c, const char *option,
    const char *name, bool elsewhere)
{
	for (int i = 0; i < SYNONYMS; i++)
		if (strcmp(synonyms[i].word, name) == 0)
			try_row(c, option, synonyms[i].is, elsewhere);
}

/* The name in an option, "--eye=0,0,5" or "-eye". */
static void name_of_option(char out[NAME_SHOWN], const char *option)
{
	option += strspn(option, "-");
	snprintf(out, NAME_SHOWN, "%.*s", shown_length(option), option);
}

void synonym_member(const struct command *c, const char *option)
{
	const struct member *m, *object;
	char name[NAME_SHOWN];

	name_of_option(name, option);
	try_rows(c, option, name, false);
	/* project --at is rather meant for pick than for the camera */
	m = find_member(c, name, true, SCENE_SPATIAL, &object);
	if (m != NULL)
		refuse_member(c, option, m, object);
}

void synonym_option(const struct command *c, const char *option)
{
	const struct member *m, *object;
	char name[NAME_SHOWN];

	name_of_option(name, option);
	for (int exact = 1; exact >= 0; exact--) {
		m = find_member(c, name, exact, 0, &object);
		if (m != NULL)
			refuse_member(c, option, m, object);
		try_rows(c, option, name, !exact);
	}
}

/* The nearest command, or else, where members is true, member. */
static const char *nearest_word(const struct command *commands, bool members,
    const char *word)
{
	const char *names[NAMES_MAX + 1] = { "--help", "--version" };
	const struct member *s = scene_members;
	int n = 2;

	for (const struct command *c = commands; c->name != NULL; c++)
		names[n++] = c->name;
	for (; members && s->name != NULL; s++) {
		names[n++] = s->name;
		for (const struct member *m = s->members;
		     m != NULL && m->name != NULL && n < NAMES_MAX; m++)
			names[n++] = m->name;
	}
	names[n] = NULL;
	return nearest(word, names);
}

/* What a word is called here, as a row of the table says it; or NULL. Members
 * are topics of help. */
static const char *meaning(const struct command *commands, const char *word,
    bool topic, char out[CALL_MAX])
{
	const struct member *object;
	const char *near;

	for (int i = 0; i < SYNONYMS; i++)
		if (strcmp(synonyms[i].word, word) == 0)
			return synonyms[i].is;
	if (option_named(word) != NULL) {
		snprintf(out, CALL_MAX, "--%s", word);
		return out;
	}
	if (find_in(SCENE_ALL, ANY_KIND, word, false, &object) == NULL) {
		near = nearest_word(commands, topic, word);
		if (near != NULL || topic ||
		    find_in(SCENE_ALL, ANY_KIND, word, true, &object) == NULL)
			return near;
	}
	snprintf(out, CALL_MAX, "help %s", word);
	return out;
}

static _Noreturn void refuse_word(const struct command *commands,
    const char *word, bool topic)
{
	const char *what = topic ? "topic" : "command";
	char named[CALL_MAX], call[CALL_MAX];
	const char *is = meaning(commands, word, topic, named);

	if (is != NULL && is_remark(is))
		die(EXIT_USAGE, "unknown %s '%s'; %s", what, word, is + 2);
	if (is != NULL) {
		write_call(call, is, topic);
		die(EXIT_USAGE, "unknown %s '%s'; did you mean '%s'?", what,
		    word, call);
	}
	die(EXIT_USAGE, "unknown %s '%s'; 'projcalc help' lists %s", what, word,
	    topic ? "commands" : "them");
}

void synonym_topic(const struct command *commands, const char *word)
{
	refuse_word(commands, word, true);
}

/* Whether a word is rather an operand. */
static bool is_operand(const char *word)
{
	char first = first_char(word);

	return first == '{' || first == '[' || strpbrk(word, "./") != NULL ||
	    access(word, R_OK) == 0;
}

void synonym_command(const struct command *commands, char **words)
{
	const char *word = *words;

	for (char **w = words + 1; *w != NULL; w++)
		if ((*word == '-' || is_operand(word)) &&
		    find_command(commands, *w) != NULL)
			die(EXIT_USAGE,
			    "'%s' stands before the command; write projcalc "
			    "%s %s ...",
			    word, *w, word);
	if (!is_operand(word) &&
	    (strncmp(word, "--", 2) != 0 || option_named(word + 2) == NULL))
		refuse_word(commands, word, false);
	die(EXIT_USAGE,
	    "'%s' is no command; one comes first, such as project or lookat; "
	    "'projcalc help' lists them",
	    word);
}
