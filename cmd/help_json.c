/* SPDX-License-Identifier: MIT */
#include "help_json.h"

#include <stdio.h>

#include "call/option_row.h"
#include "message/message.h"
#include "scene/convention_member.h"

/* Puts a member whose value is the string s, or null if s is NULL. */
static void put_text_member(struct printer *p, const char *name, const char *s)
{
	put_name(p, name);
	if (s != NULL)
		put_string(p, s);
	else
		put_literal(p, "null");
}

/* Puts a member with an array of those words whose bit is set. `words` may be NULL. */
static void put_words(struct printer *p, const char *name,
    const char *const *words, unsigned bits)
{
	put_open(put_name(p, name), "[");
	for (int i = 0; words != NULL && words[i] != NULL; i++)
		if (bits >> i & 1)
			put_string(p, words[i]);
	put_close(p, "]");
}

/* Opens an object on a new line, as the next element of an array. */
static void open_object(struct printer *p)
{
	p->separator = *p->separator != '\0' ? ",\n    " : "\n    ";
	put_open(p, "{");
}

static void put_command(struct printer *p, const struct command *c)
{
	const char *names[8 * sizeof c->wants.used + 1] = { NULL };
	char call[1024];

	for (int i = 0; scene_members[i].name != NULL; i++)
		names[i] = scene_members[i].name;
	snprintf(call, sizeof call, "projcalc %s %s", c->name,
	    c->example != NULL ? c->example : "");
	open_object(p);
	put_text_member(p, "name", c->name);
	put_text_member(p, "about", c->about);
	put_open(put_name(p, "options"), "[");
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (option_is_for(r, c))
			put_string(p, r->name);
	put_close(p, "]");
	if (c->kind != COMMAND_HELP) {
		put_words(p, "reads", names, document_used_members(&c->wants));
		/* a command for 2D and 3D documents needs no member in both */
		put_words(p, "needs", names,
		    c->wants.flat_members != 0 ? 0 : c->wants.needed);
		put_words(p, "alone", names, c->wants.lone_member);
	}
	put_text_member(p, "example", call);
	put_close(p, "}");
}

static void put_option(struct printer *p, const struct option_row *r,
    const struct command *c)
{
	const char letter[] = { r->letter, '\0' };

	open_object(p);
	put_text_member(p, "name", r->name);
	put_text_member(p, "letter", r->letter != 0 ? letter : NULL);
	put_text_member(p, "argument", r->argument);
	put_words(p, "words", r->words, ~0u);
	put_text_member(p, "about", r->about);
	put_open(put_name(p, "commands"), "[");
	for (; c->name != NULL; c++)
		if (option_is_for(r, c))
			put_string(p, c->name);
	put_close(p, "]");
	put_close(p, "}");
}

/* Puts the range of a member's numbers under the names of JSON Schema. */
static void put_range(struct printer *p, const struct value_range *r)
{
	put_name(p, r->min_excluded ? "exclusiveMinimum" : "minimum");
	put_number(p, r->min);
	put_name(p, r->max_excluded ? "exclusiveMaximum" : "maximum");
	put_number(p, r->max);
}

/* Puts the row of a member of the scene or, if `object` is not NULL, of the object with
 * this name in the scene. `types` has the names of the object's types. */
static void put_member(struct printer *p, const struct member *row,
    const char *object, const char *const *types)
{
	char type[LIST_ROOM];

	open_object(p);
	put_text_member(p, "name", row->name);
	put_text_member(p, "in", object);
	put_text_member(p, "type", member_type_name(row, type));
	put_text_member(p, "unit", row->unit);
	if (row->range != NULL)
		put_range(p, row->range);
	put_literal(put_name(p, "default"),
	    row->fallback != NULL ? row->fallback : "null");
	put_text_member(p, "before", row->default_from);
	put_text_member(p, "about", row->about);
	put_words(p, "words", row->words, ~0u);
	if (row->variants != 0)
		put_words(p, "types", types, row->variants);
	put_close(p, "}");
}

/* Puts a rule for the members of `object`. */
static void put_rule(struct printer *p, const char *object,
    const struct rule *r, const char *const *types)
{
	open_object(p);
	put_text_member(p, "in", object);
	put_words(p, "ways", r->ways, ~0u);
	if (r->with != NULL)
		put_text_member(p, "with", r->with);
	if (r->tasks != 0)
		put_words(p, "tasks", WAYS("whole", "fit", "plane"), r->tasks);
	if (r->variants != 0)
		put_words(p, "types", types, r->variants);
	put_close(p, "}");
}

static void put_all_members(struct printer *p)
{
	const struct member *s, *m;
	const struct rule *r;

	put_open(put_name(p, "members"), "[");
	for (s = scene_members; s->name != NULL; s++) {
		put_member(p, s, NULL, NULL);
		for (m = s->members; m != NULL && m->name != NULL; m++)
			put_member(p, m, s->name, s->members->words);
	}
	put_close(p, "]");
	put_open(put_name(p, "ways"), "[");
	for (s = scene_members; s->name != NULL; s++)
		for (r = s->rules; r != NULL && r->ways != NULL; r++)
			put_rule(p, s->name, r, s->members->words);
	put_close(p, "]");
}

static void put_conventions(struct printer *p)
{
	put_open(put_name(p, "conventions"), "[");
	for (int i = 0; i < CONVENTIONS; i++) {
		const bool *choice = (const bool *)&conventions[i];

		open_object(p);
		put_text_member(p, "name", convention_names[i]);
		for (const struct member *m = convention_members;
		     m->name != NULL; m++)
			put_text_member(p, m->name,
			    m->words[choice[m->offset]]);
		put_close(p, "}");
	}
	put_close(p, "]");
}

void help_json(const struct command *commands, const char *version)
{
	static char text[1 << 17];
	struct printer p = { .at = text, .separator = "{" };

	put_text_member(&p, "version", version);
	p.level = 1; /* each member from here on begins a line */
	put_open(put_name(&p, "commands"), "[");
	for (const struct command *c = commands; c->name != NULL; c++)
		put_command(&p, c);
	put_close(&p, "]");
	put_open(put_name(&p, "options"), "[");
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		put_option(&p, r, commands);
	put_close(&p, "]");
	put_all_members(&p);
	put_conventions(&p);
	put_words(&p, "formats", format_names, ~0u);
	put_words(&p, "spaces", space_names, ~0u);
	put_close(&p, "}\n");
	output_printf("%s", text);
}
