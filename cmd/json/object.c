/* SPDX-License-Identifier: MIT */
#include "object.h"

#include <stdio.h>
#include <string.h>

#include "../message/nearest.h"
#include "../message/escape.h"

/* The most rows of a table: members are bits. */
enum { MEMBERS_MAX = 64 };

static bool is_ignored(const char *name)
{
	return *name == '_' || strcmp(name, "$schema") == 0;
}

bool member_is_of(const struct member *row, int kind)
{
	return kind == ANY_KIND || row->kinds == 0 ||
	    (row->kinds >> kind & 1) != 0;
}

const struct member *member_of(const struct member *row, int kind,
    const char *name)
{
	for (; row->name != NULL; row++)
		if (member_is_of(row, kind) && strcmp(row->name, name) == 0)
			return row;
	return NULL;
}

/* Whether a member of a document that is an object alone is the scene's. */
static bool is_beside(const struct value *v)
{
	const struct member *row = v->in->in != NULL ?
	    NULL :
	    member_of(v->source->scene, 0, v->name);

	return row != NULL && row->beside;
}

uint64_t member_bit(const struct member *table, int kind, const char *name)
{
	const struct member *row = member_of(table, kind, name);

	return row != NULL ? UINT64_C(1) << (row - table) : 0;
}

/* Returns the member with that alias, or NULL. */
static const struct member *find_alias(const struct member *row, int kind,
    const char *name)
{
	for (; row->name != NULL; row++)
		if (row->aliases != NULL && member_is_of(row, kind) &&
		    word_is_one_of(name, row->aliases))
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
	if (row->type->says != NULL)
		return row->type->says;
	if (row->members != NULL)
		return "object";
	if (row->words != NULL)
		return list_words(out, row->words, " or ", "");
	const char *one = row->range == NULL ? "number" :
	    row->range->angle                ? "angle" :
	    row->range == &range_positive    ? "size" :
					       "number";

	if (row->n == 0)
		return one;
	snprintf(out, LISTED, "%zu %ss", row->n, one);
	return out;
}

const char *member_unit(const struct member *row)
{
	bool angle = row->range != NULL && row->range->angle;

	return angle ? "degrees" : row->unit;
}

/* The names of those members of bits that objects of that kind have. */
static void list_names(const struct member *row, int kind, uint64_t bits,
    const char *names[MEMBERS_MAX + 1])
{
	int n = 0;

	for (; row->name != NULL; row++, bits >>= 1)
		if ((bits & 1) != 0 && member_is_of(row, kind))
			names[n++] = row->name;
	names[n] = NULL;
}

/* Says which member has that alias, which other objects have such a member or that
 * the scene has it, which name is nearest, or all names. */
static _Noreturn void refuse_unknown(const struct value *v,
    const struct member *table, int kind)
{
	const struct member *row = find_alias(table, kind, v->name);
	const struct member *s = v->source->scene;
	const char *names[MEMBERS_MAX + 1];
	char all[LISTED];
	int n = 0;

	if (row != NULL)
		value_refuse(v, "unknown member; did you mean \"%s\"%s%s%s?",
		    row->name, row->note != NULL ? " (" : "",
		    row->note != NULL ? row->note : "",
		    row->note != NULL ? ")" : "");
	for (; s->name != NULL; s++)
		if (s->members != NULL && s->members != table &&
		    member_named(s->members, ANY_KIND, v->name) != NULL)
			names[n++] = s->name;
	names[n] = NULL;
	if (n > 0)
		value_refuse(v, "unknown member; it belongs in %s",
		    list_words(all, names, " or ", "\""));
	if (v->in->in != NULL && member_of(v->source->scene, 0, v->name))
		value_refuse(v, "unknown member; it stands beside \"%s\"",
		    v->in->name);
	list_names(table, kind, ALL_MEMBERS, names);
	const char *near = nearest_word(v->name, names);

	if (near != NULL)
		value_refuse(v, "unknown member; did you mean \"%s\"?", near);
	value_refuse(v, "unknown member; there are %s",
	    list_words(all, names, " and ", "\""));
}

/* Reads the value that a member has without being given, to where the member stands
 * or, for comparison, elsewhere. */
static void read_usual(const struct member *row, void *to)
{
	static const struct source source;
	struct value usual = value_literal(&source, row->usual);

	row->type->read(&usual, row, to);
}

void object_read_member(const struct value *v, const struct member *row,
    void *base)
{
	row->type->read(v, row, (char *)base + row->at);
	if (row->has != 0)
		*(bool *)((char *)base + row->has) = true;
}

uint64_t object_read(const struct value *v, const struct member *table,
    int kind, void *base)
{
	uint64_t seen = 0;

	value_want_object(v);
	for (const struct member *row = table; row->name != NULL; row++)
		if (base != NULL && row->usual != NULL && row->type->size > 0 &&
		    member_is_of(row, kind))
			read_usual(row, (char *)base + row->at);
	struct value m = value_child(v), first;

	for (; m.item != NULL; value_next(&m)) {
		const struct member *row = member_of(table, kind, m.name);

		if (is_ignored(m.name))
			continue;
		if (row == NULL && !is_beside(&m))
			refuse_unknown(&m, table, kind);
		value_member(v, m.name, &first);
		if (first.item != m.item)
			value_refuse(&m, "repeated; give it once");
		if (row == NULL)
			continue;
		seen |= UINT64_C(1) << (row - table);
		if (base != NULL)
			object_read_member(&m, row, base);
	}
	return seen;
}

/* Whether the member that stands there is what it is without being given. */
static bool is_usual(const struct member *row, const void *at)
{
	const double *v = at;
	double usual[4];

	if (row->usual == NULL && row->range == &range_positive)
		return *v == 0; /* it was not given */
	if (row->usual == NULL || row->shown || row->type->size == 0)
		return false;
	read_usual(row, usual);
	if (row->type->size != sizeof *v)
		return memcmp(usual, at, row->type->size) == 0;
	for (size_t i = 0; i == 0 || i < row->n; i++)
		if (v[i] != usual[i])
			return false;
	return true;
}

void object_put(struct printer *p, const struct member *row, int kind,
    uint64_t bits, const void *base,
    void (*put)(struct printer *, const char *name))
{
	const char *at = base;

	for (; row->name != NULL; row++, bits >>= 1) {
		bool has = row->has == 0 || *(const bool *)(at + row->has);

		if ((bits & 1) == 0 || !has || !member_is_of(row, kind) ||
		    is_usual(row, at + row->at))
			continue;
		put(p, row->name);
		row->type->print(p, row, at + row->at);
	}
}

void object_print(struct printer *p, const struct member *row, int kind,
    uint64_t bits, const void *base)
{
	put_open(p, "{");
	object_put(p, row, kind, bits, base, put_name);
	put_close(p, "}");
}

/* The members of a way, as bits; in *must those that may not be missing. */
static uint64_t way_bits(const struct member *table, int kind, const char *way,
    uint64_t *must)
{
	uint64_t all = 0;
	char name[ESCAPED_MAX];

	for (*must = 0; *way != '\0'; way += strspn(way, " ?")) {
		size_t n = strcspn(way, " ?");

		memcpy(name, way, n);
		name[n] = '\0';
		way += n;
		uint64_t bit = member_bit(table, kind, name);

		all |= bit;
		if (*way != '?')
			*must |= bit;
	}
	return all;
}

/* The members of all ways, as bits. */
static uint64_t ways_bits(const struct member *table, int kind,
    const char *const *way)
{
	uint64_t all = 0, must;

	for (; *way != NULL; way++)
		all |= way_bits(table, kind, *way, &must);
	return all;
}

uint64_t object_shown(const struct member *table, int kind,
    const struct ways *w, int way)
{
	uint64_t must;

	return ~ways_bits(table, kind, w->way) |
	    way_bits(table, kind, w->way[way], &must);
}

/* Writes which members to give, those seen among them that may be missing. */
static void hint(char out[LISTED], const struct member *table, int kind,
    const char *const *way, uint64_t seen)
{
	const char *names[MEMBERS_MAX + 1];
	char all[LISTED];
	uint64_t must;
	size_t n = 0;

	for (int i = 0; way[i] != NULL && n < LISTED; i++) {
		uint64_t bits = way_bits(table, kind, way[i], &must);

		list_names(table, kind, bits & (must | seen), names);
		list_words(all, names, " and ", "\"");
		n += (size_t)snprintf(out + n, LISTED - n, "%s%s",
		    i > 0 ? ", or " : "give ",
		    *all != '\0' ? all : "none of them");
	}
}

int object_way(const struct value *v, const struct member *table, int kind,
    uint64_t seen, const struct ways *w)
{
	bool fit = v->source->fit && w->fit && !v->unused;
	const char *const *way = fit ? w->fit_way : w->way;
	uint64_t extra = 0, lacking = 0, must, all;
	char said[LISTED];

	seen &= ways_bits(table, kind, way);
	for (int i = 0; way[i] != NULL; i++) {
		all = way_bits(table, kind, way[i], &must);
		if ((must & ~seen) == 0 && (seen & ~all) == 0)
			return i;
		if ((must & ~seen) == 0 && (all & seen) != 0 && extra == 0)
			extra = seen & ~all;
		if ((must & seen) != 0 && lacking == 0)
			lacking = must & ~seen;
	}
	if (way[0] == NULL)
		return 0;
	if (extra == 0 && lacking == 0)
		way_bits(table, kind, way[0], &lacking);
	hint(said, table, kind, way, seen);
	for (all = extra != 0 ? extra : lacking; (all & 1) == 0; all >>= 1)
		table++;
	struct value m = value_missing(v, table->name);

	value_refuse(&m, "%s; %s",
	    extra != 0 ? "does not go with the others" : "missing", said);
}
