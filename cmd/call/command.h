/* SPDX-License-Identifier: MIT */
/* A command is a row of the table in main.c, and its functions run_ and check_, or
 * help_ of the command help, are in the file of its name. They are declared here, as
 * only main.c calls them. */
#pragma once

#include "../scene/document.h"

struct job;
struct options;

/* Commands of one kind take the same options. Each kind is a bit, so that the member
 * `kinds` of struct option_row can name several kinds. */
enum command_kind {
	COMMAND_MATRIX_3D = 1, /* prints a 3D matrix, or the images of points */
	COMMAND_PROJECT = 2,
	COMMAND_PICK = 4,
	COMMAND_FIT = 8,
	COMMAND_INSPECT = 16,
	COMMAND_TRACE = 32,
	COMMAND_MATRIX_2D = 64, /* prints a 2D matrix, or the images of 2D points */
	COMMAND_DRAW = 128,
	COMMAND_HELP = 256,
	COMMAND_ALL = 2 * COMMAND_HELP - 1,
};

struct command {
	const char *name;
	const char *about; /* one line of help */
	enum command_kind kind;
	/* Prints the answer for a document; the job is zero at the first call. Returns
	 * false if the document is refused. */
	bool (*run)(const struct options *, struct document *, struct job *);
	/* Adds to the refusals of a refused document what else is wrong with it, each
	 * part by itself; its numbers that were refused are NaN. */
	void (*judge)(const struct options *, const struct document *);
	/* Refuses options that do not go together, before documents are read; or
	 * NULL. */
	void (*check)(const struct options *);
	/* Prints what was gathered of the documents before the end or a refusal; or
	 * NULL. */
	void (*finish)(void);
	/* params_read_document adds to a copy what the options need. */
	struct document_wants wants;
	/* The spaces of the matrix. COMMAND_MATRIX_3D prints points
	 * in ndc, not clip. */
	enum space from, to;
	/* Arguments for an example of a call, as typed in a shell. */
	const char *example;
};

bool run_matrix(const struct options *, struct document *, struct job *);
bool run_project(const struct options *, struct document *, struct job *);
bool run_trace(const struct options *, struct document *, struct job *);
bool run_pick(const struct options *, struct document *, struct job *);
bool run_fit(const struct options *, struct document *, struct job *);
bool run_inspect(const struct options *, struct document *, struct job *);
bool run_draw(const struct options *, struct document *, struct job *);
void judge_matrix(const struct options *, const struct document *);
void judge_project(const struct options *, const struct document *);
void judge_trace(const struct options *, const struct document *);
void judge_pick(const struct options *, const struct document *);
void judge_fit(const struct options *, const struct document *);
void judge_inspect(const struct options *, const struct document *);
void judge_draw(const struct options *, const struct document *);
void check_project(const struct options *);
void check_pick(const struct options *);
void check_draw(const struct options *);
void finish_draw(void);

/* Print help. help_all lists the commands, up to a row without a name. help_command
 * describes one command. help_member describes a member of the scene or of its objects,
 * and returns false if no member has the name. */
void help_all(const struct command *);
void help_command(const struct command *);
bool help_member(const char *name);

/* Prints all help as JSON, from which scripts make the schema and the completions. */
void help_json(const struct command *, const char *version);

static inline bool command_reads_points(const struct command *c)
{
	return (c->wants.used & SCENE_POINTS) != 0;
}
