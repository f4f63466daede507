/* SPDX-License-Identifier: MIT */
/* The table of all options. A row says how an option is called and read, and which
 * commands take it; parsing, help, completions and hints follow from it. */
#pragma once

#include "options.h"

/* Names in the order of enum precision and of enum space; NULL ends each array. */
extern const char *const precision_names[], *const space_names[];
extern const char *const space_aliases[]; /* of each space: see struct member */

struct option_row {
	const char *name;
	char letter;          /* or 0 */
	unsigned kinds;       /* of the commands that take the option, as bits */
	const char *about;    /* one line of help */
	const char *argument; /* its name in the help; NULL: the option takes none */
	void (*read)(struct options *, const struct option_row *, char *word);
	size_t offset;            /* in struct options, of what `read` sets */
	unsigned *global;         /* a variable to set instead of the member; or NULL */
	const char *const *words; /* possible arguments; NULL ends them */
	const char *const *word_aliases; /* of each word; or NULL: see struct member */
	/* of a list of numbers: its length, their range, and what is wanted, in
	 * words */
	int min, max;
	double least, most;
	bool whole;
	const char *wanted;
	size_t flag;      /* offset in struct options of a bool to set; or 0 */
	bool points_only; /* the option is for points only */
};

enum { OPTIONS_MAX = 48 };

/* All options, at most OPTIONS_MAX. A name of NULL ends them. */
extern const struct option_row option_rows[];

/* Returns the option called `name`, or NULL. A NUL, = or blank ends the name. */
const struct option_row *option_find(const char *name);

bool option_is_for(const struct option_row *, const struct command *); /* or NULL */
