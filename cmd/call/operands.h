/* SPDX-License-Identifier: MIT */
/* Reads the operands: PARAMS, which is one JSON document or several, and POINTS. */
#ifndef OPERANDS_H
#define OPERANDS_H

#include "options.h"
#include "../stream/job.h"

/* Ends messages of the command pick that refuse a point of two numbers. */
#define POSITION_HINT "; --at 320,240 is the position"

/* Refuses wrong operands and files that can't be opened, before anything is printed. */
void operands_check(const struct options *);

/* Moves to the next document of PARAMS and returns whether there is one. With --scenes,
 * PARAMS may have several, and messages begin with the number of the document. */
bool params_next(const struct options *);

/* Reads from the current document what the command and the options need. The points in
 * struct document stay valid until the next call of params_next. */
void read_document(const struct options *, struct document *);

/* Returns whether there are points, as operands or in the document. If there are none,
 * refuses options that are only for points. */
bool has_points(const struct options *, const struct document *);

/* Completes the job by the options, and does it on the points of the operands; without
 * operands, on those of the document or, if it has none, of standard input. The caller
 * has set job.transform, or job.rays and job.ray. --scenes reads operands only once. */
void run_points(const struct options *, const struct document *, struct job *);

/* A text of `size` bytes at `s`. `room` + PIECE_MARGIN bytes are allocated, as the
 * readers of points read past the end of the text. */
struct text {
	char *s; /* NULL at first */
	size_t room, size;
};

bool is_stdin(const char *operand);

/* Returns the first character that is not white space; 0 if there is none. */
char first_nonblank(const char *);

/* Returns false if fstat(fd) or, for fd < 0, stat(name) fails. Refuses, with status 2,
 * a directory, and the file to which standard output goes: it can't be input, too. */
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
