/* SPDX-License-Identifier: MIT */
#include "object.h"

#include <stdio.h>
#include <string.h>

#include "../message/utf8.h"

/* The most rows of a table: members are bits. */
enum { MEMBERS_MAX = 64 };

/* Returns whether kinds, a row's bits, have the kind; 0 stands for all kinds. */
static bool is_of(unsigned kinds, int kind)
{
	return kind == ANY_KIND || kinds == 0 || (kinds >> kind & 1) != 0;
}

const struct member *member_of(const struct member *row, int kind,
    const char *name)
{
	for (; row->name != NULL; row++)
		if (is_of(row->kinds, kind) && strcmp(row->name, name) == 0)
			return row;
	return NULL;
}

uint64_t member_bits(const struct member *table, int kind, const char *names,
    bool needed)
{
	uint64_t bits = 0;
	char name[ESCAPED_MAX];

	for (; *names != '\0'; names += strspn(names, " ?")) {
		size_t n = strcspn(names, " ?");

		memcpy(name, names, n);
		name[n] = '\0';
		names += n;
		const struct member *row = member_of(table, kind, name);

		if (row != NULL && !(needed && *names == '?'))
			bits |= UINT64_C(1) << (row - table);
	}
	return bits;
}

const struct member *member_named(const struct member *table, int kind,
    const char *name)
{
	const struct member *row = member_of(table, kind, name);

	for (; row == NULL && table->name != NULL; table++)
		if (table->aliases != NULL && is_of(table->kinds, kind) &&
		    word_is_one_of(name, table->aliases))
			row = table;
	return row;
}

const char *member_type(const struct member *row, char out[LISTED])
{
	if (row->type->name != NULL)
		return row->type->name;
	if (row->members != NULL)
		return "object";
	if (row->words != NULL)
		return list_words(out, row->words, " or ", "");
	if (row->type->size == sizeof(bool))
		return "true or false";
	const char *one = row->range == &range_positive            ? "size" :
	    row->unit != NULL && strcmp(row->unit, "degrees") == 0 ? "angle" :
								     "number";

	if (row->n == 0)
		return one;
	snprintf(out, LISTED, "%zu %ss", row->n, one);
	return out;
}

/* Lists the names of the members in bits that objects of that kind have. */
static void list_names(const struct member *row, int kind, uint64_t bits,
    const char *names[MEMBERS_MAX + 1])
{
	int n = 0;

	for (; row->name != NULL; row++, bits >>= 1)
		if ((bits & 1) != 0 && is_of(row->kinds, kind))
			names[n++] = row->name;
	names[n] = NULL;
}

/* Refuses an unknown member, unless it may stand beside the members of the table. The
 * message names the first of these that exists: the member with that alias, the other
 * objects of the scene that have the member, the scene itself, the member with the
 * nearest name; else all members. */
static void check_unknown(const struct value *v, const struct member *table,
    int kind)
{
	const struct member *row = member_named(table, kind, v->name);
	const struct member *s = v->source->scene;
	const struct member *beside = member_of(s, 0, v->name);
	const char *names[MEMBERS_MAX + 1];
	char all[LISTED];
	int n = 0;

	if (beside != NULL && beside->beside && v->in->in == NULL)
		return;
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
	if (v->in->in != NULL && beside != NULL)
		value_refuse(v, "unknown member; it stands beside \"%s\"",
		    v->in->name);
	list_names(table, kind, ALL_MEMBERS, names);
	const char *near = nearest_word(v->name, names);

	if (near != NULL)
		value_refuse(v, "unknown member; did you mean \"%s\"?", near);
	value_refuse(v, "unknown member; there are %s",
	    list_words(all, names, " and ", "\""));
}

/* Reads the default of a member. */
static void read_usual(const struct member *row, void *to)
{
	struct value usual = value_literal(row->usual);

	row->type->read(&usual, row, to);
}

void object_read_member(const struct value *v, const struct member *row,
    void *base)
{
	row->type->read(v, row, (char *)base + row->at);
	if (row->has != 0)
		*(bool *)((char *)base + row->has) = true;
}

/* A list of ways as bits of members, for one kind of object. */
struct way_bits {
	const char *const *list;
	const struct member *table;
	int kind;
	size_t n;
	uint64_t any;            /* the members of all ways */
	uint64_t all[WAYS_MAX];  /* the members of each way */
	uint64_t must[WAYS_MAX]; /* those of them that may not be missing */
};

/* Returns the bits of a list of ways for a kind, made once and kept: reading a scene
 * needs about ten lists. The tables have 24 pairs of a list and a kind. */
static const struct way_bits *list_bits(const struct member *table, int kind,
    const char *const *list)
{
	static struct way_bits known[64];
	struct way_bits *b = known;

	while (b->list != NULL && (b->list != list || b->kind != kind))
		b++;
	if (b->list != NULL)
		return b;
	*b = (struct way_bits){ .list = list, .table = table, .kind = kind };
	for (; *list != NULL; list++, b->n++) {
		b->all[b->n] = member_bits(table, kind, *list, false);
		b->must[b->n] = member_bits(table, kind, *list, true);
		b->any |= b->all[b->n];
	}
	return b;
}

/* Writes the names of the members in bits. Returns out. */
static const char *write_names(char out[LISTED], const struct way_bits *b,
    uint64_t bits)
{
	const char *names[MEMBERS_MAX + 1];

	list_names(b->table, b->kind, bits, names);
	return list_words(out, names, " and ", "\"");
}

/* Writes "give ..." with each way: its members that may not be missing, and its other
 * members that are seen. */
static void write_ways(char out[LISTED], const struct way_bits *b,
    uint64_t seen)
{
	char all[LISTED];
	size_t n = 0;

	for (size_t i = 0; i < b->n && n < LISTED; i++) {
		write_names(all, b, b->all[i] & (b->must[i] | seen));
		n += (size_t)snprintf(out + n, LISTED - n, "%s%s",
		    i > 0 ? ", or " : "give ",
		    *all != '\0' ? all : "none of them");
	}
}

/* Refuses an object for the first of members. If way is 0, this member is missing. Else
 * way has the given members of a complete way, to which this member does not belong. */
static _Noreturn void refuse_way(const struct value *v,
    const struct way_bits *b, uint64_t seen, uint64_t members, uint64_t way)
{
	const int first = __builtin_ctzll(members);
	const struct value *m = VALUE_MISSING(v, b->table[first].name);
	char ways[LISTED], rivals[LISTED];
	uint64_t others = way;

	write_ways(ways, b, seen);
	if (way == 0)
		value_refuse(m, "missing; %s", ways);
	for (size_t i = 0; i < b->n; i++)
		if (b->all[i] >> first & 1)
			others &= ~b->all[i];
	value_refuse(m, "does not go with %s; %s",
	    write_names(rivals, b, others != 0 ? others : way), ways);
}

int object_way(const struct value *v, const struct member *table, int kind,
    uint64_t seen, const struct ways *w)
{
	bool fit = v->source->fit && w->fit && !v->unused;
	const struct way_bits *b = list_bits(table, kind,
	    fit ? w->fit_way : w->way);
	uint64_t extra = 0, lacking = 0, way = 0;

	seen &= b->any;
	for (size_t i = 0; i < b->n; i++) {
		uint64_t missing = b->must[i] & ~seen, in = b->all[i] & seen;

		if (missing == 0 && in == seen)
			return (int)i;
		if (missing == 0 && in != 0 && extra == 0) {
			extra = seen & ~in;
			way = in;
		}
		if (missing != b->must[i] && lacking == 0)
			lacking = missing;
	}
	if (b->n == 0)
		return 0;
	if (extra == 0 && lacking == 0)
		lacking = b->must[0];
	refuse_way(v, b, seen, extra != 0 ? extra : lacking, way);
}

uint64_t object_read(const struct value *v, const struct member *row, int kind,
    void *base)
{
	const struct member *table = row->members;
	const struct ways *w = row->ways;
	uint64_t seen = 0;

	if (!value_is(v, JSON_OBJECT))
		value_wrong(v, "an object");
	for (const struct member *m = table; m->name != NULL; m++)
		if (base != NULL && m->usual != NULL && m->type->size > 0 &&
		    is_of(m->kinds, kind))
			read_usual(m, (char *)base + m->at);
	struct value m = value_child(v), first;

	for (; m.item != NULL; value_next(&m)) {
		const struct member *of = member_of(table, kind, m.name);

		if (*m.name == '_' || strcmp(m.name, "$schema") == 0)
			continue;
		if (of == NULL)
			check_unknown(&m, table, kind);
		value_member(v, m.name, &first);
		if (first.item != m.item)
			value_refuse(&m, "repeated; give it once");
		if (of == NULL)
			continue;
		seen |= UINT64_C(1) << (of - table);
		if (base != NULL)
			object_read_member(&m, of, base);
	}
	for (; w != NULL && w->way[0] != NULL; w++) {
		if (!is_of(w->kinds, kind))
			continue;
		int way = object_way(v, table, kind, seen, w);

		if (base != NULL && w->at != 0)
			*(unsigned *)(void *)((char *)base + w->at) = w->first +
			    (unsigned)way;
	}
	return seen;
}

/* Returns whether the member with the value *at is left out, because it has its default
 * or is a size of 0. */
static bool is_usual(const struct member *row, const void *at)
{
	const double *v = at;
	double usual[4];

	if (row->usual == NULL && row->range == &range_positive)
		return *v == 0;
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

void object_print(struct printer *p, const struct member *row, int kind,
    uint64_t bits, const void *base)
{
	const struct ways *w = row->ways;
	const char *at = base;

	for (; w != NULL && w->way[0] != NULL; w++) {
		if (w->at == 0 || !is_of(w->kinds, kind))
			continue;
		const struct way_bits *b = list_bits(row->members, kind,
		    w->way);
		const unsigned *way = (const void *)(at + w->at);

		bits &= ~b->any | b->all[*way - w->first];
	}
	put_open(p, "{");
	for (row = row->members; row->name != NULL; row++, bits >>= 1) {
		bool has = row->has == 0 || *(const bool *)(at + row->has);

		if ((bits & 1) == 0 || !has || !is_of(row->kinds, kind) ||
		    is_usual(row, at + row->at))
			continue;
		put_name(p, row->name);
		row->type->print(p, row, at + row->at);
	}
	put_close(p, "}");
}
