/* SPDX-License-Identifier: MIT */
/* Files and standard input as texts in memory. */
#ifndef INPUT_H
#define INPUT_H

#include <stdbool.h>
#include <stddef.h>

/* A text. Beyond room it has PIECE_MARGIN more bytes, as the readers of points read past
 * the end. */
struct text {
	char *s; /* NULL at first */
	size_t room, have;
};

bool is_stdin(const char *operand);

/* Returns the first character that is not white space. */
char first_char(const char *);

/* Refuses a directory, and the regular file of standard output, with exit status 2. A
 * file that does not exist is left to open_input. */
void check_input(const char *name);

/* Returns a file descriptor. Refuses what check_input refuses, and what can't be opened,
 * with exit status 2. */
int open_input(const char *name);
void close_input(int fd);

/* Reads more of fd to the end of the text. Returns false at the end of the file. name is
 * for messages. */
bool read_more(struct text *, int fd, const char *name);

/* Reads all of a file. */
struct text read_whole(const char *name);

struct text copy_operand(const char *operand);
void text_free(struct text *);

#endif
