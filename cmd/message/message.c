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

/* A line has room for what is wrong, a remedy, a file name, a JSON pointer and as much
 * fixed text as one of the four. Each of the four is cut at MESSAGE_MAX bytes (no path
 * that can be opened is as long), and each of its bytes may become JSON_ESCAPE_MAX. */
enum {
	MESSAGE_MAX = 4096,
	LINE_ROOM = 5 * JSON_ESCAPE_MAX * MESSAGE_MAX,
};

/* The line that say_at writes by one call, as other processes may write to
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
static void add_text(int status, const struct place *p, const char *what,
    const char *remedy)
{
	static const char *const colors[] = { "\033[1m", "\033[1;31m" };
	bool colored = output_is_colored(STDERR_FILENO);
	bool pointer = p->pointer != NULL && *p->pointer != '\0';

	addf("%sprojcalc:%s %s", colored ? colors[status > 0] : "",
	    colored ? "\033[0m" : "", status == SAY_NOTE ? "note: " : "");
	if (p->before_place != NULL) {
		add_escaped(what);
		addf("%s", p->before_place);
	}
	if (p->scene.number > 0)
		addf("scene %ld, line %ld: ", p->scene.number, p->scene.line);
	if (p->file != NULL)
		add_escaped(p->file);
	if (p->line > 0 && !pointer)
		addf(p->of_points ? ": point %lld" : ":%lld", p->line);
	if (p->column > 0 && !pointer)
		addf(":%zu", p->column);
	if (p->before_place == NULL) {
		addf("%s", p->file != NULL ? ": " : "");
		if (pointer) {
			add_escaped(p->pointer);
			addf(": ");
		}
		add_escaped(what);
	}
	if (*remedy != '\0')
		addf("; ");
	add_escaped(remedy);
}

static void add_member(const char *name, const char *s)
{
	addf(",\"%s\":\"", name);
	add_escaped(s);
	addf("\"");
}

/* Adds the message to `line` as a JSON object. */
static void add_json(int status, const struct place *p, const char *what,
    const char *remedy)
{
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
	add_member("reason", what);
	if (*remedy != '\0')
		add_member("hint", remedy);
	addf(",\"status\":%d}", status > 0 ? status : EXIT_OK);
}

void say_at(int status, const struct place *place, const char *what, const char *remedy)
{
	struct place p = place != NULL ? *place : (struct place){ 0 };

	if (p.scene.number == 0)
		p.scene = message_state.scene;
	if (remedy == NULL)
		remedy = "";
	output_flush();
	flockfile(stderr);
	line.n = 0;
	if (message_state.json)
		add_json(status, &p, what, remedy);
	else
		add_text(status, &p, what, remedy);
	addf("\n");
	fwrite(line.s, 1, line.n, stderr);
	funlockfile(stderr);
}

bool note_is_new(unsigned kind)
{
	static unsigned said;
	const bool is_new = (said >> kind & 1) == 0 && !message_state.quiet;

	said |= 1u << kind;
	return is_new;
}

/* Returns in the first thread that calls it, and never in another: if several threads
 * fail together, only the first ends the program. It may call it again, as the output
 * before its message may fail, too. */
static void wait_unless_first(void)
{
	static atomic_flag ending = ATOMIC_FLAG_INIT;
	static _Thread_local bool is_first;

	while (!is_first && atomic_flag_test_and_set(&ending))
		pause();
	is_first = true;
}

void end_program(int status)
{
	wait_unless_first();
	exit(status);
}

void die_at(int status, const struct place *place, const char *what, const char *remedy)
{
	wait_unless_first();
	say_at(status, place, what, remedy);
	exit(status);
}

void die(int status, const char *what, const char *remedy)
{
	die_at(status, NULL, what, remedy);
}

void *xrealloc(void *old, size_t size)
{
	void *p = realloc(old, size > 0 ? size : 1);

	if (p == NULL)
		die(EXIT_SYSTEM, "out of memory", NULL);
	return p;
}

static _Noreturn void die_of_output(void)
{
	message_state.scene.number = 0; /* no scene is to blame */
	die(EXIT_SYSTEM, text("standard output: %s", strerror(errno)), NULL);
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

/* Returns false, with errno, if not all is written. */
static bool write_all(const char *s, size_t size)
{
	while (size > 0) {
		ssize_t n = write(STDOUT_FILENO, s, size);

		if (n < 0 && io_retry(STDOUT_FILENO, POLLOUT))
			continue;
		if (n < 0)
			return false;
		s += n;
		size -= (size_t)n;
	}
	return true;
}

/* What output_write keeps after output_gather. The lock of stdout guards it, as any
 * thread may end the program by a message, which writes it first. No thread ends the
 * program while it holds the lock, as another may already be ending it. */
static struct {
	bool on;
	size_t n;
	char s[1 << 16];
} gathered;

void output_gather(void)
{
	gathered.on = true;
}

/* Writes and empties what is gathered. A failed write is not tried again. */
static bool write_gathered(void)
{
	const size_t n = gathered.n;

	gathered.n = 0;
	return write_all(gathered.s, n);
}

void output_flush(void)
{
	if (!gathered.on)
		return;
	flockfile(stdout);
	const bool good = write_gathered();

	funlockfile(stdout);
	if (!good)
		die_of_output();
}

void output_write(const char *s, size_t size)
{
	bool good = true;

	flockfile(stdout);
	if (gathered.n + size > sizeof gathered.s || !gathered.on)
		good = write_gathered();
	if (size > sizeof gathered.s || !gathered.on) {
		good = good && write_all(s, size);
	} else {
		memcpy(gathered.s + gathered.n, s, size);
		gathered.n += size;
	}
	funlockfile(stdout);
	if (!good)
		die_of_output();
}

void output_printf(const char *format, ...)
{
	char s[TEXT_ROOM];
	va_list args;

	va_start(args, format);
	vsnprintf(s, sizeof s, format, args);
	va_end(args);
	output_gather();
	output_write(s, strlen(s));
}

void output_close(void)
{
	output_flush();
	if (close(STDOUT_FILENO) != 0 && errno != EINTR)
		die_of_output();
}
