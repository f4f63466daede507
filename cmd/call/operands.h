/* SPDX-License-Identifier: MIT */
/* The operands of a command: PARAMS, a document, and POINTS. */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "options.h"
#include "../stream/stream.h"

/* Before anything is printed, an operand that can't be opened is refused. */
void check_operands(const struct command *, const struct options *);

/* Reads the document of PARAMS that is next. */
void read_document(const struct command *, const struct options *,
    struct document *);

/* Goes on to the next document of PARAMS: with --scenes there are any number of them,
 * one after another; false where there is none. What is said from now on is about
 * that scene. */
bool params_next(const struct options *);

/* Reads the document, which may leave points in the text: they are there until
 * params_next. */
void params_read(const struct options *, const struct document_wants *,
    struct document *);

/* Whether points are given: as operands or in the document. */
bool has_points(const struct options *, const struct document *);

/* Fills in what the options say of a job whose transform or ray maker is set,
 * and prepares progress, output and kernels for it. */
void prepare_job(struct job *, const struct options *);

/* Does the job on all points: the operands, else the document's, else those of
 * standard input. Operands are read once, however many scenes there are. */
void do_points(const struct options *, const struct document *, struct job *);

#endif
