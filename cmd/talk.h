/* Messages, exits and what every command needs of the system. */
#ifndef TALK_H
#define TALK_H

#include <stdbool.h>
#include <stddef.h>

/* What the exit status means. */
enum { EXIT_OK, EXIT_INPUT, EXIT_USAGE, EXIT_SYSTEM };

/* Prints "projcalc: " and one line, without control characters. */
void say(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The same, and exits. */
_Noreturn void die(int status, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Exits; any thread may. */
_Noreturn void quit(int status);

/* Memory or exit 3. */
void *need(void *old, size_t size);

/* After a call that failed: whether it is to be made again, for it was
 * interrupted, or would not wait (as another process can have it) and the
 * events of poll have come since. */
bool go_on(int fd, short events);

/* Writes all of it to standard output, or exits with 3. */
void put_all(const char *s, size_t size);

/* Output is done when it is closed without error. */
void close_output(void);

#endif
