/* SPDX-License-Identifier: MIT */
#include "object.h"

#include <stdio.h>
#include <string.h>

#include "../message/escape.h"

/* The most rows of a table of members: a uint64_t has a bit for each row. */
enum { MEMBERS_MAX = 64 };

/* Returns whether `variant` is ANY_VARIANT or in `variants`, which is 0 (all variants) or bits. */
static bool has_variant(unsigned variants, int variant)
{
	return variant == ANY_VARIANT || variants == 0 ||
	    (variants >> variant & 1) != 0;
}

const struct member *member_named(const struct member *row, int variant,
    const char *name, bool alias)
{
	for (; row != NULL && row->name != NULL; row++)
		if (has_variant(row->variants, variant) &&
		    (strcmp(row->name, name) == 0 ||
			(alias &&
			    (word_is_one_of(name, row->name) ||
				word_is_one_of(name, row->aliases)))))
			return row;
	return NULL;
}

uint64_t member_bits(const struct member *table, int variant, const char *names,
    bool required)
{
	uint64_t bits = 0;
	char name[ESCAPED_MAX];

	for (; *names != '\0'; names += strspn(names, " ?")) {
		size_t n = strcspn(names, " ?");

		memcpy(name, names, n);
		name[n] = '\0';
		names += n;
		const struct member *row = member_named(table, variant, name,
		    false);

		if (row != NULL && !(required && *names == '?'))
			bits |= UINT64_C(1) << (row - table);
	}
	return bits;
}

const char *member_type_name(const struct member *row, char out[LIST_ROOM])
{
	if (row->type->name != NULL)
		return row->type->name;
	if (row->members != NULL)
		return "object";
	if (row->words != NULL)
		return words_join(out, row->words, " or ", "");
	if (row->type->number_size == sizeof(bool))
		return "true or false";
	const bool size = row->range != NULL &&
	    row->range->min == range_positive.min &&
	    row->range->max == range_positive.max;
	const char *one = size                                     ? "size" :
	    row->unit != NULL && strcmp(row->unit, "degrees") == 0 ? "angle" :
								     "number";

	if (row->n == 0)
		return one;
	snprintf(out, LIST_ROOM, "%zu %ss", row->n, one);
	return out;
}

/* Fills `names` with the members in `bits` that objects of the variant have, and NULL. */
static void list_names(const struct member *row, int variant, uint64_t bits,
    const char *names[MEMBERS_MAX + 1])
{
	int n = 0;

	for (; row->name != NULL; row++, bits >>= 1)
		if ((bits & 1) != 0 && has_variant(row->variants, variant))
			names[n++] = row->name;
	names[n] = NULL;
}

/* Refuses v, a member that the table lacks, unless any document may have it. The remedy
 * is the first of these: the member that has v->name as an alias; a remark of word_hint;
 * other objects of the scene that have a member v->name or else an alias v->name; the
 * scene, which has a member v->name; a near name in the table; all of its names. */
static void check_unknown(const struct value *v, const struct member *table,
    int variant)
{
	const struct member *row = member_named(table, variant, v->name, true);
	const struct member *scene = v->source->scene_members;
	const struct member *of_scene = member_named(scene, 0, v->name, false);
	const char *names[MEMBERS_MAX + 1];
	const char *hint = word_hint(v->name, WORD_MEMBER, '\0');
	struct word_guess g = { .word = v->name };
	char list[LIST_ROOM];
	int n = 0;

	if (of_scene != NULL && of_scene->in_any_document &&
	    v->parent->parent == NULL)
		return;
	if (row != NULL)
		word_offer(&g, WORD_KNOWN, "did you mean \"%s\"%s?", row->name,
		    row->hint != NULL ? row->hint : "");
	if (hint != NULL)
		word_offer(&g, WORD_KNOWN, "%s", hint + 2);
	for (int alias = 0; alias < 2 && n == 0; alias++)
		for (const struct member *s = scene; s->name != NULL; s++)
			if (s->members != table &&
			    member_named(s->members, ANY_VARIANT, v->name,
				alias) != NULL)
				names[n++] = s->name;
	names[n] = NULL;
	if (n > 0)
		word_offer(&g, WORD_KNOWN, "it belongs in %s",
		    words_join(list, names, " or ", "\""));
	if (v->parent->parent != NULL && of_scene != NULL)
		word_offer(&g, WORD_KNOWN, "it stands beside \"%s\"",
		    v->parent->name);
	list_names(table, variant, ALL_MEMBERS, names);
	word_offer_list(&g, names, "did you mean \"%s\"?");
	word_offer(&g, WORD_ELSE, "there are %s",
	    words_join(list, names, " and ", "\""));
	value_refuse(v, "unknown member; %s", g.remedy);
}

static void read_default(const struct member *row, void *to)
{
	struct value fallback = value_literal(row->fallback);

	row->type->read(&fallback, row, to);
}

void object_read_member(const struct value *v, const struct member *row,
    void *base)
{
	row->type->read(v, row, (char *)base + row->offset);
	if (row->flag != 0)
		*(bool *)((char *)base + row->flag) = true;
}

/* A list of ways (see struct ways) for one variant of object. In a set of members, bit i
 * is row i of the table. */
struct way_bits {
	const char *const *list;
	const struct member *table;
	int variant;
	size_t n;
	uint64_t all_members;        /* of all ways */
	uint64_t members[WAYS_MAX];  /* of each way */
	uint64_t required[WAYS_MAX]; /* of each way, without optional ones */
};

/* Returns the bits of a list of ways for a variant of object. They stay in `kept`, which
 * has more elements than the tables have pairs of a list and a variant. */
static const struct way_bits *find_way_bits(const struct member *table,
    int variant, const char *const *list)
{
	static struct way_bits kept[64];
	struct way_bits *b = kept;

	while (b->list != NULL && (b->list != list || b->variant != variant))
		b++;
	if (b->list != NULL)
		return b;
	*b = (struct way_bits){ .list = list,
		.table = table,
		.variant = variant };
	for (; *list != NULL; list++, b->n++) {
		b->members[b->n] = member_bits(table, variant, *list, false);
		b->required[b->n] = member_bits(table, variant, *list, true);
		b->all_members |= b->members[b->n];
	}
	return b;
}

/* Writes the names of the members in `bits`. Returns `out`. */
static const char *write_names(char out[LIST_ROOM], const struct way_bits *b,
    uint64_t bits)
{
	const char *names[MEMBERS_MAX + 1];

	list_names(b->table, b->variant, bits, names);
	return words_join(out, names, " and ", "\"");
}

/* Writes all ways: "give A and B, or C". Omits optional members that are not given. */
static void write_ways(char out[LIST_ROOM], const struct way_bits *b,
    uint64_t given)
{
	char all[LIST_ROOM];
	size_t n = 0;

	for (size_t i = 0; i < b->n && n < LIST_ROOM; i++) {
		write_names(all, b, b->members[i] & (b->required[i] | given));
		n += (size_t)snprintf(out + n, LIST_ROOM - n, "%s%s",
		    i > 0 ? ", or " : "give ",
		    *all != '\0' ? all : "none of them");
	}
}

/* Refuses the object v because of m, the first member in `members`. If `way` is 0, v
 * lacks m. If not, the given members complete a way, which m does not belong to; `way`
 * has the given members of that way, as bits. */
static _Noreturn void refuse_way(const struct value *v,
    const struct way_bits *b, uint64_t given, uint64_t members, uint64_t way)
{
	const int first = __builtin_ctzll(members);
	const struct value *m = VALUE_MISSING(v, b->table[first].name);
	char ways[LIST_ROOM], rivals[LIST_ROOM];
	uint64_t others = way;

	write_ways(ways, b, given);
	if (way == 0)
		value_refuse(m, "missing; %s", ways);
	for (size_t i = 0; i < b->n; i++)
		if (b->members[i] >> first & 1)
			others &= ~b->members[i];
	value_refuse(m, "does not go with %s; %s",
	    write_names(rivals, b, others != 0 ? others : way), ways);
}

int object_way(const struct value *v, const struct member *table, int variant,
    uint64_t given, const struct ways *w)
{
	bool fit = !v->unused &&
	    ((v->source->for_fit && w->own_fit) ||
		(v->source->for_plane && w->plane_as_fit));
	const struct way_bits *b = find_way_bits(table, variant,
	    fit ? w->fit_way : w->way);
	uint64_t extra = 0, lacking = 0, way = 0;

	given &= b->all_members;
	for (size_t i = 0; i < b->n; i++) {
		uint64_t missing = b->required[i] & ~given,
			 in = b->members[i] & given;

		if (missing == 0 && in == given)
			return (int)i;
		if (missing == 0 && in != 0 && extra == 0) {
			extra = given & ~in;
			way = in;
		}
		if (missing != b->required[i] && lacking == 0)
			lacking = missing;
	}
	if (b->n == 0)
		return 0;
	if (extra == 0 && lacking == 0)
		lacking = b->required[0];
	refuse_way(v, b, given, extra != 0 ? extra : lacking, way);
}

uint64_t object_read(const struct value *v, const struct member *row,
    int variant, void *base)
{
	const struct member *table = row->members;
	const struct ways *w = row->ways;
	uint64_t given = 0;

	if (!value_is(v, JSON_OBJECT))
		value_refuse_type(v, "an object");
	for (const struct member *m = table; m->name != NULL; m++)
		if (base != NULL && m->fallback != NULL &&
		    m->type->number_size > 0 &&
		    has_variant(m->variants, variant))
			read_default(m, (char *)base + m->offset);
	struct value m = value_child(v), first;

	for (; m.item != NULL; value_next(&m)) {
		const struct member *known = member_named(table, variant,
		    m.name, false);

		if (*m.name == '_' || strcmp(m.name, "$schema") == 0)
			continue;
		if (known == NULL)
			check_unknown(&m, table, variant);
		value_member(v, m.name, &first);
		if (first.item != m.item)
			value_refuse(&m, "repeated; give it once");
		if (known == NULL)
			continue;
		given |= UINT64_C(1) << (known - table);
		if (base != NULL)
			object_read_member(&m, known, base);
	}
	for (; w != NULL && w->way[0] != NULL; w++) {
		if (!has_variant(w->variants, variant))
			continue;
		int way = object_way(v, table, variant, given, w);

		if (base != NULL && w->offset != 0)
			*(unsigned *)(void *)((char *)base +
			    w->offset) = w->way_0 + (unsigned)way;
	}
	return given;
}

/* Returns whether object_print leaves out a member with the value *at: a default that
 * is not always shown, or a size of 0, which means that no size was given. */
static bool is_omitted(const struct member *row, const void *at)
{
	const double *v = at;
	double fallback[4];

	if (row->fallback == NULL && row->range == &range_positive)
		return *v == 0;
	if (row->fallback == NULL || row->shown || row->type->number_size == 0)
		return false;
	read_default(row, fallback);
	if (row->type->number_size != sizeof *v)
		return memcmp(fallback, at, row->type->number_size) == 0;
	for (size_t i = 0; i == 0 || i < row->n; i++)
		if (v[i] != fallback[i])
			return false;
	return true;
}

void object_print(struct printer *p, const struct member *row, int variant,
    uint64_t bits, const void *base)
{
	const struct ways *w = row->ways;
	const char *at = base;

	for (; w != NULL && w->way[0] != NULL; w++) {
		if (w->offset == 0 || !has_variant(w->variants, variant))
			continue;
		const struct way_bits *b = find_way_bits(row->members, variant,
		    w->way);
		const unsigned *way = (const void *)(at + w->offset);

		bits &= ~b->all_members | b->members[*way - w->way_0];
	}
	put_open(p, "{");
	for (row = row->members; row->name != NULL; row++, bits >>= 1) {
		bool has = row->flag == 0 || *(const bool *)(at + row->flag);

		if ((bits & 1) == 0 || !has ||
		    !has_variant(row->variants, variant) ||
		    is_omitted(row, at + row->offset))
			continue;
		row->type->print(put_name(p, row->name), row, at + row->offset);
	}
	put_close(p, "}");
}
