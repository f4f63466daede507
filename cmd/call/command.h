/* SPDX-License-Identifier: MIT */
/* Each command is a row of the table in main.c. */
#ifndef COMMAND_H
#define COMMAND_H

#include <string.h>

#include "../scene/document.h"

struct options;
struct transform;

/* Commands of one kind take the same options. Each kind is a bit, so that the member
 * `kinds` of struct option_row can name several kinds. */
enum command_kind {
	MATRIX_3D = 1, /* prints a 3D matrix, or the images of points */
	PROJECT = 2,
	PICK = 4,
	FIT = 8,
	INSPECT = 16,
	TRACE = 32,
	MATRIX_2D = 64, /* prints a 2D matrix, or the images of 2D points */
	HELP = 128,
};

struct command {
	const char *name;
	const char *about; /* one line of help */
	enum command_kind kind;
	/* Reads the scene and prints the answer. Does not return after an error. */
	void (*run)(const struct options *);
	/* The command's needs of a document. To a copy of them, read_document adds what
	 * the options need, and the place of the document's text in its file. */
	struct document_wants wants;
	/* For MATRIX_3D and MATRIX_2D: the matrix maps the space `from` to the space
	 * `to`, and points are printed in the space `points_to`. The values are of enum
	 * space for MATRIX_3D, of enum flat_space for MATRIX_2D. */
	int from, to, points_to;
	/* Arguments for an example of a call, as typed in a shell. */
	const char *example;
};

void run_matrix(const struct options *);
void run_project(const struct options *);
void run_trace(const struct options *);
void run_pick(const struct options *);
void run_fit(const struct options *);
void run_inspect(const struct options *);

/* Prints the matrix of a transform in the format and precision of the options, for row
 * or column vectors as the convention of the answer says. For a space whose points have
 * two coordinates, the matrix lacks the row or column of z. */
void print_matrix(const struct options *, const struct document *,
    const struct transform *);

/* Print help. help_all lists the commands, up to a row without a name. help_command
 * describes one command. help_member describes a member of the scene or of its objects,
 * and returns false if no member has the name. help_json prints all help as JSON. */
void help_all(const struct command *);
void help_command(const struct command *);
bool help_member(const char *name);
void help_json(const struct command *, const char *version);

/* Returns the command called `name` in the table c, which a NULL name ends; or NULL. */
static inline const struct command *find_command(const struct command *c,
    const char *name)
{
	for (; c->name != NULL; c++)
		if (strcmp(name, c->name) == 0)
			return c;
	return NULL;
}

static inline bool command_reads_points(const struct command *c)
{
	return (c->wants.used & SCENE_POINTS) != 0;
}

#endif
