/* SPDX-License-Identifier: MIT */
/* Reads the operands: PARAMS, which is one JSON document or several, and POINTS. */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "options.h"
#include "../stream/job.h"

/* Ends a message of pick about a point of two numbers: was it meant for --at? */
#define POSITION_HINT "; --at 320,240 is the position"

/* Refuses operands that the command does not take or that can't be opened. Runs before
 * anything is printed. */
void operands_check(const struct options *);

/* Moves to the next document of PARAMS and returns whether there is one. Without
 * --scenes there is one; with --scenes, messages begin with the document's number. */
bool params_next(const struct options *);

/* Reads the current document for the command and the options. document.points stays
 * valid until the next call of params_next. */
void read_document(const struct options *, struct document *);

/* Returns whether there are points, as operands or in the document. If there are none,
 * refuses options that are only for points. */
bool has_points(const struct options *, const struct document *);

/* Completes the job by the options, and does it on all points: those of the operands,
 * else of the document, else of standard input. The caller has set job.transform, or
 * job.rays and job.ray. Operands are read once for all documents of --scenes. */
void run_points(const struct options *, const struct document *, struct job *);

/* A text of size bytes at s. s has memory for room bytes and PIECE_MARGIN more, as the
 * readers of points read past the end of the text. */
struct text {
	char *s; /* NULL at first */
	size_t room, size;
};

bool is_stdin(const char *operand);

/* Returns the first character that is not white space; 0 if there is none. */
char first_nonblank(const char *);

/* Returns whether fstat(fd), or stat(name) if fd < 0, succeeds. Refuses with status 2 a
 * directory, and the file that is standard output, as output would become input. */
bool check_input(const char *name, int fd);

/* Returns a descriptor of a file, or of standard input for "-". Refuses with exit
 * status 2 what check_input refuses, and a file that can't be opened. */
int open_input(const char *name);

/* Appends the next bytes of fd to the text. Returns false at the end of the file. */
bool text_read_more(struct text *, int fd, const char *name);

/* Returns the text of a file, or of standard input for "-". */
struct text text_of_file(const char *name);

struct text text_of_operand(const char *operand);
void text_free(struct text *);

#endif
