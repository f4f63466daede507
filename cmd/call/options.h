/* SPDX-License-Identifier: MIT */
/* The options of all commands, and the operands after them. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "../../core/points/points.h"
#include "arguments.h"
#include "command.h"

struct options {
	const struct convention *convention; /* NULL: the document's */
	bool help, version;
	enum format in, out;
	int in_record, out_record; /* numbers of a record, by f32x4; else 0 */
	bool has_out;   /* else out is the same as in, or text for a matrix */
	char separator; /* of csv, a comma by default */
	bool header, no_header; /* of csv: the first line is one, or none */
	struct columns columns; /* of POINTS, by --columns */
	struct styles styles;
	enum precision precision;
	double tolerance; /* of inspect; 0 where it isn't said */
	int n_distances;
	double distance[DISTANCES_MAX]; /* of inspect */
	bool has_from, has_to;
	enum space from, to;
	bool homogeneous, matrix, ray, append, flags, visible, keep_going,
	    progress;
	int jobs; /* 0: as many as there are cores */
	bool has_at;
	double at[2], radius; /* of pick; radius is 0 where it isn't said */
	bool has_plane;
	double plane[4];
	bool scenes;        /* params has any number of documents */
	bool json;          /* of help */
	const char *params; /* operand, "-" by default */
	int n_points;
	char **points; /* operands */
};

/* In the order of enum precision and enum space; NULL ends them. */
extern const char *const precision_names[], *const space_names[];

struct option_row {
	const char *name;
	char letter;       /* or 0 */
	unsigned commands; /* the kinds that take it, as bits */
	const char *about; /* one line of help */
	/* With an argument: what the help calls that; and what reads it, or
	 * else the words that it may be, what they are names of, and the
	 * offset of the enum, in their order, that is set. */
	const char *argument;
	void (*set)(struct options *, char *word);
	const char *const *words;
	const char *what;
	size_t at;
	/* The offset of a bool of struct options that becomes true; or 0. */
	size_t on;
};

/* There are at most so many. */
enum { OPTIONS_MAX = 40 };

/* All of them; name is NULL after the last. */
extern const struct option_row option_rows[];

/* Sets how messages are printed, before anything else can be wrong. */
void options_first(char **words);

/* The option of that name, behind which a value may stand, after = or a blank;
 * or NULL. */
const struct option_row *option_named(const char *name);

bool option_is_for(const struct option_row *, const struct command *);

/* How many numbers are read of a point. Fit learns only from the scene that it is in
 * the plane. */
int coordinates_of(const struct command *, const struct options *);

/* Returns the format in which the command answers. */
enum format options_output(const struct options *);

/* How to round what is to be rounded alike: refuses a list of -d or --digits. what
 * is printed, for the message. */
struct number_style one_style(const struct options *, const char *what);

#endif
