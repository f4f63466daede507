/* SPDX-License-Identifier: MIT */
#include "object.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "../message/nearest.h"
#include "../message/escape.h"

/* The most rows of a table: members are bits of an unsigned. */
enum { MEMBERS_MAX = 32 };

static bool is_ignored(const char *name)
{
	return *name == '_' || strcmp(name, "$schema") == 0;
}

static bool is_of(const struct member *row, int kind)
{
	return kind == ANY_KIND || row->kinds == 0 ||
	    (row->kinds >> kind & 1) != 0;
}

const struct member *member_of(const struct member *row, int kind,
    const char *name)
{
	for (; row->name != NULL; row++)
		if (is_of(row, kind) && strcmp(row->name, name) == 0)
			return row;
	return NULL;
}

/* Whether the member of a document that is an object alone is the scene's. */
static bool is_beside(const struct value *v, const struct member *table)
{
	const struct member *scene = v->source->scene;

	if (v->in->in != NULL || table == scene)
		return false;
	const struct member *row = member_of(scene, 0, v->name);

	return row != NULL && row->beside;
}

unsigned member_bit(const struct member *table, int kind, const char *name)
{
	const struct member *row = member_of(table, kind, name);

	return row != NULL ? 1u << (row - table) : 0;
}

/* Whether a word is in a list of words with blanks between them. */
static bool listed(const char *list, const char *word)
{
	size_t n = strlen(word);

	for (; list != NULL && *list != '\0'; list += strspn(list, " ")) {
		size_t m = strcspn(list, " ");

		if (m == n && memcmp(list, word, n) == 0)
			return true;
		list += m;
	}
	return false;
}

/* The member with that alias, or NULL. The name's case and its _ and - don't
 * count: LookAt, look_at and look-at are lookat. */
static const struct member *find_alias(const struct member *row, int kind,
    const char *name)
{
	char plain[ESCAPED_MAX];
	size_t n = 0;

	for (; *name != '\0' && n + 1 < sizeof plain; name++)
		if (*name != '_' && *name != '-')
			plain[n++] = (char)tolower((unsigned char)*name);
	plain[n] = '\0';
	for (; row->name != NULL; row++)
		if (is_of(row, kind) && listed(row->aliases, plain))
			return row;
	return NULL;
}

const struct member *member_named(const struct member *table, int kind,
    const char *name)
{
	const struct member *row = member_of(table, kind, name);

	return row != NULL ? row : find_alias(table, kind, name);
}

const char *member_type(const struct member *row, char out[LISTED])
{
	if (row->type != NULL)
		return row->type;
	if (row->members != NULL)
		return "object";
	if (row->words != NULL)
		return list_words(out, row->words, " or ", "");
	if (row->n == 0)
		return row->range == &range_positive ? "size" : "number";
	snprintf(out, LISTED, "%zu numbers", row->n);
	return out;
}

static void names_of(const struct member *row, int kind,
    const char *names[MEMBERS_MAX + 1])
{
	int n = 0;

	for (; row->name != NULL; row++)
		if (is_of(row, kind))
			names[n++] = row->name;
	names[n] = NULL;
}

/* The member that was probably meant by a wrong name, or NULL. */
static const struct member *meant(const struct member *table, int kind,
    const char *name)
{
	const char *names[MEMBERS_MAX + 1];
	const struct member *row = find_alias(table, kind, name);

	if (row != NULL)
		return row;
	names_of(table, kind, names);
	const char *near = nearest(name, names);

	return near != NULL ? member_of(table, kind, near) : NULL;
}

/* Its name in quotes, and what it is. Returns out. */
static const char *described(const struct member *row, char out[LISTED])
{
	bool note = row->note != NULL;

	snprintf(out, LISTED, "\"%s\"%s%s%s", row->name, note ? " (" : "",
	    note ? row->note : "", note ? ")" : "");
	return out;
}

static void refuse_other_kind(const struct value *v, const struct member *table,
    int kind)
{
	const struct member *row = member_of(table, ANY_KIND, v->name);
	int other = 0;

	if (row == NULL)
		return;
	while ((row->kinds >> other & 1) == 0)
		other++;
	value_refuse(v, "not a member of \"%s\"; \"%s\" has it",
	    table->words[kind], table->words[other]);
}

/* Refuses a member that other objects of the scene have, and names those whose
 * first kind has it; if there are none, those of which any kind has it; if
 * there are none either, the first that has it as an alias; and one of the scene
 * itself. */
static void refuse_misplaced(const struct value *v, const struct member *table)
{
	const char *names[MEMBERS_MAX + 1];
	const struct member *scene = v->source->scene, *row, *s;
	char all[LISTED];
	int n = 0, how;

	for (how = 0; how < 2 && n == 0; how++)
		for (s = scene; s->name != NULL; s++)
			if (s->members != NULL && s->members != table &&
			    (how == 0 ? member_of(s->members, 0, v->name) :
					member_of(s->members, ANY_KIND,
					    v->name)) != NULL)
				names[n++] = s->name;
	names[n] = NULL;
	if (n > 0)
		value_refuse(v, "unknown member; it belongs in %s",
		    list_words(all, names, " or ", "\""));
	for (s = scene; s->name != NULL; s++) {
		if (s->members == NULL || s->members == table)
			continue;
		row = find_alias(s->members, 0, v->name);
		if (row != NULL)
			value_refuse(v, "unknown member; \"%s\" has %s",
			    s->name, described(row, all));
	}
	if (v->in->named && table != scene &&
	    member_of(scene, 0, v->name) != NULL)
		value_refuse(v, "unknown member; it stands beside \"%s\"",
		    v->in->name);
}

static _Noreturn void unknown(const struct value *v, const struct member *table,
    int kind)
{
	const struct member *scene = v->source->scene;
	const struct member *row = NULL;
	const char *names[MEMBERS_MAX + 1];
	char all[LISTED];

	/* In a document for lookat, a misspelt "camera" looks like a member of
	 * a camera. */
	if (v->in->in == NULL && table != scene && value_is_object(v))
		row = meant(scene, 0, v->name);
	if (row == NULL && find_alias(table, kind, v->name) == NULL) {
		refuse_other_kind(v, table, kind);
		refuse_misplaced(v, table);
	}
	if (row == NULL)
		row = meant(table, kind, v->name);
	if (row != NULL)
		value_refuse(v, "unknown member; did you mean %s?",
		    described(row, all));
	names_of(table, kind, names);
	value_refuse(v, "unknown member; there are %s",
	    list_words(all, names, " and ", "\""));
}

unsigned object_read(const struct value *v, const struct member *table,
    int kind, void *base)
{
	unsigned seen = 0;
	bool beside = false;

	value_want_object(v);
	struct value m = value_child(v);

	for (; m.s != NULL; value_next(&m)) {
		if (is_ignored(m.name))
			continue;
		unsigned bit = member_bit(table, kind, m.name);
		bool other = is_beside(&m, table);

		if (bit == 0 && !other)
			unknown(&m, table, kind);
		if (other ? beside : (seen & bit) != 0)
			value_refuse(&m, "repeated; give it once");
		seen |= bit;
		beside |= other;
		if (other)
			continue;
		const struct member *row = member_of(table, kind, m.name);

		row->read(&m, row, (char *)base + row->at);
	}
	return seen;
}

/* The members of a way, as bits; in *must those that may not be missing. */
static unsigned way_bits(const struct member *table, int kind, const char *way,
    unsigned *must)
{
	unsigned all = 0;
	char name[ESCAPED_MAX];

	for (*must = 0; *way != '\0'; way += strspn(way, " ?")) {
		size_t n = strcspn(way, " ?");

		memcpy(name, way, n);
		name[n] = '\0';
		way += n;
		unsigned bit = member_bit(table, kind, name);

		all |= bit;
		if (*way != '?')
			*must |= bit;
	}
	return all;
}

/* The first member of bits. */
static const struct member *lowest(const struct member *table, unsigned bits)
{
	while ((bits & 1) == 0) {
		bits >>= 1;
		table++;
	}
	return table;
}

/* Refuses the first of the extra members, which are not of the way taken: "not
 * together with" a member taken that stands in no way with it, if there is one,
 * else with the first member taken. */
static _Noreturn void refuse_extra(const struct value *v,
    const struct member *table, int kind, unsigned taken, unsigned extra,
    const struct ways *w)
{
	unsigned must, rivals = taken;

	extra &= ~extra + 1;
	for (int i = 0; w->way[i] != NULL; i++) {
		unsigned all = way_bits(table, kind, w->way[i], &must);

		if (all & extra)
			rivals &= ~all;
	}
	struct value m = value_missing(v, lowest(table, extra)->name);

	value_refuse(&m, "not together with \"%s\"; %s",
	    lowest(table, rivals != 0 ? rivals : taken)->name, w->hint);
}

int object_way(const struct value *v, const struct member *table, int kind,
    unsigned seen, const struct ways *w)
{
	unsigned taken = 0, extra = 0, lacking = 0, any = 0, must, all;

	for (int i = 0; w->way[i] != NULL; i++)
		any |= way_bits(table, kind, w->way[i], &must);
	seen &= any;
	for (int i = 0; w->way[i] != NULL; i++) {
		all = way_bits(table, kind, w->way[i], &must);
		if ((must & ~seen) == 0 && (seen & ~all) == 0)
			return i;
		if ((must & ~seen) == 0 && (all & seen) != 0 && extra == 0) {
			taken = seen & all;
			extra = seen & ~all;
		}
		if ((must & seen) != 0 && lacking == 0)
			lacking = must & ~seen;
	}
	if (extra != 0)
		refuse_extra(v, table, kind, taken, extra, w);
	if (lacking == 0)
		way_bits(table, kind, w->way[0], &lacking);
	struct value m = value_missing(v, lowest(table, lacking)->name);

	value_refuse(&m, "missing; %s", w->hint);
}
