/* SPDX-License-Identifier: MIT */
/* Objects of a document. A table of members says for each what it may be, its place in
 * a struct, and what the help tells of it. */
#ifndef OBJECT_H
#define OBJECT_H

#include <stdint.h>

#include "print.h"
#include "value.h"

struct member;

/* Members of a table as bits: row i has bit i. */
#define ALL_MEMBERS (~UINT64_C(0))

/* The type of a member. Its functions get the address of the member in the struct. */
struct type {
	const char *name; /* for the help; NULL: see member_type */
	void (*read)(const struct value *, const struct member *, void *);
	/* NULL if such members are never printed. */
	void (*print)(struct printer *, const struct member *, const void *);
	size_t
	    size; /* bytes of one number in the struct; 0: members have no default */
};

struct member {
	const char *name; /* NULL ends a table */
	const struct type *type;
	size_t at; /* offset in the struct */
	/* Offset of a bool of the struct which is set when the member is read; a member
	 * is printed only if it is set. 0: there is none. */
	size_t has;
	size_t n; /* numbers in an array; 0: one number */
	const struct value_range *range; /* of numbers; NULL: range_any */
	const char *const *words;        /* of a string; NULL ends them */
	unsigned first;                  /* the value of words[0] */
	/* The kinds of objects that have the member, as bits; 0: all kinds. Kinds are
	 * the words of the table's first row, such as the types of projections. Members
	 * of different kinds may have the same name. */
	unsigned kinds;
	/* The default as JSON, with angles in degrees; or NULL. A member that has its
	 * default is printed only if shown is set. */
	const char *usual;
	bool shown;
	/* For the help: a source of the default that comes before usual; or NULL. */
	const char *before;
	/* Names in other programs, with blanks between them: in lower case, without
	 * _ and -. */
	const char *aliases;
	/* A hint for users who gave an alias; or NULL. */
	const char *note;
	/* The unit, or NULL, with degrees for all angles; and a description, for the
	 * help. */
	const char *unit, *about;
	/* For a member of a scene: its own members, the ways to combine them, an
	 * example of its value, and an example of a command that reads it. */
	const struct member *members;
	const struct ways *ways;
	const char *example, *command;
	/* A document may be the value of one member of a scene, such as a camera. The
	 * member may then stand among the members of this value. */
	bool beside;
};

/* A row of a table: the member has this name and type, and is read to this field of
 * struct in. */
#define ROW(in, label, of, field, ...)                        \
	{                                                     \
		.name = label, .type = &(of),                 \
		.at = offsetof(struct in, field), __VA_ARGS__ \
	}

/* The ways to combine members of an object. A way is a list of names with blanks
 * between them; ? after a name marks an optional member. An object must have all
 * members of one way but the optional ones, and no member that only other ways list. */
enum { WAYS_MAX = 10 };
struct ways {
	const char *
	    way[WAYS_MAX + 1]; /* NULL ends them; way[0] = NULL ends an array */
	/* The ways for the command fit, if fit is set. If there are none, the members
	 * may be combined freely. */
	bool fit;
	const char *fit_way[WAYS_MAX + 1];
	unsigned
	    kinds; /* of objects that have these ways, as bits; 0: all kinds */
	/* Offset in the struct of an unsigned, which becomes first plus the index of
	 * the object's way; 0: no field is set. */
	size_t at;
	unsigned first;
};

/* Returns the members that an object of that kind has, as bits, and reads them to the
 * struct at base after all defaults; if base is NULL, reads no values. The row has the
 * object's members, and its ways, whose indices are set. kind is 0 if there are no
 * kinds. Ignores members that begin with _, $schema, and those that may stand beside.
 * Refuses other members that are unknown, of another kind, or repeated, and objects
 * that fit no way. */
uint64_t object_read(const struct value *, const struct member *row, int kind,
    void *base);

/* Reads the value of a member to its place in the struct at base. */
void object_read_member(const struct value *, const struct member *,
    void *base);

/* Prints an object with those members in bits that the kind has, that belong to no
 * way or to the ways whose indices the struct has, and that differ from their defaults.
 * A size of 0 was not given, and is left out. */
void object_print(struct printer *, const struct member *row, int kind,
    uint64_t bits, const void *base);

/* Returns the member of that name that objects of that kind have, or NULL. member_named
 * also finds a member by an alias. */
enum { ANY_KIND = -1 };
const struct member *member_of(const struct member *, int kind,
    const char *name);
const struct member *member_named(const struct member *, int kind,
    const char *name);

/* Returns the type for the help, such as "3 numbers", "size", "left or right". out is
 * room for it, which may stay unused. */
const char *member_type(const struct member *, char out[LISTED]);

/* Returns as bits those members of a way, names, that objects of that kind have; if
 * needed is set, without the optional ones. */
uint64_t member_bits(const struct member *, int kind, const char *names,
    bool needed);

/* Returns the index of the way to which the members seen, as bits, belong. Refuses an
 * object that lacks members of each way, or has members of several. */
int object_way(const struct value *, const struct member *, int kind,
    uint64_t seen, const struct ways *);

#endif
