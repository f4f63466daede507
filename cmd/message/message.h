/* SPDX-License-Identifier: MIT */
/* Messages on standard error, the end of the program, memory, and standard output. */
#ifndef MESSAGE_H
#define MESSAGE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

/* The exit statuses. */
enum { EXIT_OK, EXIT_INPUT, EXIT_USAGE, EXIT_SYSTEM };

/* One of the documents of --scenes. */
struct scene_place {
	long number; /* from 1; 0: no scene */
	long line;   /* the first line of the document, from 1 */
};

/* The place that a message is about. All members may be 0. */
struct place {
	const char *file;
	long long
	    line;      /* from 1; a message as text shows the pointer instead */
	size_t column; /* in bytes from 1; only JSON messages show it */
	bool of_points;      /* line counts binary points */
	const char *pointer; /* into a JSON document: "/camera/eye" */
	/* If number is 0, message_state.scene takes its place. */
	struct scene_place scene;
	bool of_scene; /* about a scene: --keep-going goes on with the next */
	/* NULL: the place begins a message as text. Else the message begins; these
	 * words and the place follow. */
	const char *join;
};

/* Prints one line: "projcalc: ", the place, which may be NULL, and the message: what is
 * wrong and, after "; ", a hint. status is the exit status that follows, or 0 for a
 * note. */
void say_at(int status, const struct place *, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* When messages and help are coloured, by --color. */
enum color { COLOR_AUTO, COLOR_ALWAYS, COLOR_NEVER };

extern struct message_state {
	unsigned json;  /* 1: a message is a JSON object in one line */
	unsigned color; /* an enum color */
	struct scene_place scene; /* the scene that is being answered */
	/* Where die_at jumps after a message whose place is of_scene, which then has
	 * EXIT_INPUT; NULL: it exits. Only the first thread, while it is alone, jumps. */
	jmp_buf *refused;
} message_state;

/* Returns whether output to fd is coloured. COLOR_AUTO colours a terminal, unless the
 * environment has NO_COLOR (no-color.org) or TERM=dumb. */
bool is_colored(int fd);

/* Print a message as say_at does, and exit with status. Any thread may call them. */
_Noreturn void die_at(int status, const struct place *, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
_Noreturn void vdie_at(int status, const struct place *, const char *format,
    va_list) __attribute__((format(printf, 3, 0)));
#define die(status, ...) die_at(status, NULL, __VA_ARGS__)

/* Exits. Any thread may call it. */
_Noreturn void quit(int status);

/* Returns memory as realloc does, or exits with 3. */
void *xrealloc(void *old, size_t size);

/* Returns whether to repeat a read or write of fd that failed with EINTR or EAGAIN.
 * After EAGAIN, as from a pipe that another process made non-blocking, first waits
 * until poll reports one of the events. */
bool io_retry(int fd, short events);

/* Enlarges the buffer of fd to size bytes if fd is a pipe and the system permits it:
 * reads and writes become fewer. */
void pipe_enlarge(int fd, int size);

/* Writes all bytes to standard output, or exits with 3. */
void output_write(const char *s, size_t size);

/* Appends text to a buffer in memory, by printf's format. stdio would lose without an
 * error what a full pipe refuses. */
int print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Writes the buffer of print, and closes standard output. Exits with 3 if the system
 * reports an earlier error of a write only now. */
void output_close(void);

#endif
