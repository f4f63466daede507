/* SPDX-License-Identifier: MIT */
/* What a command is: a row of the table in main.c. */
#ifndef COMMAND_H
#define COMMAND_H

#include <string.h>

#include "../scene/document.h"

struct options;
struct transform;

/* Commands of one kind take the same options. Kinds are bits, so that an option
 * can list the kinds that take it. */
enum command_kind {
	MATRIX = 1, /* print a matrix of their own, or take points through it */
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
	/* Prints what the command makes of a scene; what is wrong ends the
	 * program. */
	void (*run)(const struct command *, const struct options *);
	/* All but convention and coordinates, which come from the options. */
	struct document_wants wants;
	/* For the MATRIX and PLANAR commands: the spaces that the matrix leads
	 * from and to, and the space to which points are taken, which may be
	 * another. They are of enum flat if PLANAR, else of enum space. */
	int from, to, points_to;
	/* What may stand after its name, in the shell, and works. */
	const char *example;
};

void run_matrix(const struct command *, const struct options *);
void run_project(const struct command *, const struct options *);
void run_trace(const struct command *, const struct options *);
void run_pick(const struct command *, const struct options *);
void run_fit(const struct command *, const struct options *);
void run_inspect(const struct command *, const struct options *);

/* Prints the matrix of a transform's map, without rows and columns for z where it
 * takes or makes two coordinates, for row or column vectors as the convention of the
 * answer says, in the format and precision of the options. */
void print_matrix(const struct options *, const struct document *,
    const struct transform *);

/* Print what the program says of itself, which stands in the rows that it goes by: of
 * all commands, to one with a name of NULL; of one; of a member of a scene or of its
 * objects, false if there is none; and everything as one JSON object. */
void help_all(const struct command *);
void help_command(const struct command *);
bool help_member(const char *name);
void help_json(const struct command *, const char *version);

/* The command of that name, or NULL: in a table that a name of NULL ends. */
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
