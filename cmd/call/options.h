/* SPDX-License-Identifier: MIT */
/* The options of all commands, and the operands after them. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "../../core/points/points.h"
#include "../json/value.h"
#include "../lines/line.h"
#include "command.h"

/* From --decimals or --digits: one for each coordinate printed, the last for the
 * rest. */
struct styles {
	int n; /* 0: none, all are the shortest */
	struct number_style style[COORDINATES_MAX];
};

/* Numbers up to 1e150 in magnitude. */
enum { NUMBERS_SAID_MAX = 32 };

struct numbers_said {
	int n; /* 0: the option was not given */
	double v[NUMBERS_SAID_MAX];
};

struct options {
	unsigned convention; /* index in conventions */
	bool has_convention; /* else it is the document's */
	unsigned errors;     /* 1: messages are JSON */
	enum color color;
	bool help, version;
	enum format in, out;
	int in_record, out_record; /* numbers of a record, by f32x4; else 0 */
	bool has_out;   /* else out is the same as in, or text for a matrix */
	char separator; /* of csv, a comma by default */
	bool header, no_header; /* of csv: the first line is one, or none */
	struct columns columns; /* of POINTS, by --columns */
	struct styles styles;
	enum precision precision;
	double tolerance;              /* of inspect; 0 where it isn't said */
	struct numbers_said distances; /* of inspect */
	bool has_from, has_to;
	enum space from, to;
	bool homogeneous, matrix, ray, append, flags, visible, keep_going,
	    progress;
	int jobs; /* 0: as many as there are cores */
	struct numbers_said pick_at, plane;
	double radius;      /* of pick; 0 where it isn't said */
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
	/* Of an option with an argument: what the help calls that; what reads it;
	 * the offset in struct options of what is set. */
	const char *argument;
	void (*read)(struct options *, const struct option_row *, char *word);
	size_t at;
	const char *const *words; /* that it may be; NULL ends them */
	int min, max; /* of a whole number; how many numbers there may be */
	const char *example;
	/* The offset of a bool of struct options that becomes true; or 0. */
	size_t on;
};

/* There are at most so many. */
enum { OPTIONS_MAX = 40 };

/* All of them; name is NULL after the last. */
extern const struct option_row option_rows[];

/* Sets how messages are printed. */
void options_say(const struct options *);

/* The same, before anything else can be wrong. */
void options_first(char **words);

/* The option of that name, behind which a value may stand, after = or a blank;
 * or NULL. */
const struct option_row *option_named(const char *name);

/* Writes the commands that take an option: "project and trace". Returns list. */
const char *option_takers(const struct option_row *, char list[LISTED]);

bool option_is_for(const struct option_row *, const struct command *);

/* Reads the options and operands that follow a command's name. Stops as soon as
 * the help or the version is asked for. */
void options_read(const struct command *, char **words, struct options *);

/* How many numbers are read of a point. Fit learns only from the scene that it is in
 * the plane. */
int coordinates_of(const struct command *, const struct options *);

/* Returns the format in which the command answers. */
enum format options_output(const struct options *);

/* Returns how to round what is rounded alike; refuses a list of -d or --digits. */
struct number_style one_style(const struct options *);

#endif
