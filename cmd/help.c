/* SPDX-License-Identifier: MIT */
#include "help.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "call/option_row.h"
#include "call/unknown.h"
#include "json/print.h"
#include "message/message.h"
#include "scene/convention_member.h"
#include "scene/types.h"

static void put_heading(const char *text)
{
	bool colored = output_is_colored(STDOUT_FILENO);

	output_printf("%s%s%s", colored ? "\033[1m" : "", text,
	    colored ? "\033[0m" : "");
}

enum { NAME_WIDTH = 15, TYPE_WIDTH = 23 };

/* Prints in brackets other words that mean the same as words[]: "[opengl: gl]". */
static void print_aliases(const char *const *words, const char *const *aliases)
{
	const char *before = " [";

	for (int i = 0; aliases != NULL && words[i] != NULL; i++)
		if (aliases[i] != NULL) {
			output_printf("%s%s: %s", before, aliases[i], words[i]);
			before = "; ";
		}
	output_printf("%s", *before == ';' ? "]" : "");
}

/* `types` are names of the object's types, of which it prints who has the member. */
static void print_member(const struct member *row, const char *const *types)
{
	char list[LIST_ROOM], type[2 * LIST_ROOM];
	const char *unit = row->unit, *before = " (";

	snprintf(type, sizeof type, "%s%s%s", member_type_name(row, list),
	    unit != NULL ? ", " : "", unit != NULL ? unit : "");
	output_printf("  %-*s %-*s", NAME_WIDTH - 1, row->name, TYPE_WIDTH, type);
	if (strlen(type) > TYPE_WIDTH)
		output_printf("\n%*s", NAME_WIDTH + 2 + TYPE_WIDTH, "");
	output_printf(" %s", row->about);
	if (row->default_from != NULL)
		output_printf("; default %s, else %.*s", row->default_from,
		    (int)strlen(row->fallback) - 2, row->fallback + 1);
	else if (row->fallback != NULL)
		output_printf("; default %s", row->fallback);
	if (row->aliases != NULL)
		output_printf(" [%s]", row->aliases);
	print_aliases(row->words, row->word_aliases);
	for (int i = 0; types != NULL && types[i] != NULL; i++)
		if (row->variants >> i & 1) {
			output_printf("%s%s", before, types[i]);
			before = ", ";
		}
	output_printf("%s\n", *before == ',' ? ")" : "");
}

static void print_members(const struct member *table, int variant, uint64_t bits)
{
	for (const struct member *row = table; row->name != NULL; row++)
		if (bits >> (row - table) & 1 &&
		    (variant == ANY_VARIANT || row->variants == 0 ||
			row->variants >> variant & 1))
			print_member(row, variant == ANY_VARIANT ? table->words : NULL);
}

void help_all(const struct command *c)
{
	put_heading("usage:");
	output_printf(" projcalc COMMAND [OPTION...] [PARAMS [POINTS...]]\n\n");
	for (; c->name != NULL; c++)
		output_printf("  %-10s %s\n", c->name, c->about);
	output_printf("\nPARAMS is a JSON file, - for standard input (default), or "
		      "'{...}'.\nPOINTS are files, -, or '[0,0,0]'.\n"
		      "See projcalc help COMMAND, projcalc help camera (or another "
		      "member), man projcalc.\n");
}

static void print_options(const struct command *c)
{
	for (const struct option_row *r = option_rows; r->name != NULL; r++) {
		const char letter[] = { '-', r->letter, ',', ' ', '\0' };
		char left[40];

		if (!option_is_for(r, c))
			continue;
		snprintf(left, sizeof left, "%s--%s %s",
		    r->letter != 0 ? letter : "    ", r->name,
		    r->argument != NULL ? r->argument : "");
		output_printf("  %-24s %s", left, r->about);
		if (r->word_aliases != NULL)
			output_printf("\n%*s", 26, "");
		print_aliases(r->words, r->word_aliases);
		output_printf("\n");
	}
}

static void print_params(const struct command *c)
{
	const struct document_wants *w = &c->wants;

	for (const struct member *row = scene_members; row->name != NULL; row++)
		if (w->lone_member >> (row - scene_members) & 1 ||
		    strcmp(row->name, c->name) == 0) {
			output_printf("\n");
			put_heading(row->name);
			output_printf(":\n");
			print_members(row->members, (int)w->source.implied_type - 1,
			    ALL_MEMBERS);
		}
	put_heading("\nscene:\n");
	print_members(scene_members, ANY_VARIANT, document_used_members(w));
	output_printf("projcalc help NAME describes a member that is an object.\n");
}

void help_command(const struct command *c)
{
	const char *operands = c->kind == COMMAND_HELP ? "[COMMAND | MEMBER]" :
	    command_reads_points(c)                    ? "[PARAMS [POINTS...]]" :
							 "[PARAMS]";

	put_heading("usage:");
	output_printf(" projcalc %s [OPTION...] %s\n%s\n\n", c->name, operands,
	    c->about);
	print_options(c);
	if (c->kind != COMMAND_HELP)
		print_params(c);
	put_heading("\nexample:");
	output_printf(" projcalc %s %s\n", c->name, c->example);
}

/* Prints the words of choices[m->offset] or, if it is NULL, the names of members m. */
static void print_convention_row(const char *name, const bool *choices)
{
	output_printf("  %-8s", name);
	for (const struct member *m = convention_members; m->name != NULL; m++) {
		size_t width = strlen(m->name);

		for (int i = 0; i < 2; i++)
			if (strlen(m->words[i]) > width)
				width = strlen(m->words[i]);
		output_printf(" %-*s", m[1].name != NULL ? (int)width : 0,
		    choices != NULL ? m->words[choices[m->offset]] : m->name);
	}
	output_printf("\n");
}

bool help_member(const char *name)
{
	const struct member *row;

	if (strcmp(name, "scene") == 0) {
		print_members(scene_members, ANY_VARIANT, ALL_MEMBERS);
		return true;
	}
	if (unknown_find_member(name, &row) == NULL)
		return false;
	put_heading(row->name);
	output_printf(": %s\n\n", row->about);
	if (row->members == NULL || row->words != NULL || row->members == step_members)
		print_member(row, NULL);
	if (row->members == step_members)
		output_printf("\nSteps apply to the point one after another, the first "
			      "first. A step has one of these:\n");
	if (row->members != NULL)
		print_members(row->members, ANY_VARIANT, ALL_MEMBERS);
	if (row->members == convention_members) {
		output_printf("\n");
		print_convention_row("", NULL);
		for (int i = 0; i < CONVENTIONS; i++)
			print_convention_row(convention_names[i],
			    (const bool *)&conventions[i]);
	}
	put_heading("\nexample:");
	output_printf(" projcalc %s\n", row->command);
	return true;
}

/* Puts an array of those words whose bit is set. `words` may be NULL. */
static void put_words(struct printer *p, const char *name, const char *const *words,
    unsigned bits)
{
	put_open(put_name(p, name), "[");
	for (int i = 0; words != NULL && words[i] != NULL; i++)
		if (bits >> i & 1)
			put_string(p, words[i]);
	put_close(p, "]");
}

/* Puts an array of the names of those rows whose bit is set; but no member if none is,
 * unless `always` is set. */
static void put_names(struct printer *p, const char *name, const struct member *table,
    uint64_t bits, bool always)
{
	if (bits == 0 && !always)
		return;
	put_open(put_name(p, name), "[");
	for (int i = 0; table[i].name != NULL; i++)
		if (bits >> i & 1)
			put_string(p, table[i].name);
	put_close(p, "]");
}

static void open_object(struct printer *p)
{
	p->separator = *p->separator != '\0' ? ",\n    " : "\n    ";
	put_open(p, "{");
}

static void put_command(struct printer *p, const struct command *c)
{
	const struct document_wants *w = &c->wants;
	char call[1024];

	snprintf(call, sizeof call, "projcalc %s %s", c->name, c->example);
	open_object(p);
	put_string(put_name(p, "name"), c->name);
	put_string(put_name(p, "about"), c->about);
	put_open(put_name(p, "options"), "[");
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		if (option_is_for(r, c))
			put_string(p, r->name);
	put_close(p, "]");
	if (c->kind != COMMAND_HELP) {
		put_names(p, "reads", scene_members, document_used_members(w), true);
		/* a command for 2D and 3D documents needs no member in both */
		put_names(p, "needs", scene_members,
		    w->flat_members != 0 ? 0 : w->needed, true);
		put_names(p, "alone", scene_members, w->lone_member, true);
	}
	put_string(put_name(p, "example"), call);
	put_close(p, "}");
}

static void put_option(struct printer *p, const struct option_row *r,
    const struct command *c)
{
	const char letter[] = { r->letter, '\0' };

	open_object(p);
	put_string(put_name(p, "name"), r->name);
	put_string(put_name(p, "letter"), r->letter != 0 ? letter : NULL);
	put_string(put_name(p, "argument"), r->argument);
	put_words(p, "words", r->words, ~0u);
	put_string(put_name(p, "about"), r->about);
	put_open(put_name(p, "commands"), "[");
	for (; c->name != NULL; c++)
		if (option_is_for(r, c))
			put_string(p, c->name);
	put_close(p, "]");
	put_close(p, "}");
}

/* Puts the aliases of a member, which have blanks between them. */
static void put_aliases(struct printer *p, const char *aliases)
{
	char name[64];

	put_open(put_name(p, "aliases"), "[");
	while (aliases != NULL && *aliases != '\0') {
		const size_t n = strcspn(aliases, " ");

		snprintf(name, sizeof name, "%.*s", (int)n, aliases);
		put_string(p, name);
		aliases += n + (aliases[n] == ' ');
	}
	put_close(p, "]");
}

/* Puts the row of a member of `object`, which has these types, or of the scene. A range
 * has the names of JSON Schema. */
static void put_member(struct printer *p, const struct member *row, const char *object,
    const char *const *types)
{
	const struct value_range *r = row->range;
	char type[LIST_ROOM];

	open_object(p);
	put_string(put_name(p, "name"), row->name);
	put_aliases(p, row->aliases);
	put_string(put_name(p, "in"), object);
	put_string(put_name(p, "type"), member_type_name(row, type));
	put_string(put_name(p, "unit"), row->unit);
	if (r != NULL) {
		put_name(p, r->min_excluded ? "exclusiveMinimum" : "minimum");
		put_number(p, r->min);
		put_name(p, r->max_excluded ? "exclusiveMaximum" : "maximum");
		put_number(p, r->max);
	}
	put_literal(put_name(p, "default"),
	    row->fallback != NULL ? row->fallback : "null");
	put_string(put_name(p, "before"), row->default_from);
	put_string(put_name(p, "about"), row->about);
	put_words(p, "words", row->words, ~0u);
	if (row->variants != 0)
		put_words(p, "types", types, row->variants);
	put_close(p, "}");
}

static void put_way(struct printer *p, const struct member *table, const struct way *w)
{
	put_open(p, "{");
	put_names(p, "has", table, w->has, true);
	put_names(p, "optional", table, w->optional, false);
	put_names(p, "fitted", table, w->fitted, false);
	put_names(p, "by_viewport", table, w->by_viewport, false);
	put_close(p, "}");
}

static void put_rule(struct printer *p, const char *object, const struct rule *r,
    const struct member *table)
{
	static const char *const tasks[] = { "whole", "fit", "plane", NULL };

	open_object(p);
	put_string(put_name(p, "in"), object);
	put_open(put_name(p, "ways"), "[");
	for (size_t i = 0; i < r->n; i++)
		put_way(p, table, &r->ways[i]);
	put_close(p, "]");
	put_names(p, "with", table, r->with, false);
	put_names(p, "without", table, r->without, false);
	if (r->tasks != 0)
		put_words(p, "tasks", tasks, r->tasks);
	if (r->variants != 0)
		put_words(p, "types", table->words, r->variants);
	put_close(p, "}");
}

/* Puts the rows of a table and, after each, those of its members. */
static void put_members(struct printer *p, const struct member *table,
    const char *object)
{
	for (const struct member *m = table; m != NULL && m->name != NULL; m++) {
		put_member(p, m, object, table->words);
		put_members(p, m->members, m->name);
	}
}

static void put_rules(struct printer *p, const struct member *table)
{
	for (const struct member *m = table; m != NULL && m->name != NULL; m++) {
		for (const struct rule *r = m->rules; r != NULL && r->n > 0; r++)
			put_rule(p, m->name, r, m->members);
		put_rules(p, m->members);
	}
}

void help_json(const struct command *commands, const char *version)
{
	static char text[1 << 17];
	struct printer p = { .at = text, .separator = "{" };

	put_string(put_name(&p, "version"), version);
	p.level = 1; /* each member from here on begins a line */
	put_open(put_name(&p, "commands"), "[");
	for (const struct command *c = commands; c->name != NULL; c++)
		put_command(&p, c);
	put_close(&p, "]");
	put_open(put_name(&p, "options"), "[");
	for (const struct option_row *r = option_rows; r->name != NULL; r++)
		put_option(&p, r, commands);
	put_close(&p, "]");
	put_open(put_name(&p, "members"), "[");
	put_members(&p, scene_members, NULL);
	put_close(&p, "]");
	put_open(put_name(&p, "ways"), "[");
	put_rules(&p, scene_members);
	put_close(&p, "]");
	put_open(put_name(&p, "conventions"), "[");
	for (int i = 0; i < CONVENTIONS; i++) {
		open_object(&p);
		put_string(put_name(&p, "name"), convention_names[i]);
		for (const struct member *m = convention_members; m->name != NULL; m++)
			m->type->print(put_name(&p, m->name), m,
			    (const char *)&conventions[i] + m->offset);
		put_close(&p, "}");
	}
	put_close(&p, "]");
	put_words(&p, "formats", format_names, ~0u);
	put_words(&p, "spaces", space_names, ~0u);
	put_close(&p, "}\n");
	output_write(text, (size_t)(p.at - text));
}
