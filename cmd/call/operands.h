/* SPDX-License-Identifier: MIT */
/* The operands of a command: PARAMS, a document, and POINTS. */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "options.h"
#include "../stream/job.h"

/* A hint of pick for points of two numbers: the user may mean the position. */
#define POSITION_HINT "; --at 320,240 is the position"

/* Refuses operands that can't be opened, before anything is printed. */
void operands_check(const struct command *, const struct options *);

/* Moves to the next document of PARAMS and returns whether there is one: without
 * --scenes only the first. Messages name that scene from then on. */
bool params_next(const struct options *);

/* Reads the document as the command needs it, by the options. Its points stay in the
 * text of PARAMS until params_next. */
void read_document(const struct command *, const struct options *,
    struct document *);

/* Returns whether there are points, as operands or in the document. If there are none,
 * refuses options that are about points alone. */
bool has_points(const struct command *, const struct options *,
    const struct document *);

/* Completes a job by the options, and runs it on all points: of the operands, else of
 * the document, else of standard input. The caller sets the transform or the ray maker.
 * Operands are read once for all scenes. */
void run_points(const struct options *, const struct document *, struct job *);

/* A text: the first have bytes of s. There is memory for room bytes, and PIECE_MARGIN
 * more, as the readers of points read past the end. */
struct text {
	char *s; /* NULL at first */
	size_t room, have;
};

bool is_stdin(const char *operand);

/* Returns the first character that is not white space. */
char first_char(const char *);

/* Returns whether there is a file: fd or, if fd < 0, name. Refuses with exit status 2 a
 * directory, and the file of standard output, whose output would be read again. */
bool check_input(const char *name, int fd);

/* Returns a descriptor of a file, or of standard input for "-". Refuses with exit
 * status 2 what check_input refuses, and a file that can't be opened. */
int open_input(const char *name);

/* Appends the next bytes of fd to the text. Returns false at the end of the file. name
 * is for messages. */
bool read_more(struct text *, int fd, const char *name);

/* Returns the text of a file, or of standard input for "-". */
struct text read_whole(const char *name);

struct text copy_operand(const char *operand);
void text_free(struct text *);

#endif
