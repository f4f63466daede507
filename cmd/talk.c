#include "talk.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void die(int status, const char *format, ...)
{
	va_list args;

	fputs("projcalc: ", stderr);
	va_start(args, format);
	vfprintf(stderr, format, args);
	va_end(args);
	fputc('\n', stderr);
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

void put_all(const char *s, size_t size)
{
	while (size > 0) {
		ssize_t n = write(STDOUT_FILENO, s, size);

		if (n < 0 && errno == EINTR)
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
