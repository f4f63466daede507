/* SPDX-License-Identifier: MIT */
/* The operands of a command: PARAMS, a document, and POINTS. */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "options.h"
#include "../stream/job.h"

/* A hint for points of two numbers, which may be pick's position. */
#define POSITION_HINT "; --at 320,240 is the position"

/* Refuses operands that can't be opened, before anything is printed. */
void operands_check(const struct command *, const struct options *);

/* Moves to the next document of PARAMS: with --scenes there are any number of them, one
 * after another. Returns false if there is none. Messages name that scene from now on. */
bool params_next(const struct options *);

/* Reads the document, with the command's convention and coordinates. Its points stay in
 * the text of PARAMS until params_next. */
void read_document(const struct command *, const struct options *,
    struct document *);

/* Returns whether there are points, as operands or in the document. If there are none,
 * refuses options that are about points alone. */
bool has_points(const struct command *, const struct options *,
    const struct document *);

/* Completes a job whose transform or ray maker is set by what the options say, and runs it
 * on all points: the operands; without them the document's; without these standard input.
 * Operands are read once for all scenes. */
void run_points(const struct options *, const struct document *, struct job *);

/* Files and standard input as texts in memory. */

/* A text. Beyond room it has PIECE_MARGIN more bytes, as the readers of points read past
 * the end. */
struct text {
	char *s; /* NULL at first */
	size_t room, have;
};

bool is_stdin(const char *operand);

/* Returns the first character that is not white space. */
char first_char(const char *);

/* Refuses a directory, and the regular file of standard output, which would be read again,
 * with exit status 2. Returns whether there is such a file: fd or, if fd < 0, name. */
bool check_input(const char *name, int fd);

/* Returns a file descriptor. Refuses what check_input refuses, and what can't be opened,
 * with exit status 2. */
int open_input(const char *name);

/* Reads more of fd to the end of the text. Returns false at the end of the file. name is
 * for messages. */
bool read_more(struct text *, int fd, const char *name);

/* Reads all of a file. */
struct text read_whole(const char *name);

struct text copy_operand(const char *operand);
void text_free(struct text *);

#endif
