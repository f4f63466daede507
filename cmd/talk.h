/* Messages, exits and what every command needs of the system. */
#ifndef TALK_H
#define TALK_H

#include <stdbool.h>
#include <stddef.h>

/* What the exit status means. */
enum { EXIT_OK, EXIT_INPUT, EXIT_USAGE, EXIT_SYSTEM };

/* Prints "projcalc: " and one line, without control characters. */
void say(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Everything that is said from now on begins with "scene 2, line 5: ", or where
 * number is 0 without it. */
void say_scene(long number, long line);

/* That beginning. */
const char *said_scene(void);

/* The same as say, and exits with that status. Any thread may call it. */
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

/* Closes standard output, where the error of a write can still come up: exits
 * with 3 then. */
void close_output(void);

#endif
