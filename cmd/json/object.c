/* SPDX-License-Identifier: MIT */
#include "object.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

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
    const char *name)
{
	for (; row != NULL && row->name != NULL; row++)
		if (has_variant(row->variants, variant) &&
		    (word_equals(name, row->name) ||
			word_is_one_of(name, row->aliases)))
			return row;
	return NULL;
}

/* Returns whether the numbers of a row are sizes, of which 0 is none. */
static bool is_size(const struct member *row)
{
	return row->range != NULL && row->range->min == range_positive.min &&
	    row->range->max == range_positive.max;
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
	const char *one = is_size(row)                             ? "size" :
	    row->unit != NULL && strcmp(row->unit, "degrees") == 0 ? "angle" :
								     "number";

	if (row->n == 0)
		return one;
	snprintf(out, LIST_ROOM, "%zu %ss", row->n, one);
	return out;
}

/* Lists the names of the rows in `bits` that the variant has and, unless aliases is
 * NULL, their aliases. */
static void list_names(const struct member *row, int variant, uint64_t bits,
    const char *names[MEMBERS_MAX + 1], const char *aliases[MEMBERS_MAX])
{
	int n = 0;

	for (; row->name != NULL; row++, bits >>= 1)
		if ((bits & 1) != 0 && has_variant(row->variants, variant)) {
			if (aliases != NULL)
				aliases[n] = row->aliases;
			names[n++] = row->name;
		}
	names[n] = NULL;
}

/* Returns what to say of a member that the table has for other variants, or that
 * another object of the scene has; or NULL. */
static const char *find_owner(const struct value *v, const struct member *table)
{
	const struct member *scene = v->source->scene_members;
	const struct member *row = member_named(table, ANY_VARIANT, v->name);
	const char *names[MEMBERS_MAX + 1];
	char list[LIST_ROOM];
	unsigned variants = 0;
	int n = 0;

	for (const struct member *m = table; row != NULL && m->name != NULL; m++)
		if (strcmp(m->name, row->name) == 0)
			variants |= m->variants;
	for (; variants != 0; variants &= variants - 1)
		names[n++] = table->words[__builtin_ctz(variants)];
	names[n] = NULL;
	if (n > 0)
		return text("only %s %s it", words_join(list, names, " and ", "\""),
		    n > 1 ? "have" : "has");
	if (table != scene && member_named(scene, 0, v->name) != NULL)
		return v->parent->name != NULL ?
		    text("it stands beside \"%s\"", v->parent->name) :
		    "it is a member of the scene";
	for (const struct member *m = scene; m->name != NULL; m++)
		if (m->members != table &&
		    member_named(m->members, ANY_VARIANT, v->name) != NULL)
			names[n++] = m->name;
	names[n] = NULL;
	return n > 0 ? text("it belongs in %s", words_join(list, names, " or ", "\"")) :
		       NULL;
}

/* Returns whether an unknown member is not read: $schema and, in the outermost object,
 * a member that any document may have. */
static bool is_ignored(const struct value *v)
{
	const struct member *row = member_named(v->source->scene_members, 0, v->name);

	return strcmp(v->name, "$schema") == 0 ||
	    (row != NULL && row->in_any_document && v->parent->parent == NULL);
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

/* Makes the field of a member that was refused, or is missing, unknown. */
static void forget(const struct member *row, void *base)
{
	const struct member_type *type = row->type;
	void *const field = (char *)base + row->offset;
	const size_t n = type->doubles > 0      ? type->doubles :
	    type->number_size != sizeof(double) ? 0 :
	    row->n > 0                          ? row->n :
						  1;

	for (size_t i = 0; i < n; i++)
		((double *)field)[i] = (double)NAN;
	if (type->forget != NULL)
		type->forget(field);
}

static void forget_all(const struct member *table, uint64_t members, void *base)
{
	for (; members != 0 && base != NULL; members &= members - 1)
		forget(&table[__builtin_ctzll(members)], base);
}

void object_read_member(const struct value *v, const struct member *row, void *base)
{
	if (row->flag != 0)
		*(bool *)((char *)base + row->flag - 1) = true;
	if (!row->type->read(v, row, (char *)base + row->offset))
		forget(row, base);
}

bool object_member(const struct value *object, const struct member *row,
    struct value *member)
{
	*member = value_child(object);
	while (member->item != NULL &&
	    (member->name == NULL ||
		!(word_equals(member->name, row->name) ||
		    word_is_one_of(member->name, row->aliases))))
		value_next(member);
	return member->item != NULL;
}

/* An object that is read: its table, and its members as bits of the rows. `meant` are
 * those that unknown ones surely mean. */
struct reading {
	const struct value *v;
	const struct member *table;
	int variant;
	uint64_t given, meant;
	uint64_t maybe;   /* members that unknown ones may stand for: none is missing */
	bool has_unknown; /* an unknown member */
};

static uint64_t all_of(const struct way *w)
{
	return w->has | w->optional;
}

static uint64_t required_of(const struct way *w, enum task task)
{
	return w->has & ~w->by_viewport & ~(task == TASK_FIT ? w->fitted : 0);
}

/* Returns the hint of a rule or, without one, all its ways, written to out: "give A and
 * B, or C". Omits optional members that are not given. */
static const char *hint_of(const struct rule *rule, const struct reading *r,
    enum task task, char out[LIST_ROOM])
{
	const char *names[MEMBERS_MAX + 1];
	char all[LIST_ROOM];
	size_t n = 0;

	if (rule->hint != NULL)
		return rule->hint;
	for (size_t i = 0; i < rule->n && n < LIST_ROOM; i++) {
		const struct way *w = &rule->ways[i];

		list_names(r->table, r->variant,
		    required_of(w, task) | (all_of(w) & r->given), names, NULL);
		words_join(all, names, " and ", "\"");
		n += (size_t)snprintf(out + n, LIST_ROOM - n, "%s%s",
		    i > 0 ? ", or " : "give ", *all != '\0' ? all : "none of them");
	}
	return out;
}

/* Refuses a given member that is not of the way of which the object has the members
 * `way`. */
static void refuse_rival(const struct reading *r, const struct rule *rule,
    enum task task, int member, uint64_t way)
{
	const char *names[MEMBERS_MAX + 1];
	char ways[LIST_ROOM], rivals[LIST_ROOM];
	uint64_t others = way;
	struct value m;

	for (size_t i = 0; i < rule->n; i++)
		if (all_of(&rule->ways[i]) >> member & 1)
			others &= ~all_of(&rule->ways[i]);
	list_names(r->table, r->variant, others != 0 ? others : way, names, NULL);
	object_member(r->v, &r->table[member], &m);
	value_refuse(&m,
	    text("does not go with %s", words_join(rivals, names, " and ", "\"")),
	    rule->rivals != NULL ? rule->rivals : hint_of(rule, r, task, ways));
}

/* Returns the way that the members `given` of a rule are most likely of: a way that
 * lacks none, if there is one, and of which the fewest others are given; else the way
 * that has some of them, of which the fewest others are given, and the fewest lack. */
static const struct way *find_way(const struct rule *rule, enum task task,
    uint64_t given)
{
	const struct way *best = &rule->ways[0];
	int least = 2 * MEMBERS_MAX * MEMBERS_MAX;

	for (size_t i = 0; i < rule->n; i++) {
		const struct way *const w = &rule->ways[i];
		const uint64_t missing = required_of(w, task) & ~given;
		const uint64_t in = all_of(w) & given;
		const int rivals = __builtin_popcountll(given & ~in);
		const int lacking = __builtin_popcountll(missing);
		const int cost = lacking == 0 ? rivals :
						MEMBERS_MAX * (1 + rivals) + lacking;

		if ((in != 0 || cost == 0) && cost < least) {
			best = w;
			least = cost;
		}
	}
	return best;
}

/* Returns whether each way of a rule is one member: an unknown one stands for it. */
static bool is_choice(const struct rule *rule)
{
	bool is = true;

	for (size_t i = 0; i < rule->n; i++)
		is &= __builtin_popcountll(rule->ways[i].has) == 1;
	return is;
}

/* Makes the fields of `rivals` unknown, but reads those of `kept` again that are the
 * same, as a gaze is stored where a point to look at is. */
static void forget_rivals(const struct reading *r, uint64_t rivals, uint64_t kept,
    void *base)
{
	struct value m;

	forget_all(r->table, rivals, base);
	for (; rivals != 0 && base != NULL; rivals &= rivals - 1)
		for (uint64_t left = kept; left != 0; left &= left - 1) {
			const struct member *row = &r->table[__builtin_ctzll(left)];

			if (row->offset == r->table[__builtin_ctzll(rivals)].offset &&
			    object_member(r->v, row, &m))
				object_read_member(&m, row, base);
		}
}

/* Judges a rule. Returns the members that the object leaves to the viewport. A fault
 * that may come from an unknown member is not refused, too. */
static uint64_t check_rule(const struct reading *r, const struct rule *rule, void *base)
{
	const enum task task = r->v->unused ? TASK_WHOLE : r->v->source->task;
	uint64_t all = 0, given = r->given | r->meant;
	char ways[LIST_ROOM];

	if (!has_variant(rule->variants, r->variant) ||
	    !has_variant(rule->tasks, (int)task) ||
	    (rule->with != 0 && (rule->with & given) == 0) ||
	    (rule->without & given) != 0)
		return 0;
	for (size_t i = 0; i < rule->n; i++)
		all |= all_of(&rule->ways[i]);
	given &= all;
	const struct way *const way = find_way(rule, task, given);
	const uint64_t lacking = required_of(way, task) & ~given,
		       in = all_of(way) & given;

	if (lacking != 0 && (r->maybe & all) == 0 &&
	    !(r->has_unknown && given == 0 && is_choice(rule)))
		value_refuse(VALUE_NAMED(r->v, r->table[__builtin_ctzll(lacking)].name),
		    "missing", hint_of(rule, r, task, ways));
	for (uint64_t rivals = given & ~in & r->given; rivals != 0;
	     rivals &= rivals - 1)
		if ((in & ~r->given) == 0)
			refuse_rival(r, rule, task, __builtin_ctzll(rivals), in);
	forget_all(r->table, lacking, base);
	forget_rivals(r, given & ~in, in & r->given, base);
	if (base != NULL && rule->field != 0)
		*(unsigned *)(void *)((char *)base + rule->field - 1) = way->value;
	if (lacking != 0)
		return 0;
	return way->by_viewport & ~(task == TASK_FIT ? way->fitted : 0) & ~given;
}

/* Refuses an unknown member, and notes which members it may stand for. */
static void refuse_unknown(struct reading *r, const struct value *v)
{
	const char *names[MEMBERS_MAX + 1], *aliases[MEMBERS_MAX];
	const struct member *owner = v->source->scene_members;
	const struct remark *remark;
	const char *near = NULL;
	char list[LIST_ROOM];

	list_names(r->table, r->variant, ALL_MEMBERS, names, aliases);
	remark = word_remark(v->name, WORD_MEMBER, names);
	const char *remedy = remark == NULL ? find_owner(v, r->table) : NULL;

	if (remedy == NULL) {
		if (remark == NULL)
			near = word_nearest(v->name, names, aliases);
		remedy = word_remedy(list, remark, near, names, "\"");
	}
	while (owner->name != NULL && owner->members != r->table)
		owner++;
	if (*remedy == '\0' && owner->name != NULL)
		remedy = text("'projcalc help %s' lists them", owner->name);
	value_refuse(v, "unknown member", remedy);
	r->has_unknown = true;
	for (const struct member *row = r->table; row->name != NULL; row++) {
		const uint64_t bit = MEMBER_BIT(row - r->table);
		const bool is_meant = remark != NULL &&
		    word_is_one_of(row->name, remark->names);

		const bool has = has_variant(row->variants, r->variant);

		if (is_meant) /* of which the variant may be another */
			r->maybe |= has ? bit : ALL_MEMBERS;
		if (has && near != NULL && strcmp(row->name, near) == 0)
			r->meant |= bit;
	}
}

/* Returns whether no member before m of the same object has the name of m. */
static bool is_first(const struct value *object, const struct value *m)
{
	struct value first = value_child(object);

	while (!word_equals(first.name, m->name))
		value_next(&first);
	return first.item == m->item;
}

/* Reads a member of an object whose variant is not known, of which `first` is the first
 * row. It is wrong if it is for each variant that has it. */
static void read_of_any_variant(const struct value *m, const struct member *first)
{
	struct refusals *const faults = m->source->faults;
	const size_t n = faults->n;
	double field[16]; /* of a matrix, the greatest of the members */
	bool is_right = false;

	for (const struct member *row = first; row != NULL && !is_right;
	     row = member_named(row + 1, ANY_VARIANT, m->name)) {
		is_right = row->type->read(m, row, field);
		faults->n = n;
	}
	if (!is_right)
		first->type->read(m, first, field);
}

static void read_each(struct reading *r, void *base)
{
	for (struct value m = value_child(r->v); m.item != NULL; value_next(&m)) {
		const struct member *row = member_named(r->table, r->variant, m.name);

		if (*m.name == '_')
			continue;
		if (row == NULL) {
			if (!is_ignored(&m))
				refuse_unknown(r, &m);
			else if (!is_first(r->v, &m))
				value_refuse(&m, "repeated", "give it once");
			continue;
		}
		const uint64_t bit = MEMBER_BIT(row - r->table);

		if ((r->given & bit) != 0)
			value_refuse(&m,
			    word_equals(m.name, row->name) ?
				"repeated" :
				text("is \"%s\" again", row->name),
			    "give it once");
		else if (base != NULL && r->variant == ANY_VARIANT)
			read_of_any_variant(&m, row);
		else if (base != NULL)
			object_read_member(&m, row, base);
		r->given |= bit;
	}
}

bool object_read(const struct value *v, const struct member *row, int variant,
    void *base, struct found *found)
{
	const size_t faults = v->source->faults->n;
	struct reading r = { .v = v, .table = row->members, .variant = variant };
	uint64_t left = 0;

	if (!value_is(v, JSON_OBJECT)) {
		for (const struct member *m = row->members; m->name != NULL; m++)
			forget_all(m, 1, base);
		return value_refuse_type(v,
		    text("an object%s%s", row->example != NULL ? " such as " : "",
			row->example != NULL ? row->example : ""));
	}
	for (const struct member *m = row->members; m->name != NULL; m++)
		if (base != NULL && m->fallback != NULL && m->type->number_size > 0 &&
		    has_variant(m->variants, variant))
			read_default(m, (char *)base + m->offset);
	read_each(&r, base);
	forget_all(row->members, r.meant & ~r.given, base);
	for (const struct rule *rule = row->rules;
	     rule != NULL && rule->n > 0 && variant != ANY_VARIANT; rule++)
		left |= check_rule(&r, rule, base);
	if (found != NULL)
		*found = (struct found){ r.given, r.meant & ~r.given, left };
	return v->source->faults->n == faults;
}

/* Returns whether *at is a default that is not shown, or a size of 0: none is given. */
static bool is_omitted(const struct member *row, const void *at)
{
	const double *v = at;
	double fallback[4];

	if (row->fallback == NULL && is_size(row))
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
	const struct rule *rule = row->rules;
	const char *at = base;

	for (; rule != NULL && rule->n > 0; rule++) {
		if (rule->field == 0 || !has_variant(rule->variants, variant))
			continue;
		const unsigned value = *(
		    const unsigned *)(const void *)(at + rule->field - 1);

		uint64_t own = 0, all = 0;

		for (size_t i = 0; i < rule->n; i++) {
			const uint64_t members = all_of(&rule->ways[i]);

			all |= members;
			own |= rule->ways[i].value == value ? members : 0;
		}
		bits &= ~all | own;
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

static bool read_object(const struct value *v, const struct member *row, void *out)
{
	return object_read(v, row, 0, out, NULL);
}

static void print_object(struct printer *p, const struct member *row, const void *at)
{
	object_print(p, row, 0, ALL_MEMBERS, at);
}

const struct member_type type_object = { .read = read_object, .print = print_object };
