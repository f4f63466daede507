/* SPDX-License-Identifier: MIT */
/* Files and standard input as texts in memory. */
#ifndef INPUT_H
#define INPUT_H

#include <stdbool.h>
#include <stddef.h>

/* As points may be left in a text, it has PIECE_MARGIN bytes behind it for those who
 * read them. */
struct text {
	char *s; /* NULL at first */
	size_t room, have;
};

bool is_stdin(const char *operand);

/* Past white space. */
char first_char(const char *);

/* Whether a text is of numbers, and of what stands between and around them. */
bool is_numbers(const char *);

/* Refuses a directory, and the regular file that standard output is, with exit
 * status 2; leaves what is not there to open_input. */
void check_input(const char *name);

/* Returns a file descriptor. What check_input refuses, or what can't be opened, is
 * refused with exit status 2. */
int open_input(const char *name);
void close_input(int fd);

/* Reads some more of fd, whose name is for messages, to the end of the text.
 * False where there is no more. */
bool read_more(struct text *, int fd, const char *name);

/* Reads all of a file. */
struct text read_whole(const char *name);

struct text copy_operand(const char *operand);
void text_free(struct text *);

#endif
