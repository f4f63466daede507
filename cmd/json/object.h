/* SPDX-License-Identifier: MIT */
/* Objects of a document. A table of an object's members says what each may be
 * and where in a struct it is read to. */
#ifndef OBJECT_H
#define OBJECT_H

#include "value.h"

struct member {
	const char *name; /* NULL ends a table */
	/* Reads the member's value to where it stands in the struct. */
	void (*read)(const struct value *, const struct member *, void *);
	size_t at;                 /* the offset of that */
	size_t n;                  /* of numbers in an array; 0: one number */
	const struct range *range; /* of numbers; NULL: range_any */
	const char *const *words;  /* of a string; NULL ends them */
	/* Where objects are of several kinds, as projections are of types: the
	 * kinds that have the member, as bits; 0 for all of them. The words of
	 * the table's first row name the kinds. */
	unsigned kinds;
	/* What else people call it, divided by blanks: in lower case, without
	 * _ and -. */
	const char *aliases;
	/* What it is, for those who call it otherwise. */
	const char *note;
	/* For the help. What its value is, where n, range and words don't tell
	 * (member_type does); in what units, or NULL; what it is without being
	 * given, or NULL; and in a few words what it says. */
	const char *type, *unit, *otherwise, *about;
	/* Of a member of a scene: its own members, an example of it, and of a
	 * command that reads it. */
	const struct member *members;
	const char *example, *command;
	/* It may also stand in the document that is another of them alone. */
	bool beside;
};

/* The ways in which members of an object can be combined. A way lists names
 * with blanks between them; those with ? may be missing. An object takes one
 * way, in whole, and has no member that is only in another. */
struct ways {
	const char *hint; /* says what the ways are */
	const char *way[9];
};

/* Reads an object of that kind, 0 where there are no kinds, into the struct at
 * base. Returns the members it has, as bits in the order of the table. Members
 * that begin with _, $schema, and what may stand beside, are passed over; any other
 * that is unknown, of another kind, or repeated is refused. */
unsigned object_read(const struct value *, const struct member *, int kind,
    void *base);

/* The member that objects of that kind have of that name; or the same, or else that
 * has that alias; or NULL. */
enum { ANY_KIND = -1 };
const struct member *member_of(const struct member *, int kind,
    const char *name);
const struct member *member_named(const struct member *, int kind,
    const char *name);

/* What its value is: "3 numbers", "size", "left or right". May write it to out. */
const char *member_type(const struct member *, char out[LISTED]);

/* The bit of the member of that name; 0 if objects of that kind have none. */
unsigned member_bit(const struct member *, int kind, const char *name);

/* The index of the way that the members seen, as bits, take. Refuses an object
 * that takes none in whole, or has members of another as well. */
int object_way(const struct value *, const struct member *, int kind,
    unsigned seen, const struct ways *);

#endif
