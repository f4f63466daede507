/* SPDX-License-Identifier: MIT */
#include "input.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../message/message.h"
#include "../table/plan.h"

bool input_is_stdin(const char *operand)
{
	return strcmp(operand, "-") == 0;
}

char input_first_char(const char *s)
{
	return s[strspn(s, " \t\n\v\f\r")];
}

/* Opens a file. Returns -1 or a descriptor above 2: not that of a standard stream. */
static int open_file(const char *name)
{
	int fd = open(name, O_RDONLY), low = fd;

	if (fd < 0 || fd > STDERR_FILENO)
		return fd;
	fd = fcntl(low, F_DUPFD, STDERR_FILENO + 1);
	close(low);
	return fd;
}

bool input_check(const char *name)
{
	const struct place place = { .file = name };
	struct stat in, out;

	if (input_is_stdin(name) ? fstat(STDIN_FILENO, &in) != 0 :
				   stat(name, &in) != 0 || access(name, R_OK) != 0)
		return false;
	if (S_ISDIR(in.st_mode))
		die_at(EXIT_USAGE, &place, "is a directory", NULL);
	if (S_ISREG(in.st_mode) && fstat(STDOUT_FILENO, &out) == 0 &&
	    out.st_dev == in.st_dev && out.st_ino == in.st_ino)
		die_at(EXIT_USAGE, &place, "is also the output",
		    "write to another file");
	return true;
}

int input_open(const char *name)
{
	int fd = input_is_stdin(name) ? STDIN_FILENO : open_file(name);

	if (fd < 0 || !input_check(name))
		die_at(EXIT_USAGE, &(struct place){ .file = name }, strerror(errno),
		    NULL);
	return fd;
}

static void text_reserve(struct input_text *t, size_t room)
{
	t->s = xrealloc(t->s, room + LINE_MARGIN);
	t->room = room;
}

bool input_append(struct input_text *t, int fd, const char *name)
{
	ssize_t n;

	if (t->size == t->room)
		text_reserve(t, t->room > 0 ? 2 * t->room : 1 << 16);
	size_t left = t->room - t->size;

	/* some systems refuse to read more than INT_MAX bytes at once */
	output_flush();
	do
		n = read(fd, t->s + t->size, left < INT_MAX ? left : INT_MAX);
	while (n < 0 && io_retry(fd, POLLIN));
	if (n < 0)
		die_at(EXIT_SYSTEM, &(struct place){ .file = name }, strerror(errno),
		    NULL);
	t->size += (size_t)n;
	return n > 0;
}

struct input_text input_of_file(const char *name)
{
	struct input_text t = { 0 };
	int fd = input_open(name);

	while (input_append(&t, fd, name))
		continue;
	close(fd);
	return t;
}

struct input_text input_of_operand(const char *operand)
{
	struct input_text t = { .size = strlen(operand) };

	text_reserve(&t, t.size);
	memcpy(t.s, operand, t.size);
	return t;
}

void input_free(struct input_text *t)
{
	free(t->s);
	*t = (struct input_text){ 0 };
}
