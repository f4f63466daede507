/* SPDX-License-Identifier: MIT */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "message/escape.h"
#include "help.h"
#include "call/options.h"
#include "scene/convention_member.h"
#include "scene/members.h"
#include "message/message.h"

/* What stands before the next value: "" behind an opening bracket or a name. */
static const char *between = "";

static void put(const char *text)
{
	print("%s%s", between, text);
	between = ", ";
}

static void open_bracket(const char *bracket)
{
	put(bracket);
	between = "";
}

static void close_bracket(const char *bracket)
{
	between = "";
	put(bracket);
}

static void put_string(const char *s)
{
	char text[2048];

	escape_json(text, sizeof text, s, strlen(s));
	put("\"");
	print("%s\"", text);
}

static void put_name(const char *name)
{
	put_string(name);
	print(": ");
	between = "";
}

/* A name, and a string, or null. */
static void put_text(const char *name, const char *s)
{
	put_name(name);
	if (s != NULL)
		put_string(s);
	else
		put("null");
}

static void put_words(const char *name, const char *const *words)
{
	put_name(name);
	open_bracket("[");
	for (; words != NULL && *words != NULL; words++)
		put_string(*words);
	close_bracket("]");
}

/* An array's next element is an object in a line of its own. */
static void open_line(void)
{
	between = *between != '\0' ? ",\n    " : "\n    ";
	open_bracket("{");
}

static void open_list(const char *name)
{
	between = *between != '\0' ? ",\n  " : "\n  ";
	put_name(name);
	open_bracket("[");
}

/* The names of the members that bits are. */
static void put_members_of(const char *name, unsigned bits)
{
	put_name(name);
	open_bracket("[");
	for (int i = 0; scene_members[i].name != NULL; i++)
		if (bits >> i & 1)
			put_string(scene_members[i].name);
	close_bracket("]");
}

static void put_command(const struct command *c)
{
	char call[1024];

	snprintf(call, sizeof call, "projcalc %s %s", c->name,
	    c->example != NULL ? c->example : "");
	open_line();
	put_text("name", c->name);
	put_text("about", c->about);
	put_name("options");
	open_bracket("[");
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (option_is_for(r, c))
			put_string(r->name);
	close_bracket("]");
	if (c->kind != HELP) {
		put_members_of("reads", document_reads(&c->wants));
		/* a scene in the plane needs none of these */
		put_members_of("needs",
		    c->wants.flat != 0 ? 0 : c->wants.needed);
		put_members_of("alone", c->wants.bare);
	}
	put_text("example", call);
	close_bracket("}");
}

static void put_option(const struct option_row *r, const struct command *c)
{
	const char letter[] = { r->letter, '\0' };

	open_line();
	put_text("name", r->name);
	put_text("letter", r->letter != 0 ? letter : NULL);
	put_text("argument", r->argument);
	put_words("words", r->words);
	put_text("about", r->about);
	put_name("commands");
	open_bracket("[");
	for (; c->name != NULL; c++)
		if (option_is_for(r, c))
			put_string(c->name);
	close_bracket("]");
	close_bracket("}");
}

/* A member of a scene, or of its member of that name; types are of a table whose
 * first row names them. */
static void put_member(const struct member *row, const char *in,
    const char *const *types)
{
	char type[LISTED];

	open_line();
	put_text("name", row->name);
	put_text("in", in);
	put_text("type", member_type(row, type));
	put_text("unit", row->unit);
	put_name("default");
	put(row->otherwise != NULL ? row->otherwise : "null");
	put_text("about", row->about);
	put_words("words", row->words);
	if (row->kinds != 0) {
		put_name("types");
		open_bracket("[");
		for (int i = 0; types[i] != NULL; i++)
			if (row->kinds >> i & 1)
				put_string(types[i]);
		close_bracket("]");
	}
	close_bracket("}");
}

static void put_convention(int i)
{
	const bool *choice = (const bool *)&conventions[i];

	open_line();
	put_text("name", convention_names[i]);
	for (const struct member *m = convention_members; m->name != NULL; m++)
		put_text(m->name, m->words[choice[m->at]]);
	close_bracket("}");
}

void help_json(const struct command *commands, const char *version)
{
	const struct member *s, *m;

	open_bracket("{");
	put_text("version", version);
	open_list("commands");
	for (const struct command *c = commands; c->name != NULL; c++)
		put_command(c);
	close_bracket("]");
	open_list("options");
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		put_option(r, commands);
	close_bracket("]");
	open_list("members");
	for (s = scene_members; s->name != NULL; s++) {
		put_member(s, NULL, NULL);
		for (m = s->members; m != NULL && m->name != NULL; m++)
			put_member(m, s->name, s->members->words);
	}
	close_bracket("]");
	open_list("conventions");
	for (int i = 0; i < CONVENTIONS; i++)
		put_convention(i);
	close_bracket("]");
	between = ",\n  ";
	put_words("formats", format_names);
	between = ",\n  ";
	put_words("spaces", space_names);
	print("\n}\n");
}
