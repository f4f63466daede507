/* SPDX-License-Identifier: MIT */
/* Reads the options of a command. Refuses unknown words with a hint. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "../../core/points/transform.h"
#include "../json/value.h"
#include "../lines/line.h"
#include "command.h"

/* The list of --decimals or --digits: a style for each printed coordinate. The last
 * style of the list also holds for all further coordinates. */
struct styles {
	int n; /* styles in the list; 0: neither option was given */
	struct number_style style[COORDINATES_MAX];
};

enum { NUMBER_LIST_MAX = 32 };

/* An option's argument that is a list of numbers, each at most 1e150 in magnitude. */
struct number_list {
	int n; /* 0: the option was not given */
	double v[NUMBER_LIST_MAX];
};

struct options {
	const struct command *command; /* the command of this call */
	unsigned convention;           /* index in conventions[], by -c */
	bool has_convention;           /* -c was given */
	bool help, version;
	enum format in, out;
	int in_record, out_record; /* numbers in a binary record, or 0 */
	bool has_out;              /* -o was given; if not, out is text */
	char separator;            /* of csv, a comma by default */
	bool header, no_header;    /* neither: the first line's fields decide */
	struct columns columns;    /* of POINTS, by --columns */
	struct styles styles;      /* of --decimals or --digits */
	enum precision precision;
	double tolerance;             /* by --tolerance; 0: not given */
	struct number_list distances; /* by --distances */
	bool has_from, has_to;
	enum space from, to;
	bool homogeneous, matrix, ray, append, flags, visible, keep_going,
	    progress;
	int jobs; /* threads; 0: one for each processor */
	struct number_list pick_at, plane; /* by --at, by --plane */
	double radius;                     /* by --radius; 0: not given */
	/* the name of a given option that is for points only; or NULL */
	const char *points_option;
	bool scenes;        /* params has any number of documents */
	bool json;          /* help prints JSON */
	const char *params; /* the operand PARAMS; "-" by default */
	int n_points;
	char **points; /* the operands POINTS */
};

/* Names in the order of enum precision and of enum space; NULL ends each array. */
extern const char *const precision_names[], *const space_names[];

struct option_row {
	const char *name;
	char letter;       /* or 0 */
	unsigned kinds;    /* of the commands that take the option, as bits */
	const char *about; /* one line of help */
	/* For an option with an argument: the argument's name in the help, the function
	 * that reads the argument, and the offset in struct options of the member that
	 * the function sets. */
	const char *argument;
	void (*read)(struct options *, const struct option_row *, char *word);
	size_t offset;
	unsigned *global; /* a variable to set instead of the member; or NULL */
	const char *const *words; /* possible arguments; NULL ends them */
	int min, max; /* range of a whole number, or of the length of a list */
	const char *example;
	size_t flag;      /* offset in struct options of a bool to set; or 0 */
	bool points_only; /* the option is for points only */
};

enum { OPTIONS_MAX = 40 };

/* All options, at most OPTIONS_MAX. A name of NULL ends them. */
extern const struct option_row option_rows[];

/* Reads --errors and --color wherever they stand in `words`. They are read before all
 * other words, as they decide how messages about the other words look. */
void options_read_first(char **words);

/* Returns the option called `name`, or NULL. A NUL, = or blank ends the name. */
const struct option_row *option_named(const char *name);

/* Returns whether the command takes the option. Either may be NULL. */
bool option_is_for(const struct option_row *, const struct command *);

/* Reads the options and operands behind a command's name, up to --help or --version. */
void options_read(struct options *, char **words);

/* Returns how many coordinates of a point the command reads, by the options alone. If
 * the document is 2D, the command reads two coordinates, whatever the result is. */
int coordinates_of(const struct options *);

/* Returns the format of printed points: `out` if has_out, else the input's format. */
enum format options_output(const struct options *);

/* Returns the style of the numbers in a matrix and in the output of inspect and pick.
 * Refuses a list of several styles. */
struct number_style options_style(const struct options *);

struct member;

/* Returns the member called `name` of a scene or of one of its objects; else a member
 * with the alias `name`; else NULL. Searches from the last object to the first. Sets
 * *object to the member of the scene that is the result or contains it. */
const struct member *synonym_find(const char *name,
    const struct member **object);

/* Refuses `word`, an unknown command or, if `topic` is true, an unknown topic of help.
 * A name of NULL ends the table `commands`. */
_Noreturn void synonym_refuse_word(const struct command *commands, bool topic,
    const char *word);

/* Refuses the word `option`, such as "--eye", if `name` is an option or member, or has
 * a hint by synonym_of. `name` is the word without dashes or, for "-t", "tolerance". */
void synonym_check_option(const struct command *, const char *option,
    const char *name);

#endif
