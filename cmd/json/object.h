/* SPDX-License-Identifier: MIT */
/* Reads and prints the objects of a document by tables. A row of a table describes a
 * member: its names, its values, its field in a struct, and its texts in the help. A
 * rule says which members go together. Help, completions and the schema are made of the
 * same rows. Rows and rules are constants.
 *
 * The caller owns the struct that is read or printed; a struct that was read does not
 * refer to the document. What is wrong is added to the list of refusals of the document
 * (value.h), and reading goes on, so that all faults are found: a struct with a fault
 * is half read, and is for nothing but the search for other faults. In it numbers that
 * were refused, or that a rule misses, are NaN, of which no comparison holds: so no
 * check tells a fault that follows from another. */
#pragma once

#include <stdint.h>

#include "print.h"
#include "value.h"

struct member;

/* All members of a table as bits: row i is bit i. */
#define ALL_MEMBERS (~UINT64_C(0))
#define MEMBER_BIT(row) (UINT64_C(1) << (row))

/* The type of a member. Both functions get the row and the address of the field. `read`
 * returns whether the value was read; else the list of refusals says why not. */
struct member_type {
	const char *name; /* in the help; NULL: see member_type_name */
	bool (*read)(const struct value *, const struct member *, void *);
	/* NULL: members of this type are never printed. */
	void (*print)(struct printer *, const struct member *, const void *);
	size_t number_size; /* bytes of a number in the field; 0: no defaults */
	/* The doubles in the field, if not the row's n: those of a member that is
	 * refused or missing become NaN. */
	size_t doubles;
	/* Marks a field that is no number as refused; NULL: no check reads such. */
	void (*forget)(void *);
};

/* A row of a table. */
struct member {
	const char *name; /* NULL ends a table */
	/* Other names that mean just the same, which are read as `name`, in lower case
	 * without _ and -, with blanks between the names; or NULL. */
	const char *aliases;
	const struct member_type *type;
	size_t offset; /* of the field in the struct */
	size_t flag;   /* FIELD of a bool: the member is given; or 0 */
	size_t n;      /* length of an array of numbers; 0: one number */
	const struct value_range *range; /* of numbers; NULL: range_any */
	/* Possible strings, which NULL ends; and for each its aliases, as `aliases` has
	 * them, or NULL. word_aliases may be NULL. */
	const char *const *words, *const *word_aliases;
	unsigned word_0; /* the field's value for words[0] */
	/* The variants of objects that have the member, as bits; 0: all. Variant i is
	 * word i of the table's first row, such as a type of projection. Several rows
	 * may have the same name if their variants differ. */
	unsigned variants;
	/* The default as JSON, with angles in degrees; or NULL. A member that has its
	 * default is printed only if `shown` is set. */
	const char *fallback;
	bool shown;
	/* What the help says before `fallback`, as "-c's" of "-c's, else d3d"; or
	 * NULL. */
	const char *default_from;
	/* Texts of the help. `unit` is "degrees" for all angles, NULL for no unit. */
	const char *unit, *about;
	/* For an object of a scene: the table of its members, the rules for them, an
	 * example of the object, and a command that reads the example. */
	const struct member *members;
	const struct rule *rules;
	const char *example, *command;
	/* For a member of a scene: it may also stand in a document that is not a scene
	 * but one of its objects, such as a camera. */
	bool in_any_document;
};

/* A field that a row may have or not; 0 means that it has none. */
#define FIELD(object, name) (offsetof(struct object, name) + 1)

/* A row: the member called `label` is read to the field `field` of struct `object`. */
#define ROW(object, label, value_type, field, ...)                    \
	{                                                             \
		.name = label, .type = &(value_type),                 \
		.offset = offsetof(struct object, field), __VA_ARGS__ \
	}

/* A way to give an object, or a part of it: sets of members, as bits of rows. An object
 * that is given so has all members of `has`, but for those of `fitted`, which the
 * command fit finds, and of `by_viewport`, which the scene's viewport determines; and
 * it may have those of `optional`. */
struct way {
	uint64_t has, optional, fitted, by_viewport;
	unsigned value; /* of the rule's field */
};

#define WAY(members, ...)                     \
	{                                     \
		.has = (members), __VA_ARGS__ \
	}

/* A rule says which members of an object go together: those of one of its ways. */
struct rule {
	const struct way *ways;
	size_t n; /* the number of ways; 0 ends an array of rules */
	/* The rule holds for these variants, and for these tasks, as bits 1 << task; 0
	 * means all. It holds for objects that have one of the members `with`, unless
	 * this is 0, and none of the members `without`. */
	unsigned variants, tasks;
	uint64_t with, without;
	/* The end of the message that a member is missing; NULL: it lists the ways.
	 * `rivals` ends the message that members are of two ways; NULL: `hint` does. */
	const char *hint, *rivals;
	size_t field; /* FIELD of an unsigned, which becomes the way's value; or 0 */
};

#define WAYS(...)                                    \
	.ways = (const struct way[]){ __VA_ARGS__ }, \
	.n = sizeof((const struct way[]){ __VA_ARGS__ }) / sizeof(struct way)

enum { ANY_VARIANT = -1 }; /* in place of a variant: all rows are meant */

/* What object_read found, as bits of the rows: the members that the object has; others
 * that its unknown members may mean; and those that it leaves to the viewport. */
struct found {
	uint64_t given, meant, left;
};

/* Reads an object of the variant, which is 0 if the table has none. Sets the struct at
 * `base`, if not NULL: defaults, given members, fields of rules. A member has its row's
 * name or an alias. Ignores $schema, names that begin with _ and, in the outermost
 * object, members that any document may have. Refuses unknown, repeated and wrong
 * members, and broken rules; returns whether there are none. To a rule an unknown
 * member is what it may mean. `found` may be NULL. */
bool object_read(const struct value *, const struct member *row, int variant,
    void *base, struct found *found);

/* The type of a member that is an object without variants. */
extern const struct member_type type_object;

/* Reads the value of a member to its field in the struct at `base`; sets its flag. */
void object_read_member(const struct value *, const struct member *, void *base);

/* Sets *member to the object's member of this row, by its name or an alias, and returns
 * whether there is one. */
bool object_member(const struct value *object, const struct member *row,
    struct value *member);

/* Prints the struct at `base` as an object with those members in `bits` that objects of
 * the variant have. Leaves out defaults, sizes of 0 (not given), and members that
 * belong only to ways other than the struct's. */
void object_print(struct printer *, const struct member *row, int variant,
    uint64_t bits, const void *base);

/* Returns the row that objects of the variant have and that is called `name`, or has it
 * as an alias; case, and _ and - inside, do not count. NULL if there is none, or if the
 * table is NULL. */
const struct member *member_named(const struct member *, int variant, const char *name);

/* Returns a member's type for the help, such as "3 numbers", which may be in `out`. */
const char *member_type_name(const struct member *, char out[LIST_ROOM]);
