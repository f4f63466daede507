/* The options of all commands, and the operands after them. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "../core/points.h"
#include "arguments.h"
#include "command.h"

struct options {
	bool help, version;
	const struct convention *convention; /* NULL: the document's */
	enum format in, out;
	bool has_out;   /* else out is the same as in, or text for a matrix */
	char separator; /* of csv, a comma by default */
	bool header, no_header; /* of csv: the first line is one, or none */
	struct columns columns; /* of POINTS, by --columns */
	struct number_style style;
	enum precision precision;
	bool has_precision;
	struct tolerances tolerances;
	bool has_from, has_to;
	enum space from, to;
	bool homogeneous, matrix, ray, flags, visible, keep_going, progress;
	int jobs; /* 0: as many as there are cores */
	bool has_at;
	double at[2], radius; /* of pick; radius is 0 where it isn't said */
	bool scenes;          /* params has any number of documents */
	const char *params;   /* operand, "-" by default */
	int n_points;
	char **points; /* operands */
};

/* In the order of enum precision and enum space; NULL ends them. */
extern const char *const precision_names[], *const space_names[];

/* Reads a command's options and operands; argv[0] is its name. Stops as soon as
 * the help or the version is asked for. */
void options_read(const struct command *, int argc, char **argv,
    struct options *);

/* A line of help for each option that the command takes. */
void options_print(const struct command *);

#endif
