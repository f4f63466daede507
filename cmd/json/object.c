/* SPDX-License-Identifier: MIT */
#include "object.h"

#include <ctype.h>
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

/* Whether the member of a document that is an object alone is the scene's. */
static bool is_beside(const struct value *v, const struct member *table)
{
	const struct member *scene = v->source->scene;

	if (v->in->in != NULL || table == scene)
		return false;
	const struct member *row = member_of(scene, 0, v->name);

	return row != NULL && row->beside;
}

uint64_t member_bit(const struct member *table, int kind, const char *name)
{
	const struct member *row = member_of(table, kind, name);

	return row != NULL ? UINT64_C(1) << (row - table) : 0;
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
		if (member_is_of(row, kind) && listed(row->aliases, plain))
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

/* The member that was probably meant by a wrong name, or NULL. */
static const struct member *meant(const struct member *table, int kind,
    const char *name)
{
	const char *names[MEMBERS_MAX + 1];
	const struct member *row = find_alias(table, kind, name);

	if (row != NULL)
		return row;
	list_names(table, kind, ALL_MEMBERS, names);
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

/* Refuses a member that other objects of the scene have, or the first of them as
 * an alias, or the scene itself. */
static void refuse_misplaced(const struct value *v, const struct member *table)
{
	const char *names[MEMBERS_MAX + 1], *in = NULL;
	const struct member *scene = v->source->scene, *row = NULL, *s;
	char all[LISTED];
	int n = 0;

	for (s = scene; s->name != NULL; s++) {
		if (s->members == NULL || s->members == table)
			continue;
		if (member_of(s->members, ANY_KIND, v->name) != NULL)
			names[n++] = s->name;
		if (row == NULL) {
			row = find_alias(s->members, 0, v->name);
			in = s->name;
		}
	}
	names[n] = NULL;
	if (n > 0)
		value_refuse(v, "unknown member; it belongs in %s",
		    list_words(all, names, " or ", "\""));
	if (row != NULL)
		value_refuse(v, "unknown member; \"%s\" has %s", in,
		    described(row, all));
	if (v->in->name != NULL && table != scene &&
	    member_of(scene, 0, v->name) != NULL)
		value_refuse(v, "unknown member; it stands beside \"%s\"",
		    v->in->name);
}

static _Noreturn void refuse_unknown(const struct value *v,
    const struct member *table, int kind)
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
	list_names(table, kind, ALL_MEMBERS, names);
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
	bool beside = false;

	value_want_object(v);
	for (const struct member *row = table; row->name != NULL; row++)
		if (base != NULL && row->usual != NULL && row->type->size > 0 &&
		    member_is_of(row, kind))
			read_usual(row, (char *)base + row->at);
	struct value m = value_child(v);

	for (; m.item != NULL; value_next(&m)) {
		if (is_ignored(m.name))
			continue;
		uint64_t bit = member_bit(table, kind, m.name);
		bool other = is_beside(&m, table);

		if (bit == 0 && !other)
			refuse_unknown(&m, table, kind);
		if (other ? beside : (seen & bit) != 0)
			value_refuse(&m, "repeated; give it once");
		seen |= bit;
		beside |= other;
		if (!other && base != NULL)
			object_read_member(&m, member_of(table, kind, m.name),
			    base);
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

/* The first member of bits. */
static const struct member *lowest(const struct member *table, uint64_t bits)
{
	while ((bits & 1) == 0) {
		bits >>= 1;
		table++;
	}
	return table;
}

/* Writes which members to give, those seen among them that may be missing. */
static const char *hint(char out[LISTED], const struct member *table, int kind,
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
	return out;
}

/* Refuses the first of the extra members, which are not of the way taken: "not
 * together with" a member taken that stands in no way with it, if there is one,
 * else with the first member taken. */
static _Noreturn void refuse_extra(const struct value *v,
    const struct member *table, int kind, uint64_t taken, uint64_t extra,
    const char *const *way)
{
	uint64_t must, rivals = taken, seen = taken | extra;
	char all[LISTED];

	extra &= ~extra + 1;
	for (int i = 0; way[i] != NULL; i++) {
		uint64_t bits = way_bits(table, kind, way[i], &must);

		if (bits & extra)
			rivals &= ~bits;
	}
	struct value m = value_missing(v, lowest(table, extra)->name);

	value_refuse(&m, "not together with \"%s\"; %s",
	    lowest(table, rivals != 0 ? rivals : taken)->name,
	    hint(all, table, kind, way, seen));
}

int object_way(const struct value *v, const struct member *table, int kind,
    uint64_t seen, const struct ways *w)
{
	bool fit = v->source->fit && w->fit && !v->unused;
	const char *const *way = fit ? w->fit_way : w->way;
	uint64_t taken = 0, extra = 0, lacking = 0, must, all;
	char said[LISTED];

	seen &= ways_bits(table, kind, way);
	for (int i = 0; way[i] != NULL; i++) {
		all = way_bits(table, kind, way[i], &must);
		if ((must & ~seen) == 0 && (seen & ~all) == 0)
			return i;
		if ((must & ~seen) == 0 && (all & seen) != 0 && extra == 0) {
			taken = seen & all;
			extra = seen & ~all;
		}
		if ((must & seen) != 0 && lacking == 0)
			lacking = must & ~seen;
	}
	if (way[0] == NULL)
		return 0;
	if (extra != 0)
		refuse_extra(v, table, kind, taken, extra, way);
	if (lacking == 0)
		way_bits(table, kind, way[0], &lacking);
	struct value m = value_missing(v, lowest(table, lacking)->name);

	value_refuse(&m, "missing; %s", hint(said, table, kind, way, seen));
}
