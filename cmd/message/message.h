/* SPDX-License-Identifier: MIT */
/* Messages, exits and what every command needs of the system. */
#ifndef TALK_H
#define TALK_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

/* What the exit status means. */
enum { EXIT_OK, EXIT_INPUT, EXIT_USAGE, EXIT_SYSTEM };

/* One of the documents of --scenes: its number and its first line, from 1. */
struct scene_place {
	long number, line; /* number is 0 where there is none */
};

/* What a message is about, as far as that is known. */
struct place {
	const char *file; /* or NULL */
	long long line;   /* from 1, or 0; in text it gives way to a pointer */
	size_t column;    /* in bytes from 1, or 0; of messages as JSON */
	bool of_points;   /* it counts binary points */
	/* Of a JSON document, "/camera/eye": or NULL or "". */
	const char *pointer;
	struct scene_place scene; /* where number is 0, message_state's */
	/* It is of a scene, behind which another may follow. */
	bool of_scene;
	/* In text the place stands before the message; or, where this is not
	 * NULL, behind it, after these words. */
	const char *join;
};

/* Prints one line: "projcalc: ", the place, which may be NULL, and the message, in
 * whose format a hint may follow what is wrong after "; ". status is the exit status that
 * it leads to, 0 for a mere note. */
void say_at(int status, const struct place *, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Whether to colour what goes to a terminal. */
enum color { COLOR_AUTO, COLOR_ALWAYS, COLOR_NEVER };

extern struct message_state {
	bool json; /* messages become objects of JSON, one a line */
	enum color color;
	struct scene_place scene; /* that everything said is about */
	/* Where die_at goes on after a message of_scene, in place of the program's
	 * end; NULL: it ends. Only the first thread may say such, while there is
	 * no other. */
	jmp_buf *refused;
} message_state;

/* Whether what goes to fd is coloured: with COLOR_AUTO where it is a terminal that
 * can, and NO_COLOR (no-color.org) is not set. */
bool is_colored(int fd);

/* The same as say_at, and exits with that status. Any thread may call these. */
_Noreturn void die_at(int status, const struct place *, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
_Noreturn void vdie_at(int status, const struct place *, const char *format,
    va_list) __attribute__((format(printf, 3, 0)));
_Noreturn void die(int status, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Exits. Any thread may call it. */
_Noreturn void quit(int status);

/* As realloc, but exits with 3 where there is no memory. */
void *need(void *old, size_t size);

/* Whether to try again a read or write of fd that failed: because it was
 * interrupted; or because fd doesn't block, as another process that shares it
 * can have set it. Then waits until poll tells of one of the events. */
bool go_on(int fd, short events);

/* Makes room for so many bytes in fd, if it is a pipe, for fewer and larger reads and
 * writes; if the system refuses, it is just slower. */
void widen_pipe(int fd, int room);

/* Writes all of it to standard output, or exits with 3. */
void put_all(const char *s, size_t size);

/* As printf, and put_printed writes what all of them made: stdio would lose some of
 * what a full pipe refuses, and not tell. */
int print(const char *format, ...) __attribute__((format(printf, 1, 2)));
void put_printed(void);

/* Closes standard output, where the error of a write can still come up: exits
 * with 3 then. */
void close_output(void);

#endif
