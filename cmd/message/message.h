/* SPDX-License-Identifier: MIT */
/* Messages on standard error, the end of the program, memory, and standard output. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "../../core/refusal/refusal.h"
#include "phrase.h"

/* SAY_NOTE is no exit status: say_at then prints a note. */
enum { SAY_NOTE = -1, EXIT_OK, EXIT_INPUT, EXIT_USAGE, EXIT_SYSTEM };

/* The place of a document that --scenes reads. */
struct scene_place {
	long number; /* index of the document, from 1; 0: no document */
	long line;   /* the first line of the document, from 1 */
};

/* The place that a message is about; all members may be 0. A message is text or, by
 * --errors json, a JSON object. */
struct place {
	const char *file;
	long long line;      /* from 1; text omits it if pointer is set */
	size_t column;       /* in bytes from 1 */
	bool of_points;      /* `line` is the index of a binary point, from 1 */
	const char *pointer; /* into a JSON document: "/camera/eye" */
	/* If scene.number is 0, message_state.scene is used instead. */
	struct scene_place scene;
	/* Words between a message as text and its place; NULL: the place is first. */
	const char *before_place;
};

/* Prints one line: "projcalc: ", the place, which may be NULL, what is wrong and, after
 * "; ", the remedy, which may be NULL or "". status is the exit status; below 1 the
 * level is "note", which text says before the place if status is SAY_NOTE. */
void say_at(int status, const struct place *, const char *what, const char *remedy);

/* Does what say_at does, and exits with status, from any thread. */
_Noreturn void die_at(int status, const struct place *, const char *what,
    const char *remedy);
_Noreturn void die(int status, const char *what, const char *remedy);

/* Exits with status, from any thread. */
_Noreturn void end_program(int status);

/* Returns whether to say a note of this kind, from 0 to 31: true at the first call for
 * each kind, unless message_state.quiet is set. */
bool note_is_new(unsigned kind);

/* The choices of --color: whether messages and help are coloured. */
enum color { COLOR_AUTO, COLOR_ALWAYS, COLOR_NEVER };

extern struct message_state {
	unsigned json;            /* 1: a message is a JSON object in one line */
	unsigned color;           /* an enum color */
	bool quiet;               /* notes are left out */
	struct scene_place scene; /* the current scene of --scenes */
} message_state;

/* Returns whether output to fd is coloured. COLOR_AUTO colours a terminal, unless the
 * environment has NO_COLOR (no-color.org) or TERM=dumb. */
bool output_is_colored(int fd);

/* Returns memory as realloc does, or exits with status 3. */
void *xrealloc(void *old, size_t size);

/* Returns whether to repeat a failed read or write of fd: true if errno is EINTR or
 * EAGAIN. After EAGAIN, as from a pipe that another process made non-blocking, first
 * waits until poll reports one of the events. */
bool io_retry(int fd, short events);

/* Enlarges the buffer of fd to size bytes if fd is a pipe and the system permits it, so
 * that fewer reads and writes are needed. */
void pipe_enlarge(int fd, int size);

/* Writes all bytes to standard output, or exits with status 3. */
void output_write(const char *s, size_t size);

/* From output_gather on, output_write keeps up to 64 KB, which output_flush, a message
 * and the end of the program write: a program that gathers flushes before it waits. */
void output_gather(void);
void output_flush(void);

/* Gathers text of the help, formatted as by printf, and cut at TEXT_ROOM bytes. stdio
 * is not used, because it loses text if a non-blocking pipe is full. */
void output_printf(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Writes what is gathered, and closes standard output. Exits with status 3 if an
 * earlier write failed and the system reports it only when the output is closed. */
void output_close(void);
