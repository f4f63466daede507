/* for F_SETPIPE_SZ, where there is one */
#define _GNU_SOURCE
#include "talk.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char scene[64];

void say_scene(long number, long line)
{
	*scene = '\0';
	if (number > 0)
		snprintf(scene, sizeof scene, "scene %ld, line %ld: ", number,
		    line);
}

const char *said_scene(void)
{
	return scene;
}

/* One line in one write, even where a file's name has newlines in it. */
static void print_line(const char *format, va_list args)
{
	char text[8192];

	vsnprintf(text, sizeof text, format, args);
	for (char *c = text; *c != '\0'; c++)
		if ((unsigned char)*c < ' ' || *c == 0x7f)
			*c = '?';
	fprintf(stderr, "projcalc: %s%s\n", scene, text);
}

void say(const char *format, ...)
{
	va_list args;

	va_start(args, format);
	print_line(format, args);
	va_end(args);
}

/* Returns to the first thread that calls it, which ends the program: of several
 * threads that fail together only one prints why. */
static void be_last(void)
{
	static atomic_flag ending = ATOMIC_FLAG_INIT;

	while (atomic_flag_test_and_set(&ending))
		pause();
}

void die(int status, const char *format, ...)
{
	va_list args;

	be_last();
	va_start(args, format);
	print_line(format, args);
	va_end(args);
	exit(status);
}

void quit(int status)
{
	be_last();
	exit(status);
}

void *need(void *old, size_t size)
{
	void *p = realloc(old, size > 0 ? size : 1);

	if (p == NULL)
		die(EXIT_SYSTEM, "out of memory");
	return p;
}

static _Noreturn void no_output(void)
{
	die(EXIT_SYSTEM, "standard output: %s", strerror(errno));
}

bool go_on(int fd, short events)
{
	struct pollfd p = { .fd = fd, .events = events };

	if (errno != EAGAIN && errno != EWOULDBLOCK)
		return errno == EINTR;
	return poll(&p, 1, -1) >= 0 || errno == EINTR;
}

void widen_pipe(int fd, int room)
{
#ifdef F_SETPIPE_SZ
	if (fcntl(fd, F_GETPIPE_SZ) < room)
		fcntl(fd, F_SETPIPE_SZ, room);
#else
	(void)fd, (void)room;
#endif
}

void put_all(const char *s, size_t size)
{
	while (size > 0) {
		ssize_t n = write(STDOUT_FILENO, s, size);

		if (n < 0 && go_on(STDOUT_FILENO, POLLOUT))
			continue;
		if (n < 0)
			no_output();
		s += n;
		size -= (size_t)n;
	}
}

void close_output(void)
{
	if (close(STDOUT_FILENO) != 0 && errno != EINTR)
		no_output();
}
