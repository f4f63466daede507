/* SPDX-License-Identifier: MIT */
/* A command is a row of the table in main.c. What is done for it is in the file of its
 * name, or in matrix.c. */
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

/* What is done for a command. */
struct work {
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
};

extern const struct work matrix_work, project_work, trace_work, pick_work, fit_work,
    inspect_work, draw_work;

struct command {
	const char *name;
	const char *about; /* one line of help */
	enum command_kind kind;
	const struct work *work; /* NULL: that of help, which reads no document */
	/* params_read_document adds to a copy what the options need. */
	struct document_wants wants;
	/* The spaces of the matrix. COMMAND_MATRIX_3D prints points
	 * in ndc, not clip. */
	enum space from, to;
	/* Arguments for an example of a call, as typed in a shell. */
	const char *example;
};

static inline bool command_reads_points(const struct command *c)
{
	return (c->wants.used & SCENE_POINTS) != 0;
}
