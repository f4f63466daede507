/* SPDX-License-Identifier: MIT */
/* The operands of a command: PARAMS, a document, and POINTS. */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "options.h"
#include "../stream/stream.h"

/* Refuses operands that can't be opened, before anything is printed. */
void operands_check(const struct command *, const struct options *);

/* Moves to the next document of PARAMS: with --scenes there are any number of them, one
 * after another. Returns false if there is none. Messages name that scene from now on. */
bool params_next(const struct options *);

/* Reads the document, with the command's convention and coordinates. */
void read_document(const struct command *, const struct options *,
    struct document *);

/* Reads the document. Its points stay in the text of PARAMS until params_next. */
void params_read(const struct options *, const struct document_wants *,
    struct document *);

/* Returns whether there are points, as operands or in the document. */
bool has_points(const struct options *, const struct document *);

/* Refuses options that are about points alone, where there are none. */
void refuse_point_options(const struct command *, const struct options *);

/* Completes a job whose transform or ray maker is set by what the options say, and
 * prepares progress, output and kernels for it. */
void prepare_job(struct job *, const struct options *);

/* Runs the job on all points: the operands; without them the document's; without these
 * standard input. Operands are read once for all scenes. */
void run_points(const struct options *, const struct document *, struct job *);

#endif
