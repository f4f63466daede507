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
	/* Where number is 0: what say_scene said. */
	struct scene_place scene;
	/* In text the place stands before the message; or, where this is not
	 * NULL, behind it, after these words. */
	const char *join;
};

/* Prints one line: "projcalc: ", the place, which may be NULL, and the message, in
 * whose format a hint may follow what is wrong after "; ". status is the exit status that
 * it leads to, 0 for a mere note. */
void say_at(int status, const struct place *, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Everything that is said from now on is about that scene. */
void say_scene(struct scene_place);
struct scene_place said_scene(void);

/* Messages become objects of JSON, one a line. */
void say_in_json(bool);
bool says_json(void);

/* Whether to colour what goes to a terminal. */
enum color { COLOR_AUTO, COLOR_ALWAYS, COLOR_NEVER };
void message_color(enum color);

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

/* Where refuse_at goes on after its message, in place of the program's end; NULL: it
 * ends. */
void refusals_go_to(jmp_buf *);

/* The same as vdie_at with exit status 1, of a scene: another one may follow. Only the
 * first thread may call it, while there is no other. */
_Noreturn void vrefuse_at(const struct place *, const char *format, va_list)
    __attribute__((format(printf, 2, 0)));

_Noreturn void refuse_at(const struct place *, const char *format, ...)
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
