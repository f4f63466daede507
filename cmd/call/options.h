/* SPDX-License-Identifier: MIT */
/* The options of all commands, and the operands after the options. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "../../core/points/transform.h"
#include "../json/value.h"
#include "../lines/line.h"
#include "command.h"

/* The list of --decimals or --digits: a style for each printed coordinate. The last
 * number given is that of the coordinates after it, too. */
struct styles {
	int n; /* numbers given; 0: print the fewest digits that read back */
	struct number_style style[COORDINATES_MAX];
};

/* The numbers of an option's list, up to 1e150 in magnitude. */
enum { NUMBER_LIST_MAX = 32 };

struct number_list {
	int n; /* 0: the option was not given */
	double v[NUMBER_LIST_MAX];
};

struct options {
	unsigned convention; /* index in conventions */
	bool has_convention; /* else the document has it */
	bool help, version;
	enum format in, out;
	int in_record, out_record; /* numbers in a record: 4 of f32x4; or 0 */
	bool has_out;   /* else points stay in format in, a matrix is text */
	char separator; /* of csv, a comma by default */
	bool header, no_header; /* neither: the first line of csv decides */
	struct columns columns; /* of POINTS, by --columns */
	struct styles styles;   /* of --decimals or --digits */
	enum precision precision;
	double tolerance; /* of inspect, device units; 0: not given */
	struct number_list distances; /* of inspect */
	bool has_from, has_to;
	enum space from, to;
	bool homogeneous, matrix, ray, append, flags, visible, keep_going,
	    progress;
	int jobs; /* 0: as many as there are cores */
	struct number_list pick_at, plane;
	double radius; /* of pick; 0: not given */
	const char
	    *of_points; /* a given option that is for points only, or NULL */
	bool scenes;    /* params has any number of documents */
	bool json;      /* of help */
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
	/* For an option with an argument: its name in the help, the function that reads
	 * the argument, and the offset in struct options of the member that the
	 * function sets. */
	const char *argument;
	void (*read)(struct options *, const struct option_row *, char *word);
	size_t at;
	unsigned *global; /* a variable to set instead of a member; or NULL */
	const char *const
	    *words;   /* the values of the argument; NULL ends them */
	int min, max; /* range of a whole number, or of the length of a list */
	const char *example;
	size_t on;      /* offset in struct options of a bool to set; or 0 */
	bool of_points; /* the option is for points only */
};

enum { OPTIONS_MAX = 40 };

/* All options, at most OPTIONS_MAX. A name of NULL ends them. */
extern const struct option_row option_rows[];

/* Reads --errors and --color, the options with a global, wherever they stand, so that
 * they hold for the first message, too. */
void options_read_first(char **words);

/* Returns the option of a name, which may end before = or a blank; or NULL. */
const struct option_row *option_named(const char *name);

/* Writes the commands that take an option: "project and trace". Returns list. */
const char *option_takers(const struct option_row *, char list[LIST_ROOM]);

bool option_is_for(const struct option_row *, const struct command *);

/* Reads the options and operands behind a command's name, up to --help or --version. */
void options_read(const struct command *, char **words, struct options *);

/* Returns the number of coordinates that the command reads of a point, by the options.
 * For the points of a flat document document_read changes it to 2. */
int coordinates_of(const struct command *, const struct options *);

/* Returns the format in which the command answers. */
enum format options_output(const struct options *);

/* Returns the style of numbers that are no points. Refuses a list of several styles. */
struct number_style options_style(const struct options *);

struct member;

/* Returns the member called name, else the member with that alias, else NULL. Sets
 * *object to the member of the scene that has or is the result. Of several results,
 * returns the one of the last object. */
const struct member *synonym_find(const char *name,
    const struct member **object);

/* Refuses a word that is no name in commands, whose last name is NULL, or if topic is
 * set, no topic of help. */
_Noreturn void synonym_refuse_word(const struct command *commands, bool topic,
    const char *word);

/* Refuses an option, such as "--eye" or "-eye", if its name is a synonym, a member of a
 * scene, or an option with two dashes; else returns. */
void synonym_check_option(const struct command *, const char *option,
    const char *name);

#endif
