/* SPDX-License-Identifier: MIT */
#include "object.h"

#include <stdio.h>
#include <string.h>

#include "../message/escape.h"

/* The most rows of a table of members: a uint64_t has a bit for each row. */
enum { MEMBERS_MAX = 64 };

/* Returns whether `variant` is ANY_VARIANT or in `variants`, which is 0 (all variants)
 * or bits. */
static bool has_variant(unsigned variants, int variant)
{
	return variant == ANY_VARIANT || variants == 0 ||
	    (variants >> variant & 1) != 0;
}

const struct member *member_named(const struct member *row, int variant,
    const char *name, bool alias)
{
	for (const struct member *m = row; m != NULL && m->name != NULL; m++)
		if (has_variant(m->variants, variant) && strcmp(m->name, name) == 0)
			return m;
	for (; alias && row != NULL && row->name != NULL; row++)
		if (has_variant(row->variants, variant) &&
		    (word_is_one_of(name, row->name) ||
			word_is_one_of(name, row->aliases)))
			return row;
	return NULL;
}

/* The members of a list of names, as bits: those without !, those that an object of the
 * way must have, those that it may leave to the scene, and those with !. */
struct way {
	uint64_t all, required, left, never;
};

/* `fit`: the members with ~ may be missing. */
static struct way way_find(const struct member *table, int variant, bool fit,
    const char *names)
{
	struct way way = { 0 };
	char name[ESCAPED_MAX];

	for (; *names != '\0'; names += *names == ' ') {
		size_t n = strcspn(names, " ?~|!");

		memcpy(name, names, n);
		name[n] = '\0';
		names += n;
		const struct member *row = member_named(table, variant, name, false);
		const uint64_t bit = row != NULL ? UINT64_C(1) << (row - table) : 0;
		const bool fitted = *names == '~' && fit;

		names += *names == '~';
		*(*names == '!' ? &way.never : &way.all) |= bit;
		if (*names == '|' && !fitted)
			way.left |= bit;
		else if (*names <= ' ' && !fitted)
			way.required |= bit;
		names += strcspn(names, " ");
	}
	return way;
}

uint64_t member_bits(const struct member *table, int variant, const char *names)
{
	return way_find(table, variant, false, names).all;
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
	const bool size = row->range != NULL && row->range->min == range_positive.min &&
	    row->range->max == range_positive.max;
	const char *one = size                                     ? "size" :
	    row->unit != NULL && strcmp(row->unit, "degrees") == 0 ? "angle" :
								     "number";

	if (row->n == 0)
		return one;
	snprintf(out, LIST_ROOM, "%zu %ss", row->n, one);
	return out;
}

static void list_names(const struct member *row, int variant, uint64_t bits,
    const char *names[MEMBERS_MAX + 1])
{
	int n = 0;

	for (; row->name != NULL; row++, bits >>= 1)
		if ((bits & 1) != 0 && has_variant(row->variants, variant))
			names[n++] = row->name;
	names[n] = NULL;
}

static const struct value *root_of(const struct value *v)
{
	return v->parent != NULL ? root_of(v->parent) : v;
}

/* Offers the objects of the scene that have a member v->name, or an alias of it: those
 * with the very name, before those that the document has or the command uses, before
 * others. If only one type of an object has it, and the document lacks the object,
 * names the type. */
static void offer_objects(const struct value *v, const struct member *table,
    struct word_guess *g)
{
	const struct json_source *source = v->source;
	const struct member *row = NULL, *object = NULL;
	const struct member *scene = source->scene_members;
	const char *names[MEMBERS_MAX + 1];
	char list[LIST_ROOM], type[64] = "";
	unsigned best = 0, n = 0;
	struct value given;

	for (const struct member *s = scene; s->name != NULL; s++) {
		const struct member *m = s->members == table ?
		    NULL :
		    member_named(s->members, ANY_VARIANT, v->name, true);

		if (m == NULL)
			continue;
		const bool meant = value_member(root_of(v), s->name, &given) ||
		    (source->used >> (s - scene) & 1) != 0;
		const unsigned fit = (strcmp(m->name, v->name) == 0) * 4u + meant * 2u +
		    1;

		if (fit > best)
			n = 0;
		if (fit >= best) {
			best = fit;
			row = m;
			object = s;
			names[n++] = s->name;
		}
	}
	names[n] = NULL;
	/* of several types none is likelier */
	if (n == 1 && row->variants != 0 &&
	    (row->variants & (row->variants - 1)) == 0 &&
	    !value_member(root_of(v), *names, &given))
		snprintf(type, sizeof type, ": {\"type\": \"%s\", ...}",
		    object->members->words[__builtin_ctz(row->variants)]);
	if (n == 1 && strcmp(row->name, v->name) != 0)
		word_offer(g, WORD_KNOWN, "it is \"%s\" in \"%s\"%s%s", row->name,
		    *names, type, row->hint != NULL ? row->hint : "");
	if (n > 0)
		word_offer(g, WORD_KNOWN, "it belongs in %s%s",
		    words_join(list, names, " or ", "\""), type);
}

/* Offers the types of an object, as words of its first member, that have v->name. */
static void offer_variants(const struct value *v, const struct member *table,
    struct word_guess *g)
{
	const struct member *row = member_named(table, ANY_VARIANT, v->name, false);
	const char *names[MEMBERS_MAX + 1];
	char list[LIST_ROOM];
	unsigned variants = 0;
	int n = 0;

	for (; row != NULL && row->name != NULL; row++)
		if (strcmp(row->name, v->name) == 0)
			variants |= row->variants;
	for (; variants != 0; variants &= variants - 1)
		names[n++] = table->words[__builtin_ctz(variants)];
	names[n] = NULL;
	if (n > 0)
		word_offer(g, WORD_KNOWN, "only %s %s it",
		    words_join(list, names, " and ", "\""), n > 1 ? "have" : "has");
}

/* Offers what v, a member that the table lacks, may mean, the first of these: the
 * member that has v->name as an alias; a remark of word_hint about v->name or its text;
 * types that have it; other objects of the scene; a member of the scene; a near name in
 * the table; all of its names. Returns the row of the alias or the near name, or NULL. */
static const struct member *offer_members(const struct value *v,
    const struct member *table, int variant, struct word_guess *g)
{
	const struct member *row = member_named(table, variant, v->name, true);
	const struct member *of_scene = member_named(v->source->scene_members, 0,
	    v->name, true);
	const char *names[MEMBERS_MAX + 1];
	/* the "type" of GeoJSON tells more than its name */
	const char *text = value_string(v),
		   *said = text != NULL ? word_hint(text, WORD_MEMBER, ':') : NULL;
	const char *hint = said != NULL ? said : word_hint(v->name, WORD_MEMBER, ':');
	char list[LIST_ROOM];

	/* no array is meant for a number: D is a lens's, not the d of some books */
	if (row != NULL && hint != NULL && value_is(v, JSON_ARRAY) && row->n == 0 &&
	    row->type->number_size == sizeof(double))
		row = NULL;
	if (row != NULL)
		word_offer(g, WORD_KNOWN, "did you mean \"%s\"%s%s?", row->name,
		    row->hint == NULL && row->example != NULL ? ", as " : "",
		    row->hint != NULL        ? row->hint :
			row->example != NULL ? row->example :
					       "");
	if (hint != NULL)
		word_offer(g, WORD_KNOWN, "%s", hint + 2);
	offer_variants(v, table, g);
	offer_objects(v, table, g);
	if (v->parent->parent != NULL && of_scene != NULL)
		word_offer(g, WORD_KNOWN,
		    strcmp(of_scene->name, v->name) == 0 ?
			"it stands beside \"%s\"" :
			"it is \"%2$s\", beside \"%1$s\"",
		    v->parent->name, of_scene->name);
	const bool known = g->closeness == WORD_KNOWN;

	list_names(table, variant, ALL_MEMBERS, names);
	word_offer_list(g, names, "did you mean \"%s\"?");
	for (const struct member *m = table; !known && row == NULL && m->name != NULL;
	     m++)
		if (g->closeness > 0 && has_variant(m->variants, variant) &&
		    word_closeness(v->name, m->name) == g->closeness)
			row = m;
	word_offer(g, WORD_ELSE, "there are %s",
	    words_join(list, names, " and ", "\""));
	return row;
}

/* Returns whether an unknown member is no error: $schema, a name that begins with _ and,
 * in the outermost object, a member that any document may have. */
static bool is_ignored(const struct value *v)
{
	const struct member *row = member_named(v->source->scene_members, 0, v->name,
	    false);

	return *v->name == '_' || strcmp(v->name, "$schema") == 0 ||
	    (row != NULL && row->in_any_document && v->parent->parent == NULL);
}

const struct member *object_meant(const struct value *v, const struct member *table,
    int variant)
{
	struct word_guess g = { .word = v->name };

	return is_ignored(v) ? NULL : offer_members(v, table, variant, &g);
}

/* Tells what the unknown member v may mean, and returns what object_meant does. */
static const struct member *tell_unknown(const struct value *v,
    const struct member *table, int variant)
{
	struct word_guess g = { .word = v->name };
	const struct member *row = ++json_faults.unknown > UNKNOWN_TOLD_MAX ?
	    NULL :
	    offer_members(v, table, variant, &g);

	value_fault(v, "unknown member; %s", g.remedy);
	return row;
}

/* Reads the default of a row to a field; keeps it for the next object. */
static void read_default(const struct member *row, void *to)
{
	enum { KEPT = 4 * MEMBERS_MAX };
	static struct kept {
		const struct member *row;
		double field[4];
	} kept[KEPT];
	struct kept *k = &kept[(uintptr_t)row / sizeof *row % KEPT];

	if (k->row != row) {
		const struct value fallback = value_literal(row->fallback);

		row->type->read(&fallback, row, k->field);
		k->row = row;
	}
	memcpy(to, k->field, row->type->number_size * (row->n > 0 ? row->n : 1));
}

void object_attempt(void (*read)(const struct value *, const struct member *, void *),
    const struct value *v, const struct member *row, void *out)
{
	jmp_buf here, *const outer = json_faults.next;

	json_faults.next = &here;
	if (setjmp(here) == 0)
		read(v, row, out);
	json_faults.next = outer;
}

void object_read_member(const struct value *v, const struct member *row, void *base)
{
	if (row->flag != 0)
		*(bool *)((char *)base + row->flag - 1) = true;
	object_attempt(row->type->read, v, row, (char *)base + row->offset);
}

/* A rule for one variant of object, for the task of fit or for others. In a set of
 * members, bit i is row i of the table. */
struct rule_bits {
	struct rule_bits *next;
	const struct rule *rule;
	const struct member *table;
	int variant;
	bool fit;
	uint64_t all;    /* members of all ways */
	struct way with; /* of rule->with */
	size_t n;
	struct way way[];
};

/* Returns the bits of a rule, which are found once and kept. */
static const struct rule_bits *rule_find(const struct rule *rule,
    const struct member *table, int variant, bool fit)
{
	static struct rule_bits *kept;
	struct rule_bits *b = kept;
	size_t n = 0;

	while (b != NULL && (b->rule != rule || b->variant != variant || b->fit != fit))
		b = b->next;
	if (b != NULL)
		return b;
	while (rule->ways[n] != NULL)
		n++;
	b = xrealloc(NULL, sizeof *b + n * sizeof *b->way);
	*b = (struct rule_bits){ kept, rule, table, variant, fit, .n = n };
	kept = b;
	if (rule->with != NULL)
		b->with = way_find(table, variant, fit, rule->with);
	for (size_t i = 0; i < n; i++) {
		b->way[i] = way_find(table, variant, fit, rule->ways[i]);
		b->all |= b->way[i].all;
	}
	return b;
}

/* Writes all ways: "give A and B, or C". Omits optional members that are not given. */
static void write_ways(char out[LIST_ROOM], const struct rule_bits *b, uint64_t given)
{
	const char *names[MEMBERS_MAX + 1];
	char all[LIST_ROOM];
	size_t n = 0;

	for (size_t i = 0; i < b->n && n < LIST_ROOM; i++) {
		list_names(b->table, b->variant,
		    b->way[i].all & (b->way[i].required | given), names);
		words_join(all, names, " and ", "\"");
		n += (size_t)snprintf(out + n, LIST_ROOM - n, "%s%s",
		    i > 0 ? ", or " : "give ", *all != '\0' ? all : "none of them");
	}
}

/* Tells that the first of `members` is wrong in v. If `way` is 0, v lacks it; if not, it
 * is not of the way that v has, of which `way` has the given members. */
static void tell_way(const struct value *v, const struct rule_bits *b, uint64_t given,
    uint64_t members, uint64_t way)
{
	const int first = __builtin_ctzll(members);
	const struct value *m = VALUE_MISSING(v, b->table[first].name);
	const char *names[MEMBERS_MAX + 1];
	char ways[LIST_ROOM], rivals[LIST_ROOM];
	uint64_t others = way;

	write_ways(ways, b, given);
	const char *hint = b->rule->hint != NULL ? b->rule->hint : ways;

	if (way == 0) {
		value_fault(m, "missing; %s", hint);
		return;
	}
	for (size_t i = 0; i < b->n; i++)
		if (b->way[i].all >> first & 1)
			others &= ~b->way[i].all;
	list_names(b->table, b->variant, others != 0 ? others : way, names);
	value_fault(m, "does not go with %s; %s",
	    words_join(rivals, names, " and ", "\""),
	    b->rule->rivals != NULL ? b->rule->rivals : hint);
}

/* Returns the index of the way that the members of v are, or b->n if there is none. This
 * fault is told unless `quiet` is set, or it is a conflict with a member that v lacks,
 * and that an unknown one may mean. */
static size_t find_way(const struct value *v, const struct rule_bits *b,
    const struct found *found, bool quiet)
{
	const uint64_t given = (found->given | found->meant) & b->all;
	uint64_t extra = 0, lacking = 0, way = 0;

	for (size_t i = 0; i < b->n; i++) {
		const uint64_t required = b->way[i].required;
		uint64_t missing = required & ~given, in = b->way[i].all & given;

		if (missing == 0 && in == given)
			return i;
		if (missing == 0 && in != 0 && extra == 0) {
			extra = given & ~in;
			way = in;
		}
		if (missing != required && lacking == 0)
			lacking = missing;
	}
	if (extra == 0 && lacking == 0)
		lacking = b->way[0].required;
	if (extra != 0 && ((extra & found->meant) != 0 || (way & found->meant) != 0))
		quiet = true;
	if (!quiet)
		tell_way(v, b, given, extra != 0 ? extra : lacking, way);
	return b->n;
}

/* Returns the members that v leaves to another member of the scene. */
static uint64_t check_rule(const struct value *v, const struct rule *rule,
    const struct member *table, int variant, const struct found *found, bool quiet,
    void *base)
{
	const enum task task = v->unused ? TASK_WHOLE : v->source->task;
	const uint64_t given = found->given | found->meant;

	if (!has_variant(rule->variants, variant) ||
	    !has_variant(rule->tasks, (int)task))
		return 0;
	const struct rule_bits *b = rule_find(rule, table, variant, task == TASK_FIT);

	if ((b->with.all != 0 && (b->with.all & given) == 0) ||
	    (b->with.never & given) != 0)
		return 0;
	const size_t way = find_way(v, b, found, quiet);

	if (way == b->n)
		return 0;
	if (base != NULL && rule->field != 0)
		*(unsigned *)(void *)((char *)base + rule->field - 1) = rule->way_0 +
		    (unsigned)way;
	return b->way[way].left & ~given;
}

/* Reads each member of v. An unknown member is read by the row that it may mean, unless
 * this has a hint: the value may then have another form. Returns whether a hint of
 * words.c names a way that the rules lack. */
static bool read_each(const struct value *v, const struct member *table, int variant,
    struct found *found, void *base)
{
	struct value m = value_child(v), first;
	uint64_t repeated = 0;
	bool other_way = false;

	for (; m.item != NULL; value_next(&m)) {
		const struct member *row = member_named(table, variant, m.name, false);
		const bool known = row != NULL;

		if (!known && is_ignored(&m)) {
			if (*m.name != '_' && value_member(v, m.name, &first) &&
			    first.item != m.item)
				value_fault(&m, "repeated; give it once");
			continue;
		}
		if (!known)
			row = tell_unknown(&m, table, variant);
		if (row == NULL) {
			other_way |= word_hint(m.name, WORD_MEMBER, ':') != NULL;
			continue;
		}
		const uint64_t bit = UINT64_C(1) << (row - table);

		if (known && (found->given & ~repeated & bit) != 0) {
			value_fault(&m, "repeated; give it once");
			repeated |= bit;
		}
		if ((found->given & bit) != 0)
			continue;
		*(known ? &found->given : &found->meant) |= bit;
		if (base != NULL && (known || row->hint == NULL))
			object_read_member(&m, row, base);
	}
	return other_way;
}

struct found object_read(const struct value *v, const struct member *row, int variant,
    void *base)
{
	const size_t faults = json_faults.n;
	const struct rule *r = row->rules;
	struct found found = { 0 };
	char wanted[LIST_ROOM];

	if (!value_is(v, JSON_OBJECT)) {
		snprintf(wanted, sizeof wanted, "an object%s%s%s",
		    row->example != NULL ? " such as " : "",
		    row->example != NULL ? row->example : "",
		    row->hint != NULL ? row->hint : "");
		value_refuse_type(v, wanted);
	}
	for (const struct member *m = row->members; m->name != NULL; m++)
		if (base != NULL && m->fallback != NULL && m->type->number_size > 0 &&
		    has_variant(m->variants, variant))
			read_default(m, (char *)base + m->offset);
	const bool other_way = read_each(v, row->members, variant, &found, base);

	found.meant &= ~found.given;
	for (; r != NULL && r->ways != NULL && variant != ANY_VARIANT; r++)
		found.left |= check_rule(v, r, row->members, variant, &found,
		    other_way ||
			((found.given | found.meant) == 0 && json_faults.n != faults),
		    base);
	found.faulty = json_faults.n != faults;
	return found;
}

/* Returns whether *at is a default that is not shown, or a size of 0: none is given. */
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
	const struct rule *r = row->rules;
	const char *at = base;

	for (; r != NULL && r->ways != NULL; r++) {
		if (r->field == 0 || !has_variant(r->variants, variant))
			continue;
		const struct rule_bits *b = rule_find(r, row->members, variant, false);
		const unsigned *way = (const void *)(at + r->field - 1);

		bits &= ~b->all | b->way[*way - r->way_0].all;
	}
	put_open(p, "{");
	for (row = row->members; row->name != NULL; row++, bits >>= 1) {
		bool has = row->flag == 0 || *(const bool *)(at + row->flag - 1);

		if ((bits & 1) == 0 || !has || !has_variant(row->variants, variant) ||
		    is_omitted(row, at + row->offset))
			continue;
		row->type->print(put_name(p, row->name), row, at + row->offset);
	}
	put_close(p, "}");
}

static void read_object(const struct value *v, const struct member *row, void *out)
{
	object_read(v, row, 0, out);
}

static void print_object(struct printer *p, const struct member *row, const void *at)
{
	object_print(p, row, 0, ALL_MEMBERS, at);
}

const struct member_type type_object = { NULL, read_object, print_object, 0 };
