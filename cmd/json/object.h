/* Objects of a document, each by the table of its members. */
#ifndef OBJECT_H
#define OBJECT_H

#include "value.h"

struct member {
	const char *name; /* NULL ends a table */
	/* Reads the member, into where the table's struct has it. */
	void (*read)(const struct value *, const struct member *, void *);
	size_t at;                 /* of the struct, in bytes */
	size_t n;                  /* numbers in an array; 0: one, bare */
	const struct range *range; /* NULL: any */
	const char *const *words;
	/* Bits of the kinds of the object that have it, 0 for all. The words
	 * of a table's first row name the kinds. */
	unsigned kinds;
	/* What else people call it: lower case, without _ and -. */
	const char *aliases;
	/* Of a member of the scene: its own members, and how it looks. */
	const struct member *fields;
	const char *example;
};

/* What goes with what: each way is names of members, those with ? may be
 * left out. Exactly one way must be taken, in whole. */
struct ways {
	const char *hint;
	const char *way[8];
};

/* Reads an object of a kind (0 where there are none) into the struct at base.
 * Returns the members that were there, as bits in the table's order. Members
 * that begin with _ and $schema are passed over; others that are unknown, or
 * of another kind, or repeated are refused. */
unsigned object_read(const struct value *, const struct member *, int kind,
    void *base);

/* The bit of a member; 0 where there is none of that kind. */
unsigned member_bit(const struct member *, int kind, const char *name);

/* Which way was taken; refuses none, half of one, or two. */
int object_way(const struct value *, const struct member *, int kind,
    unsigned seen, const struct ways *);

#endif
