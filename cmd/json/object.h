/* Objects of a document, each read by a table of its members into a struct. */
#ifndef OBJECT_H
#define OBJECT_H

#include "value.h"

struct member {
	const char *name; /* NULL ends a table */
	/* Reads the member's value to where it stands in the struct. */
	void (*read)(const struct value *, const struct member *, void *);
	size_t at;                 /* that is, its offset */
	size_t n;                  /* of numbers in its array; 0: no array */
	const struct range *range; /* NULL: range_any */
	const char *const *words;  /* that it can be; NULL ends them */
	/* Where objects are of several kinds, as projections are of types: the
	 * kinds that have the member, as bits; 0 for all of them. The words of
	 * the table's first row name the kinds. */
	unsigned kinds;
	/* What else people call it, divided by blanks: in lower case, without
	 * _ and -. */
	const char *aliases;
	/* Of a member of a scene: its own members, and an example of it. */
	const struct member *members;
	const char *example;
};

/* The ways in which the members of an object can be combined: each lists names,
 * of which those with ? may be missing. An object takes one way, in whole, and
 * has no member of another. */
struct ways {
	const char *hint; /* says what the ways are */
	const char *way[8];
};

/* Reads an object of a kind (0 where there are none) into the struct at base.
 * Returns the members that were there, as bits in the table's order. Members
 * that begin with _ and $schema are passed over; others that are unknown, or
 * of another kind, or repeated are refused. */
unsigned object_read(const struct value *, const struct member *, int kind,
    void *base);

/* The bit of a member; 0 where objects of that kind have none of this name. */
unsigned member_bit(const struct member *, int kind, const char *name);

/* Which way the members that were seen take; refuses what takes none, or not
 * the whole of one, or more than one. */
int object_way(const struct value *, const struct member *, int kind,
    unsigned seen, const struct ways *);

#endif
