/* SPDX-License-Identifier: MIT */
/* for F_SETPIPE_SZ of Linux */
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

struct message_state message_state;

bool output_is_colored(int fd)
{
	const char *no = getenv("NO_COLOR"), *term = getenv("TERM");

	if (message_state.color != COLOR_AUTO)
		return message_state.color == COLOR_ALWAYS;
	return (no == NULL || *no == '\0') && term != NULL &&
	    strcmp(term, "dumb") != 0 && isatty(fd);
}

/* A line has room for a message, a file name, a JSON pointer and as much fixed text as
 * one of the three. Each of the three is cut at MESSAGE_MAX bytes (no path that can be
 * opened is as long), and each of its bytes may become JSON_ESCAPE_MAX bytes. */
enum {
	MESSAGE_MAX = 4096,
	LINE_ROOM = 4 * JSON_ESCAPE_MAX * MESSAGE_MAX,
};

/* The line that print_line writes by one call, as other processes may write to
 * standard error. It is too large for a thread's stack; flockfile(stderr) guards it. */
static struct {
	char s[LINE_ROOM];
	size_t n;
} line;

static void __attribute__((format(printf, 1, 2))) addf(const char *format, ...)
{
	va_list args;

	va_start(args, format);
	line.n += (size_t)vsnprintf(line.s + line.n, LINE_ROOM - line.n, format, args);
	va_end(args);
}

static void add_escaped(const char *s)
{
	line.n += escape_copy(line.s + line.n, LINE_ROOM - line.n, s,
	    strnlen(s, MESSAGE_MAX), message_state.json, "");
}

/* Adds the message to `line` as text; the place is last if p->before_place is set. */
static void add_text(int status, const struct place *p, const char *message)
{
	static const char *const colors[] = { "\033[1m", "\033[1;31m" };
	bool colored = output_is_colored(STDERR_FILENO);
	bool pointer = p->pointer != NULL && *p->pointer != '\0';

	addf("%sprojcalc:%s %s", colored ? colors[status > 0] : "",
	    colored ? "\033[0m" : "", status == SAY_NOTE ? "note: " : "");
	if (p->before_place != NULL) {
		add_escaped(message);
		addf("%s", p->before_place);
	}
	if (p->scene.number > 0)
		addf("scene %ld, line %ld: ", p->scene.number, p->scene.line);
	if (p->file != NULL)
		add_escaped(p->file);
	if (p->line > 0 && !pointer)
		addf(p->of_points ? ": point %lld" : ":%lld", p->line);
	if (p->before_place != NULL)
		return;
	if (p->file != NULL)
		addf(": ");
	if (pointer) {
		add_escaped(p->pointer);
		addf(": ");
	}
	add_escaped(message);
}

/* Cuts a message at the first "; " outside of quotes. Returns the hint behind it or
 * NULL. An opening quote, unlike an apostrophe, is first or follows a blank. */
static const char *cut_hint(char *message)
{
	char quote = '\0';

	for (char *s = message; *s != '\0'; s++)
		if (quote != '\0') {
			quote = *s == quote ? '\0' : quote;
		} else if (strchr("'\"", *s) && (s == message || s[-1] == ' ')) {
			quote = *s;
		} else if (strncmp(s, "; ", 2) == 0) {
			*s = '\0';
			return s + 2;
		}
	return NULL;
}

static void add_member(const char *name, const char *s)
{
	addf(",\"%s\":\"", name);
	add_escaped(s);
	addf("\"");
}

/* Adds the message to `line` as a JSON object. */
static void add_json(int status, const struct place *p, char *message)
{
	const char *hint = cut_hint(message);

	addf("{\"level\":\"%s\"", status > 0 ? "error" : "note");
	if (p->scene.number > 0)
		addf(",\"scene\":%ld,\"scene_line\":%ld", p->scene.number,
		    p->scene.line);
	if (p->file != NULL)
		add_member("file", p->file);
	if (p->line > 0)
		addf(",\"%s\":%lld", p->of_points ? "point" : "line", p->line);
	if (p->column > 0)
		addf(",\"column\":%zu", p->column);
	if (p->pointer != NULL && *p->pointer != '\0')
		add_member("pointer", p->pointer);
	add_member("reason", message);
	if (hint != NULL)
		add_member("hint", hint);
	addf(",\"status\":%d}", status > 0 ? status : EXIT_OK);
}

void vsay_at(int status, const struct place *place, const char *format, va_list args)
{
	struct place p = place != NULL ? *place : (struct place){ 0 };
	char message[MESSAGE_MAX];

	if (p.scene.number == 0)
		p.scene = message_state.scene;
	vsnprintf(message, sizeof message, format, args);
	flockfile(stderr);
	line.n = 0;
	if (message_state.json)
		add_json(status, &p, message);
	else
		add_text(status, &p, message);
	addf("\n");
	fwrite(line.s, 1, line.n, stderr);
	funlockfile(stderr);
}

void say_at(int status, const struct place *place, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	vsay_at(status, place, format, args);
	va_end(args);
}

bool note_is_new(unsigned kind)
{
	static unsigned said;
	const bool is_new = (said >> kind & 1) == 0 && !message_state.quiet;

	said |= 1u << kind;
	return is_new;
}

/* Returns in the first thread that calls it, and never in another: if several threads
 * fail together, only the first prints a message and ends the program. */
static void wait_unless_first(void)
{
	static atomic_flag ending = ATOMIC_FLAG_INIT;

	while (atomic_flag_test_and_set(&ending))
		pause();
}

void die_at(int status, const struct place *place, const char *format, ...)
{
	const bool ends = place == NULL || !place->of_scene ||
	    message_state.on_refusal == NULL;
	va_list args;

	if (ends)
		wait_unless_first();
	va_start(args, format);
	vsay_at(ends ? status : EXIT_INPUT, place, format, args);
	va_end(args);
	if (ends)
		exit(status);
	quit(EXIT_INPUT, true);
}

void quit(int status, bool of_scene)
{
	if (of_scene && message_state.on_refusal != NULL)
		longjmp(*message_state.on_refusal, 1);
	wait_unless_first();
	exit(status);
}

void *xrealloc(void *old, size_t size)
{
	void *p = realloc(old, size > 0 ? size : 1);

	if (p == NULL)
		die(EXIT_SYSTEM, "out of memory");
	return p;
}

static _Noreturn void die_of_output(void)
{
	die(EXIT_SYSTEM, "standard output: %s", strerror(errno));
}

bool io_retry(int fd, short events)
{
	struct pollfd p = { .fd = fd, .events = events };

	if (errno != EAGAIN && errno != EWOULDBLOCK)
		return errno == EINTR;
	return poll(&p, 1, -1) >= 0 || errno == EINTR;
}

void pipe_enlarge(int fd, int size)
{
#ifdef F_SETPIPE_SZ
	if (fcntl(fd, F_GETPIPE_SZ) < size)
		fcntl(fd, F_SETPIPE_SZ, size);
#else
	(void)fd, (void)size;
#endif
}

void output_write(const char *s, size_t size)
{
	while (size > 0) {
		ssize_t n = write(STDOUT_FILENO, s, size);

		if (n < 0 && io_retry(STDOUT_FILENO, POLLOUT))
			continue;
		if (n < 0)
			die_of_output();
		s += n;
		size -= (size_t)n;
	}
}

/* The longest help, that of persp, has less than 5,000 bytes. */
static struct {
	char s[1 << 15];
	size_t n;
} printed;

void output_printf(const char *format, ...)
{
	va_list args;

	va_start(args, format);
	printed.n += (size_t)vsnprintf(printed.s + printed.n,
	    sizeof printed.s - printed.n, format, args);
	va_end(args);
}

void output_close(void)
{
	output_write(printed.s, printed.n);
	if (close(STDOUT_FILENO) != 0 && errno != EINTR)
		die_of_output();
}
