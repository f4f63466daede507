/* SPDX-License-Identifier: MIT */
/* for F_SETPIPE_SZ, where there is one */
#define _GNU_SOURCE
#include "message.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "escape.h"

static struct scene_place scene;
static bool json;
static enum color color;

void say_scene(struct scene_place s)
{
	scene = s;
}

struct scene_place said_scene(void)
{
	return scene;
}

void say_in_json(bool on)
{
	json = on;
}

bool says_json(void)
{
	return json;
}

void message_color(enum color when)
{
	color = when;
}

bool is_colored(int fd)
{
	const char *no = getenv("NO_COLOR"), *term = getenv("TERM");

	if (color != COLOR_AUTO)
		return color == COLOR_ALWAYS;
	return (no == NULL || *no == '\0') && term != NULL &&
	    strcmp(term, "dumb") != 0 && isatty(fd);
}

/* Longer messages, and places, are cut: no path that can be opened is as long. An
 * escape takes up to six characters, and a line has three such texts, one of a
 * message and two of its place, and less than a fourth of what is fixed. */
enum {
	MESSAGE_MAX = 4096,
	ESCAPE_MAX = 6,
	LINE_ROOM = 4 * ESCAPE_MAX * MESSAGE_MAX,
};

/* One line, which is written at once, as others may write there too. It is too large
 * for a thread's stack: the lock of stderr guards it. */
struct buffer {
	char s[LINE_ROOM];
	size_t n;
};

static void buffer_add(struct buffer *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void buffer_add(struct buffer *t, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	t->n += (size_t)vsnprintf(t->s + t->n, LINE_ROOM - t->n, format, args);
	va_end(args);
}

static void buffer_place(struct buffer *t, const struct place *p)
{
	bool behind = p->join != NULL;
	bool pointer = p->pointer != NULL && *p->pointer != '\0';
	const struct scene_place *s = &p->scene;

	if (behind)
		buffer_add(t, "%s", p->join);
	if (s->number > 0)
		buffer_add(t, "scene %ld, line %ld: ", s->number, s->line);
	if (p->file != NULL)
		buffer_add(t, "%.*s", MESSAGE_MAX, p->file);
	if (p->line > 0 && !pointer)
		buffer_add(t, p->of_points ? ": point %lld" : ":%lld", p->line);
	if (p->file != NULL && !behind)
		buffer_add(t, ": ");
	if (pointer)
		buffer_add(t, "%.1000s%s", p->pointer, behind ? "" : ": ");
}

/* Control characters are escaped, even of a file's name that has newlines. */
static void write_text(int status, const struct place *p, const char *message)
{
	bool colored = is_colored(STDERR_FILENO);
	static const char *const paint[] = { "\033[1m", "\033[1;31m" };
	static struct buffer raw, line;

	raw.n = line.n = 0;
	if (p->join == NULL)
		buffer_place(&raw, p);
	buffer_add(&raw, "%s", message);
	if (p->join != NULL)
		buffer_place(&raw, p);
	buffer_add(&line, "%sprojcalc:%s ", colored ? paint[status > 0] : "",
	    colored ? "\033[0m" : "");
	line.n += escape_text(line.s + line.n, LINE_ROOM - line.n - 1, raw.s,
	    raw.n);
	line.s[line.n++] = '\n';
	fwrite(line.s, 1, line.n, stderr);
}

static void buffer_string(struct buffer *t, const char *name, const char *s,
    size_t n)
{
	if (n > MESSAGE_MAX)
		n = MESSAGE_MAX;
	buffer_add(t, "%s\"%s\":\"", t->n > 1 ? "," : "", name);
	t->n += escape_json(t->s + t->n, LINE_ROOM - t->n, s, n);
	buffer_add(t, "\"");
}

/* The reason is the message up to a hint. */
static void write_json(int status, const struct place *p, const char *message,
    size_t reason)
{
	static struct buffer t;
	size_t n = strlen(message);

	t.n = 0;
	buffer_add(&t, "{");
	if (p->scene.number > 0)
		buffer_add(&t, "\"scene\":%ld,\"scene_line\":%ld",
		    p->scene.number, p->scene.line);
	if (p->file != NULL)
		buffer_string(&t, "file", p->file, strlen(p->file));
	if (p->line > 0)
		buffer_add(&t, ",\"%s\":%lld", p->of_points ? "point" : "line",
		    p->line);
	if (p->column > 0)
		buffer_add(&t, ",\"column\":%zu", p->column);
	if (p->pointer != NULL && *p->pointer != '\0')
		buffer_string(&t, "pointer", p->pointer, strlen(p->pointer));
	buffer_string(&t, "reason", message, reason);
	if (reason + 2 < n)
		buffer_string(&t, "hint", message + reason + 2, n - reason - 2);
	buffer_add(&t, ",\"status\":%d}\n", status);
	fwrite(t.s, 1, t.n, stderr);
}

/* How long a message is up to its hint, which follows the first "; " outside of
 * quotes. An apostrophe does not stand behind a blank. */
static size_t reason_length(const char *message)
{
	const char *s;
	char quote = '\0';

	for (s = message; *s != '\0'; s++)
		if (quote != '\0')
			quote = *s == quote ? '\0' : quote;
		else if (strchr("'\"", *s) && (s == message || s[-1] == ' '))
			quote = *s;
		else if (strncmp(s, "; ", 2) == 0)
			break;
	return (size_t)(s - message);
}

/* Adds to a message which character cannot be seen in it or in its place. */
static void name_unseen(const struct place *p, char message[MESSAGE_MAX])
{
	const char *texts[] = { message, p->file, p->pointer };
	const size_t n = strlen(message);
	unsigned code = 0;

	for (int i = 0; i < 3 && code == 0; i++)
		code = texts[i] != NULL ? escape_unseen(texts[i]) : 0;
	if (code != 0)
		snprintf(message + n, MESSAGE_MAX - n,
		    " (U+%04X in it can't be seen)", code);
}

static void print_line(int status, const struct place *place,
    const char *format, va_list args)
{
	struct place p = { 0 };
	char message[MESSAGE_MAX];

	if (place != NULL)
		p = *place;
	if (p.scene.number == 0)
		p.scene = scene;
	vsnprintf(message, sizeof message, format, args);
	name_unseen(&p, message);
	flockfile(stderr);
	if (json)
		write_json(status, &p, message, reason_length(message));
	else
		write_text(status, &p, message);
	funlockfile(stderr);
}

void say_at(int status, const struct place *place, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	print_line(status, place, format, args);
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

void vdie_at(int status, const struct place *place, const char *format,
    va_list args)
{
	be_last();
	print_line(status, place, format, args);
	exit(status);
}

static jmp_buf *refused;

void refusals_go_to(jmp_buf *where)
{
	refused = where;
}

void vrefuse_at(const struct place *place, const char *format, va_list args)
{
	if (refused == NULL)
		vdie_at(EXIT_INPUT, place, format, args);
	print_line(EXIT_INPUT, place, format, args);
	longjmp(*refused, 1);
}

void refuse_at(const struct place *place, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	vrefuse_at(place, format, args);
	va_end(args);
}

void die_at(int status, const struct place *place, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	vdie_at(status, place, format, args);
	va_end(args);
}

void die(int status, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	vdie_at(status, NULL, format, args);
	va_end(args);
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

static struct {
	char *s;
	size_t n;
} printed;

int print(const char *format, ...)
{
	va_list args, again;

	va_start(args, format);
	va_copy(again, args);
	size_t n = (size_t)vsnprintf(NULL, 0, format, args);

	printed.s = need(printed.s, printed.n + n + 1);
	vsnprintf(printed.s + printed.n, n + 1, format, again);
	printed.n += n;
	va_end(again);
	va_end(args);
	return (int)n;
}

void put_printed(void)
{
	put_all(printed.s, printed.n);
}

void close_output(void)
{
	if (close(STDOUT_FILENO) != 0 && errno != EINTR)
		no_output();
}
