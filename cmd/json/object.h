/* SPDX-License-Identifier: MIT */
/* Reads and prints the objects of a document by tables. A row of a table describes a
 * member: its values, its field in a struct, and its texts in the help. A rule says which
 * members go together. Help, completions and the schema are made of the same rows.
 *
 * The caller owns the struct that is read or printed. Rows and rules are constants, and
 * what is derived from a rule is kept until the program ends. Nothing else is kept but the
 * count of faults (json_faults): a struct that was read does not refer to the document.
 * After faults it is half read, and for nothing but the search for other faults. */
#pragma once

#include <stdint.h>

#include "print.h"
#include "value.h"

struct member;

/* All members of a table as bits: row i is bit i. */
#define ALL_MEMBERS (~UINT64_C(0))

/* The type of a member. Both functions get the row and the address of the field. */
struct member_type {
	const char *name; /* in the help; NULL: see member_type_name */
	void (*read)(const struct value *, const struct member *, void *);
	/* NULL: members of this type are never printed. */
	void (*print)(struct printer *, const struct member *, const void *);
	size_t number_size; /* bytes of a number in the field; 0: no defaults */
};

/* A row of a table. */
struct member {
	const char *name; /* NULL ends a table */
	const struct member_type *type;
	size_t offset; /* of the field in the struct */
	size_t flag;   /* FIELD of a bool: the member is given; or 0 */
	size_t n;      /* length of an array of numbers; 0: one number */
	const struct value_range *range; /* of numbers; NULL: range_any */
	const char *const *words;        /* possible strings; NULL ends them */
	unsigned word_0;                 /* the field's value for words[0] */
	/* The variants of objects that have the member, as bits; 0: all. Variant i is
	 * word i of the table's first row, such as a type of projection. Several rows
	 * may have the same name if their variants differ. */
	unsigned variants;
	/* The default as JSON, with angles in degrees; or NULL. A member that has its
	 * default is printed only if `shown` is set. */
	const char *fallback;
	bool shown;
	/* What the help says before `fallback`, as "-c's" of "-c's, else d3d"; or NULL. */
	const char *default_from;
	/* Names of the member in other programs, in lower case without _ and -, with
	 * blanks between the names; or NULL. */
	const char *aliases;
	const char *hint; /* a hint " (...)" for users of an alias; or NULL */
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

/* A rule says which members of an object go together. An object must have the members
 * of one way, and no member that only other ways list. A way is a list of names with
 * blanks between them. After a name, ? marks an optional member, ~ one that the command
 * fit finds, and |NAME one that can be left out if the scene has a member NAME. */
struct rule {
	const char *const *ways; /* NULL ends them; ways NULL ends an array */
	/* The rule holds for these variants, and for these tasks, as bits 1 << task; 0
	 * means all. It holds for objects that have one of the members `with`, but none
	 * of those with ! after their names; NULL means for all objects. */
	unsigned variants, tasks;
	const char *with;
	/* The end of the message that a member is missing; NULL: it lists the ways.
	 * `rivals` ends the message that members are of two ways; NULL: `hint` does. */
	const char *hint, *rivals;
	/* FIELD of an unsigned, which becomes way_0 plus the index of the way; or 0 */
	size_t field;
	unsigned way_0;
};

#define WAYS(...) ((const char *const[]){ __VA_ARGS__, NULL })

enum { ANY_VARIANT = -1 }; /* in place of a variant: all rows are meant */

/* What object_read found, as bits of the rows: the members that the object has; others
 * that its unknown members may mean; and those that it leaves to another member of the
 * scene, as |NAME of a rule allows. */
struct found {
	uint64_t given, meant, left;
	bool faulty; /* there are faults, which are told */
};

/* Reads an object of the variant, which is 0 if the table has none, and returns what it
 * found. Sets the struct at `base`, if not NULL: defaults, given members, ways. Ignores
 * $schema, names that begin with _ and, in the outermost object, members that any
 * document may have. Tells all faults: unknown, repeated and wrong members, and broken
 * rules, of which an object without members of the table breaks one alone. To a rule an
 * unknown member is what it may mean. Of ANY_VARIANT looks at names alone. */
struct found object_read(const struct value *, const struct member *row, int variant,
    void *base);

/* The type of a member that is an object without variants. */
extern const struct member_type type_object;

/* Returns the row that an unknown member may mean, as its message says, or NULL. */
const struct member *object_meant(const struct value *, const struct member *table,
    int variant);

/* Calls `read`, and returns also if it refuses a fault, after this is told. */
void object_attempt(void (*read)(const struct value *, const struct member *, void *),
    const struct value *, const struct member *, void *out);

/* Reads the value of a member to its field in the struct at `base`, by object_attempt. */
void object_read_member(const struct value *, const struct member *, void *base);

/* Prints the struct at `base` as an object with those members in `bits` that objects of
 * the variant have. Leaves out defaults, sizes of 0 (not given), and members that
 * belong only to ways other than the struct's. */
void object_print(struct printer *, const struct member *row, int variant,
    uint64_t bits, const void *base);

/* Returns the first row that objects of the variant have and that is called `name`, or
 * NULL. If `alias` is true, the row may also have `name` as an alias, or a name that
 * differs from it in case, _ and - only. The table may be NULL. */
const struct member *member_named(const struct member *, int variant, const char *name,
    bool alias);

/* Returns a member's type for the help, such as "3 numbers"; may be written to `out`. */
const char *member_type_name(const struct member *, char out[LIST_ROOM]);

/* Returns the rows of those of `names` that objects of the variant have, as bits. */
uint64_t member_bits(const struct member *, int variant, const char *names);
