/* SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "call/options.h"
#include "message/message.h"
#include "scene/convention_member.h"
#include "scene/members.h"

/* A name, and a string, or null. */
static void put_told(struct printer *p, const char *name, const char *s)
{
	put_name(p, name);
	if (s != NULL)
		put_string(p, s);
	else
		put_literal(p, "null");
}

/* Puts those of some words, which may be NULL, that bits are. */
static void put_chosen(struct printer *p, const char *name,
    const char *const *words, unsigned bits)
{
	put_name(p, name);
	put_open(p, "[");
	for (int i = 0; words != NULL && words[i] != NULL; i++)
		if (bits >> i & 1)
			put_string(p, words[i]);
	put_close(p, "]");
}

/* An array's next element is an object in a line of its own. */
static void open_line(struct printer *p)
{
	p->between = *p->between != '\0' ? ",\n    " : "\n    ";
	put_open(p, "{");
}

static void open_list(struct printer *p, const char *name)
{
	put_name_on_new_line(p, name);
	put_open(p, "[");
}

static void put_command(struct printer *p, const struct command *c)
{
	const char *names[8 * sizeof c->wants.used + 1] = { NULL };
	char call[1024];

	for (int i = 0; scene_members[i].name != NULL; i++)
		names[i] = scene_members[i].name;
	snprintf(call, sizeof call, "projcalc %s %s", c->name,
	    c->example != NULL ? c->example : "");
	open_line(p);
	put_told(p, "name", c->name);
	put_told(p, "about", c->about);
	put_name(p, "options");
	put_open(p, "[");
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (option_is_for(r, c))
			put_string(p, r->name);
	put_close(p, "]");
	if (c->kind != HELP) {
		put_chosen(p, "reads", names, document_reads(&c->wants));
		/* a scene in the plane needs none of these */
		put_chosen(p, "needs", names,
		    c->wants.flat != 0 ? 0 : c->wants.needed);
		put_chosen(p, "alone", names, c->wants.bare);
	}
	put_told(p, "example", call);
	put_close(p, "}");
}

static void put_option(struct printer *p, const struct option_row *r,
    const struct command *c)
{
	const char letter[] = { r->letter, '\0' };

	open_line(p);
	put_told(p, "name", r->name);
	put_told(p, "letter", r->letter != 0 ? letter : NULL);
	put_told(p, "argument", r->argument);
	put_chosen(p, "words", r->words, ~0u);
	put_told(p, "about", r->about);
	put_name(p, "commands");
	put_open(p, "[");
	for (; c->name != NULL; c++)
		if (option_is_for(r, c))
			put_string(p, c->name);
	put_close(p, "]");
	put_close(p, "}");
}

/* The numbers that a member may be, by the words of JSON Schema. */
static void put_range(struct printer *p, const struct value_range *r)
{
	put_name(p, r->above ? "exclusiveMinimum" : "minimum");
	put_number(p, r->min);
	put_name(p, r->below ? "exclusiveMaximum" : "maximum");
	put_number(p, r->max);
}

/* A member of a scene, or of its member of that name; types are of a table whose
 * first row names them. */
static void put_member(struct printer *p, const struct member *row,
    const char *in, const char *const *types)
{
	char type[LISTED];

	open_line(p);
	put_told(p, "name", row->name);
	put_told(p, "in", in);
	put_told(p, "type", member_type(row, type));
	put_told(p, "unit", member_unit(row));
	if (row->range != NULL)
		put_range(p, row->range);
	put_name(p, "default");
	put_open(p, row->usual != NULL ? row->usual : "null");
	put_close(p, "");
	put_told(p, "before", row->before);
	put_told(p, "about", row->about);
	put_chosen(p, "words", row->words, ~0u);
	if (row->kinds != 0)
		put_chosen(p, "types", types, row->kinds);
	put_close(p, "}");
}

/* The ways to combine members; those for the command fit, if they are others. */
static void put_ways(struct printer *p, const char *in, const struct ways *w,
    const char *const *types)
{
	open_line(p);
	put_told(p, "in", in);
	put_chosen(p, "ways", w->way, ~0u);
	if (w->fit)
		put_chosen(p, "fit", w->fit_way, ~0u);
	if (w->kinds != 0)
		put_chosen(p, "types", types, w->kinds);
	put_close(p, "}");
}

static void put_members(struct printer *p)
{
	const struct member *s, *m;
	const struct ways *w;

	open_list(p, "members");
	for (s = scene_members; s->name != NULL; s++) {
		put_member(p, s, NULL, NULL);
		for (m = s->members; m != NULL && m->name != NULL; m++)
			put_member(p, m, s->name, s->members->words);
	}
	put_close(p, "]");
	open_list(p, "ways");
	for (s = scene_members; s->name != NULL; s++)
		for (w = s->ways; w != NULL && w->way[0] != NULL; w++)
			put_ways(p, s->name, w, s->members->words);
	put_close(p, "]");
}

static void put_conventions(struct printer *p)
{
	open_list(p, "conventions");
	for (int i = 0; i < CONVENTIONS; i++) {
		const bool *choice = (const bool *)&conventions[i];

		open_line(p);
		put_told(p, "name", convention_names[i]);
		for (const struct member *m = convention_members;
		     m->name != NULL; m++)
			put_told(p, m->name, m->words[choice[m->at]]);
		put_close(p, "}");
	}
	put_close(p, "]");
}

void help_json(const struct command *commands, const char *version)
{
	static char text[1 << 17];
	struct printer p = { .at = text, .between = "" };

	put_open(&p, "{");
	put_told(&p, "version", version);
	open_list(&p, "commands");
	for (const struct command *c = commands; c->name != NULL; c++)
		put_command(&p, c);
	put_close(&p, "]");
	open_list(&p, "options");
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		put_option(&p, r, commands);
	put_close(&p, "]");
	put_members(&p);
	put_conventions(&p);
	p.between = ",\n  ";
	put_chosen(&p, "formats", format_names, ~0u);
	p.between = ",\n  ";
	put_chosen(&p, "spaces", space_names, ~0u);
	put_text(&p, "\n}\n");
	print("%s", text);
}
