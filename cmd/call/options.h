/* SPDX-License-Identifier: MIT */
/* The options and operands of a call, as the words of the command line give them.
 * Unknown and ambiguous words are refused. */
#pragma once

#include "../../core/points/transform.h"
#include "../json/value.h"
#include "../table/plan.h"
#include "command.h"

enum { NUMBER_LIST_MAX = 32 };

/* An option's argument that is a number or a list of numbers. */
struct number_list {
	int n; /* 0: the option was not given */
	double v[NUMBER_LIST_MAX];
};

struct options {
	const struct command *command; /* the command of this call */
	unsigned convention;           /* index in conventions[], by -c */
	bool has_convention;           /* -c was given */
	bool help, version;
	enum format in; /* FORMAT_SNIFF without -i: each input tells its format */
	enum format out;
	int in_record, out_record; /* numbers in a binary record, or 0 */
	bool has_out;              /* -o was given; if not, out is text */
	bool has_separator;
	char separator;         /* of csv, a comma by default */
	bool header, no_header; /* neither: the first line's fields decide */
	struct columns columns; /* of POINTS, by --columns */
	struct number_list decimals, digits;
	enum precision precision;
	struct number_list tolerance, distances;
	bool has_from, has_to;
	enum space from, to;
	bool names, text, homogeneous, matrix, unit_w, textbook, ray, directions;
	bool append, flags, visible, lines, keep_going, progress, quiet;
	const char *background; /* of draw, a file; or NULL */
	struct number_list jobs, pick_at, plane, radius;
	/* the name of a given option that is for points only; or NULL */
	const char *points_only_option;
	bool scenes;        /* params has any number of documents */
	bool json;          /* help prints JSON */
	const char *params; /* the operand PARAMS; "-" by default */
	int n_points;
	char **points; /* the operands POINTS */
};

/* Reads --errors and --color wherever they stand in `words`. They are read before all
 * other words, as they decide how messages about the other words look. */
void options_read_first(char **words);

/* Reads the options and operands behind a command's name, up to --help or --version. */
void options_read(struct options *, char **words);

/* Returns how many coordinates of a point the command reads, by the options alone. If
 * the document is 2D, the command reads two coordinates, whatever the result is. */
int options_coordinates(const struct options *);

/* Returns the format of printed points: `out` if has_out, else the input's format,
 * which may be FORMAT_SNIFF. */
enum format options_out_format(const struct options *);

/* Returns the style of coordinate k, from 0, by --decimals or --digits. The last of a
 * list also holds for all further coordinates. */
struct number_style options_style(const struct options *, int k);

/* Returns the style of the numbers in a matrix and in the output of inspect and pick.
 * Refuses a list of several styles. */
struct number_style options_matrix_style(const struct options *);
