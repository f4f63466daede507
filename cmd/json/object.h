/* SPDX-License-Identifier: MIT */
/* Objects of a document. A table of an object's members says what each may be,
 * where in a struct it stands, and what the help tells of it. */
#ifndef OBJECT_H
#define OBJECT_H

#include <stdint.h>

#include "print.h"
#include "value.h"

struct member;

/* Of an object, as bits. */
#define ALL_MEMBERS (~UINT64_C(0))

/* What a member's value is made of. Both functions get the place in the struct. */
struct type {
	const char *says; /* for the help; NULL: what range, n and words tell */
	void (*read)(const struct value *, const struct member *, void *);
	/* NULL where such members are never printed. */
	void (*print)(struct printer *, const struct member *, const void *);
	size_t size; /* of one in the struct; 0: it has no usual value */
};

struct member {
	const char *name; /* NULL ends a table */
	const struct type *type;
	size_t at; /* where in the struct it stands */
	/* Where the struct has a bool that is set where the member is read, and
	 * without which it is not printed; 0: nowhere. */
	size_t has;
	size_t n; /* of numbers in an array; 0: one number */
	const struct value_range *range; /* of numbers; NULL: range_any */
	const char *const *words;        /* of a string; NULL ends them */
	unsigned first;                  /* what words[0] stands for */
	/* Where objects are of several kinds, as projections are of types: the
	 * kinds that have the member, as bits; 0 for all of them. The words of
	 * the table's first row name the kinds. Kinds may have different members
	 * of one name. */
	unsigned kinds;
	/* What it is without being given, as JSON; or NULL. Then it is printed
	 * only where it is another, or shown is set. Angles are degrees. */
	const char *usual;
	bool shown;
	/* What holds before that, for the help; or NULL. */
	const char *before;
	/* What else people call it, divided by blanks: in lower case, without
	 * _ and -. */
	const char *aliases;
	/* What it is, for those who call it otherwise. */
	const char *note;
	/* Its unit, or NULL; and in a few words what it says. */
	const char *unit, *about;
	/* Of a member of a scene: its own members, and the ways to combine
	 * them; an example of it, and of a command that reads it. */
	const struct member *members;
	const struct ways *ways;
	const char *example, *command;
	/* It may also stand in the document that is another of them alone. */
	bool beside;
};

/* A row of a table: the member of that name stands in a field of struct in. */
#define ROW(in, label, of, field, ...)                        \
	{                                                     \
		.name = label, .type = &(of),                 \
		.at = offsetof(struct in, field), __VA_ARGS__ \
	}

/* The ways in which members of an object can be combined. A way lists names
 * with blanks between them; those with ? may be missing. An object takes one
 * way, in whole, and has no member that is only in another. */
enum { WAYS_MAX = 10 };
struct ways {
	const char *way[WAYS_MAX + 1]; /* none ends a list of ways */
	/* For the command fit, where they are others; none if fit takes any. */
	bool fit;
	const char *fit_way[WAYS_MAX + 1];
	unsigned kinds; /* that have these ways; 0 for all */
	/* Where the struct has the index of the way taken, an unsigned, and what that
	 * is for the first way; 0: nowhere. */
	size_t at;
	unsigned first;
};

/* Reads an object of that kind, 0 where there are no kinds, into the struct at
 * base, where first all members get what is usual; NULL: reads no values. Returns the members it has, as bits
 * in the order of the table. Members that begin with _, $schema, and what may stand
 * beside, are passed over; any other that is unknown, of another kind, or repeated is
 * refused. */
uint64_t object_read(const struct value *, const struct member *, int kind,
    void *base);

/* Reads the value of a member to its place in the struct at base. */
void object_read_member(const struct value *, const struct member *,
    void *base);

/* Prints an object of those members that bits are and objects of that kind have, but
 * for what is usual, or a size of 0, which was not given; or its members alone, each
 * name by put. */
void object_print(struct printer *, const struct member *, int kind,
    uint64_t bits, const void *base);
void object_put(struct printer *, const struct member *, int kind,
    uint64_t bits, const void *base,
    void (*put)(struct printer *, const char *name));

/* Returns as bits the members of that way, and all that are in none. */
uint64_t object_shown(const struct member *, int kind, const struct ways *,
    int way);

/* The member that objects of that kind have of that name; or the same, or else that
 * has that alias; or NULL. */
enum { ANY_KIND = -1 };
const struct member *member_of(const struct member *, int kind,
    const char *name);
const struct member *member_named(const struct member *, int kind,
    const char *name);

/* What its value is: "3 numbers", "size", "left or right", which may be written to
 * out; and its unit, or NULL. */
const char *member_type(const struct member *, char out[LISTED]);
const char *member_unit(const struct member *);

/* Whether objects of that kind have the member. */
bool member_is_of(const struct member *, int kind);

/* The bit of the member of that name; 0 if objects of that kind have none. */
uint64_t member_bit(const struct member *, int kind, const char *name);

/* The index of the way that the members seen, as bits, take. Refuses an object
 * that takes none in whole, or has members of another as well. */
int object_way(const struct value *, const struct member *, int kind,
    uint64_t seen, const struct ways *);

#endif
