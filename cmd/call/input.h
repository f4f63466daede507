/* SPDX-License-Identifier: MIT */
/* Files and operands become texts, which the caller owns until input_free. This module
 * refuses what can't be input: a directory, and the file that is also the output. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* A text of `size` bytes at `s`. `room` + LINE_MARGIN bytes are allocated, as the
 * readers of points read past the end of the text. */
struct input_text {
	char *s; /* NULL at first */
	size_t room, size;
};

bool input_is_stdin(const char *operand);

/* Returns the first character that is not white space; 0 if there is none. */
char input_first_char(const char *);

/* Returns whether a file, or standard input for "-", can be read; sets errno. Refuses,
 * with status 2, a directory, and the file to which standard output goes. */
bool input_check(const char *name);

/* Returns a descriptor of a file, or of standard input for "-";
 * refuses with status 2. */
int input_open(const char *name);

/* Appends the next bytes of fd to the text. Returns false at the end of the file. */
bool input_append(struct input_text *, int fd, const char *name);

/* Returns the text of a file, or of standard input for "-". */
struct input_text input_of_file(const char *name);

struct input_text input_of_operand(const char *operand);
void input_free(struct input_text *);
