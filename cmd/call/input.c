/* SPDX-License-Identifier: MIT */
#include "operands.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../stream/source.h"
#include "../message/message.h"

bool is_stdin(const char *operand)
{
	return strcmp(operand, "-") == 0;
}

char first_nonblank(const char *s)
{
	while (isspace((unsigned char)*s))
		s++;
	return *s;
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

bool check_input(const char *name, int fd)
{
	const struct place place = { .file = name };
	struct stat in, out;

	if (fd >= 0 ? fstat(fd, &in) != 0 : stat(name, &in) != 0)
		return false;
	if (S_ISDIR(in.st_mode))
		die_at(EXIT_USAGE, &place, "is a directory");
	if (S_ISREG(in.st_mode) && fstat(STDOUT_FILENO, &out) == 0 &&
	    out.st_dev == in.st_dev && out.st_ino == in.st_ino)
		die_at(EXIT_USAGE, &place,
		    "is also the output; write to another file");
	return true;
}

int open_input(const char *name)
{
	int fd = is_stdin(name) ? STDIN_FILENO : open_file(name);

	if (fd < 0 || !check_input(name, fd))
		die_at(EXIT_USAGE, &(struct place){ .file = name }, "%s",
		    strerror(errno));
	return fd;
}

static void text_reserve(struct text *t, size_t room)
{
	t->s = xrealloc(t->s, room + PIECE_MARGIN);
	t->room = room;
}

bool text_read_more(struct text *t, int fd, const char *name)
{
	ssize_t n;

	if (t->size == t->room)
		text_reserve(t, t->room > 0 ? 2 * t->room : 1 << 16);
	size_t left = t->room - t->size;

	/* some systems refuse to read more than INT_MAX bytes at once */
	do
		n = read(fd, t->s + t->size, left < INT_MAX ? left : INT_MAX);
	while (n < 0 && io_retry(fd, POLLIN));
	if (n < 0)
		die_at(EXIT_SYSTEM, &(struct place){ .file = name }, "%s",
		    strerror(errno));
	t->size += (size_t)n;
	return n > 0;
}

struct text text_of_file(const char *name)
{
	struct text t = { 0 };
	int fd = open_input(name);

	while (text_read_more(&t, fd, name))
		continue;
	close(fd);
	return t;
}

struct text text_of_operand(const char *operand)
{
	struct text t = { .size = strlen(operand) };

	text_reserve(&t, t.size);
	memcpy(t.s, operand, t.size);
	return t;
}

void text_free(struct text *t)
{
	free(t->s);
	*t = (struct text){ 0 };
}
