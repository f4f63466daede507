/* SPDX-License-Identifier: MIT */
/* The commands, rows of the table in main.c. */
#ifndef COMMAND_H
#define COMMAND_H

#include <string.h>

#include "../scene/document.h"

struct options;
struct transform;

/* Commands of one kind take the same options. Kinds are bits: an option row has the union
 * of the kinds that take it. */
enum command_kind {
	MATRIX = 1, /* print their 3D matrix, or the images of points */
	PROJECT = 2,
	PICK = 4,
	FIT = 8,
	INSPECT = 16,
	TRACE = 32,
	PLANAR = 64, /* as MATRIX, in two dimensions */
	HELP = 128,
};

struct command {
	const char *name;
	const char *about; /* one line of help */
	enum command_kind kind;
	/* Answers one scene. An error ends the program. */
	void (*run)(const struct command *, const struct options *);
	/* The members that the document may have. Its convention and coordinates
	 * come from the options. */
	struct document_wants wants;
	/* Of MATRIX and PLANAR commands: the spaces that the matrix leads from and
	 * to, and the space of the images of points. They are of enum flat for
	 * PLANAR, else of enum space. */
	int from, to, points_to;
	/* Words of the shell behind the name that make a call that works. */
	const char *example;
};

void run_matrix(const struct command *, const struct options *);
void run_project(const struct command *, const struct options *);
void run_trace(const struct command *, const struct options *);
void run_pick(const struct command *, const struct options *);
void run_fit(const struct command *, const struct options *);
void run_inspect(const struct command *, const struct options *);

/* Prints the matrix of a transform's map in the format and precision of the options, for
 * the row or column vectors of the answer's convention. Two coordinates have no row or
 * column for z. */
void print_matrix(const struct options *, const struct document *,
    const struct transform *);

/* Print the help from the rows of commands, options and members: of all commands, to a
 * name of NULL; of one command; of a member of the scene or of its objects, false if
 * there is none; and everything as one JSON object. */
void help_all(const struct command *);
void help_command(const struct command *);
bool help_member(const char *name);
void help_json(const struct command *, const char *version);

/* Returns the command of a name, or NULL. A name of NULL ends the table. */
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
