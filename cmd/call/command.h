/* SPDX-License-Identifier: MIT */
/* The commands, rows of the table in main.c. */
#ifndef COMMAND_H
#define COMMAND_H

#include <string.h>

#include "../scene/document.h"

struct options;
struct transform;

/* Commands of one kind take the same options. Kinds are bits: an option row has the
 * union of the kinds that take it. */
enum command_kind {
	MATRIX = 1, /* prints a 3D matrix, or the images of points */
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
	/* What the command needs of a document. The convention and the number of
	 * coordinates are set later, from the options. */
	struct document_wants wants;
	/* For MATRIX and PLANAR commands: the spaces between which the matrix maps, and
	 * the space to which points are mapped: of enum flat_space for PLANAR, else of
	 * enum space. */
	int from, to, points_to;
	/* The arguments of a call that works, as typed in a shell. */
	const char *example;
};

void run_matrix(const struct command *, const struct options *);
void run_project(const struct command *, const struct options *);
void run_trace(const struct command *, const struct options *);
void run_pick(const struct command *, const struct options *);
void run_fit(const struct command *, const struct options *);
void run_inspect(const struct command *, const struct options *);

/* Prints the matrix of a transform in the format and precision of the options, for the
 * row or column vectors of the answer's convention. A matrix for two coordinates has no
 * row or column for z. */
void print_matrix(const struct options *, const struct document *,
    const struct transform *);

/* Print help. help_all lists the commands, up to the row without a name; help_command
 * describes one; help_member describes a member of the scene or of its objects, or
 * returns false if there is none; help_json prints all that the tables say. */
void help_all(const struct command *);
void help_command(const struct command *);
bool help_member(const char *name);
void help_json(const struct command *, const char *version);

/* Returns the command with a name, or NULL, from a table that a name of NULL ends. */
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
