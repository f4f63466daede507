/* SPDX-License-Identifier: MIT */
/* Reads any bytes as a source of points that arrives in small parts, for libFuzzer,
 * with the threads of stream.c, for points, for runs with names, or for the parts of
 * --lines. Output and messages must be those of the same bytes in one part, and the
 * scalar code must give those of the vector code. The functions here
 * replace those of message.c and, by --wrap, read and poll. */
#include <errno.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

#include "../scene/document.h"
#include "layout.h"
#include "../stream/answer.h"
#include "../stream/lines.h"
#include "../stream/runs.h"
#include "../stream/stream.h"
#include "../message/message.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
ssize_t __real_read(int fd, void *to, size_t n);
ssize_t __wrap_read(int fd, void *to, size_t n);
int __real_poll(struct pollfd *, nfds_t n, int wait);
int __wrap_poll(struct pollfd *, nfds_t n, int wait);

/* The descriptor of the source, which no file has. */
enum { SOURCE = -77 };

static const uint8_t *data_at;
static size_t data_left;
static uint32_t state; /* of the pseudo-random numbers */

static uint32_t next_random(void)
{
	state ^= state << 13;
	state ^= state >> 17;
	return state ^= state << 5;
}

ssize_t __wrap_read(int fd, void *to, size_t n)
{
	if (fd != SOURCE)
		return __real_read(fd, to, n);
	size_t some = 1 + next_random() % (next_random() % 8 != 0 ? 64 : 4096);

	if (some % 16 == 7) {
		errno = EINTR;
		return -1;
	}
	if (n > some)
		n = some;
	if (n > data_left)
		n = data_left;
	memcpy(to, data_at, n);
	data_at += n;
	data_left -= n;
	return (ssize_t)n;
}

int __wrap_poll(struct pollfd *p, nfds_t n, int wait)
{
	if (p->fd != SOURCE)
		return __real_poll(p, n, wait);
	return next_random() % 4 != 0;
}

/* The bytes that were written to standard output, and the messages. */
static struct bytes {
	char *s;
	size_t n, room;
} printed, said;

static void add(struct bytes *b, const char *s, size_t n)
{
	if (b->n + n > b->room) {
		b->room = 2 * (b->n + n);
		b->s = realloc(b->s, b->room);
	}
	if (n > 0)
		memcpy(b->s + b->n, s, n);
	b->n += n;
}

bool io_retry(int fd, short events)
{
	(void)fd;
	(void)events;
	return errno == EINTR;
}

void pipe_enlarge(int fd, int room)
{
	(void)fd, (void)room;
}

void output_write(const char *s, size_t n)
{
	add(&printed, s, n);
}

void output_close(void)
{
	abort();
}

void output_flush(void)
{
}

void say_at(int status, const struct place *place, const char *what, const char *remedy)
{
	const struct place none = { 0 }, *at = place != NULL ? place : &none;
	const char *const line = text("%lld:%zu: %s; %s", at->line, at->column, what,
	    remedy != NULL ? remedy : "");

	(void)status;
	add(&said, line, strlen(line) + 1);
}

bool note_is_new(unsigned kind)
{
	return kind == 0;
}

struct message_state message_state;

void die_at(int status, const struct place *place, const char *what, const char *remedy)
{
	(void)status, (void)place, (void)what, (void)remedy;
	abort();
}

void die(int status, const char *what, const char *remedy)
{
	die_at(status, NULL, what, remedy);
}

void end_program(int status)
{
	(void)status;
	abort();
}

void *xrealloc(void *old, size_t size)
{
	return realloc(old, size);
}

static struct scene scene(void)
{
	static struct refusals none;
	static char camera[] =
	    "{\"camera\":{\"eye\":[1,2,-5],\"at\":[0,0,0]},"
	    "\"projection\":{\"type\":\"persp\",\"fovy\":60,\"near\":1,"
	    "\"far\":10},\"viewport\":{\"width\":640,\"height\":480},"
	    "\"window\":{\"center\":[1,2],\"width\":3,\"height\":4},"
	    "\"device\":{\"width\":5,\"height\":6}}";
	struct document_wants wants = { .used = ~0u, .source.faults = &none };
	struct document d;

	document_read(&d, "s", camera, sizeof camera - 1, &wants);
	return d.scene;
}

/* Sets --append if input and output have the same format of lines, and records of four
 * numbers if the input is binary. */
static void set_more(struct layout *l)
{
	const enum format in = l->in.format, out = l->out.format;

	if (format_is_binary(in) && l->reads == l->writes) {
		l->record = 4;
		l->output.keeps = in == out;
		l->output.flags = false;
	}
	l->output.append = !format_is_binary(in) && in != FORMAT_SNIFF && in == out;
	for (int k = 0; l->output.append && k < l->writes; k++) {
		memmove(l->output.name[k] + 2, l->output.name[k], NAME_ROOM - 2);
		memcpy(l->output.name[k], "a_", 2);
	}
}

static void add_run(void *data, const struct run *run)
{
	const struct transform *t = &((const struct job *)data)->transform;

	for (size_t i = 0; i < run->n; i++) {
		const struct run_point *p = &run->point[i];

		add(&printed, (const char *)p->in, (size_t)t->in * sizeof *p->in);
		add(&printed, (const char *)p->image, (size_t)t->out * sizeof *p->in);
		add(&printed, (const char *)&p->outside, 1);
		add(&printed, run->names + p->name, p->name_size);
	}
	add(&printed, "|", 1);
}

/* Makes runs of the points: --lines, or with names as draw takes them. */
static void set_runs(struct job *j, const struct scene *s, enum space from,
    enum space to, bool names)
{
	static struct run_reader reader = { add_run, .names = true };
	static struct refusals none;

	reader.data = j;
	j->rays = false;
	j->layout.output.flags = j->layout.output.append = false;
	if (names)
		runs_prepare(&reader, j);
	else if (!lines_prepare(s, from, to, j, &none))
		abort();
}

/* Sets the transform of a job for as many coordinates as layout_of chose. */
static void set_job(struct job *j, const struct scene *s, uint8_t b)
{
	const bool flat = j->layout.reads == 2;
	enum space from = flat   ? FLAT_WINDOW :
	    j->layout.reads == 4 ? SPACE_CLIP :
				   SPACE_MODEL;
	enum space to = flat      ? FLAT_DEVICE :
	    j->layout.writes == 4 ? SPACE_CLIP :
				    SPACE_DEVICE;

	static struct refusals none;

	j->rays = j->layout.writes == 6;
	transform_of_scene(s, from, to, false, &j->transform, &none);
	ray_maker_of(s, &j->ray, &none);
	frustum_of(s, from, false, &j->frustum, &none);
	if (b & 64)
		set_more(&j->layout);
	if (j->rays)
		j->layout.output.flags = false;
	j->visible = !j->rays && b & 1;
	j->count_imageless = !j->layout.output.flags && !j->visible;
	j->precision = (enum precision)(b / 2 % 3);
	j->layout.output.single = j->precision == PRECISION_SINGLE;
	if (b & 128 && !format_is_binary(j->layout.in.format))
		set_runs(j, s, from, to, b & 64);
}

/* Does in one chunk what stream.c and answer.c do, as the truth about them. A newline
 * comes before the output if the last line of the source before had none. Returns false
 * if the source is refused; the threads then do not get the source, so that a refusal
 * by them is a finding. */
static bool do_at_once(struct job *j, const char *bytes, size_t size)
{
	struct point_source s = source_of_text("a", bytes, size);
	static bool unended;
	static size_t bad;
	static struct chunk *c;
	struct refusal r;

	if (c == NULL)
		c = chunk_new();
	if (!source_begin(&s, &j->layout, &r))
		return false;
	if (j->layout.plan.is_list) {
		source_read(&s, &j->layout, &c->piece);
		while (c->piece.state < PIECE_LAST)
			return false; /* too large for one piece */
	} else {
		piece_resize(&c->piece, size);
		memcpy(c->piece.text, bytes, size);
		c->piece.size = c->piece.whole_size = size;
		c->piece.state = PIECE_LAST;
	}
	c->first = FIRST_BYTE;
	c->place = (struct place){ .line = 1 };
	job_do(j, c);
	if (c->refused || c->piece.state > PIECE_LAST)
		return false;
	if (j->collect_chunk != NULL) {
		j->collect_chunk(j, c);
	} else {
		if (c->size > 0) {
			add(&printed, "\n", unended);
			unended = !format_is_binary(j->layout.out.format) &&
			    c->out[c->size - 1] != '\n';
		}
		add(&printed, c->out, c->size);
	}
	for (size_t i = 0; i < c->n_complaints && bad + i < COMPLAINTS_MAX; i++) {
		const struct refusal *what = &c->complaint[i];
		struct place p = { .line = chunk_line(c, (size_t)what->line),
			.column = what->column,
			.of_points = format_is_binary(j->layout.in.format) };

		say_at(EXIT_INPUT, &p, what->what, what->remedy);
	}
	bad += c->n_complaints;
	return true;
}

static void compare(struct bytes *b, const struct bytes *was)
{
	if (b->n != was->n || (b->n > 0 && memcmp(b->s, was->s, b->n) != 0))
		abort();
	free(was->s);
	b->n = 0;
}

/* Prints what runs have left. A blank line before the first part depends on what was
 * printed before. */
static void flush(const struct job *j)
{
	if (j->flush == NULL)
		return;
	j->flush(j);
	if (printed.n > 0 && *printed.s == '\n')
		memmove(printed.s, printed.s + 1, --printed.n);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	static struct scene s;
	static struct job j; /* static, as the threads use it */

	if (size < HEADER)
		return 0;
	if (!s.has_viewport)
		s = scene();
	j = (struct job){ .layout = layout_of(data), .keep_going = true, .threads = 3 };
	set_job(&j, &s, data[3]);
	struct layout layout = j.layout;

	kernels_choose(data[3] & 32 ? "baseline" : NULL);
	bool whole_source = do_at_once(&j, (const char *)data + HEADER, size - HEADER);

	free(j.layout.common.text);
	flush(&j);
	struct bytes whole = printed, messages = said;

	printed = said = (struct bytes){ 0 };
	if (!whole_source) {
		free(whole.s);
		free(messages.s);
		return 0;
	}
	kernels_choose(data[3] & 32 ? NULL : "baseline");
	j.layout = layout;
	state = 1 + data[3];
	data_at = data + HEADER;
	data_left = size - HEADER;
	struct point_source source = source_of_file("a", SOURCE);
	struct refusal r;

	if (!source_begin(&source, &j.layout, &r))
		abort();
	stream_points(&j, source);
	free(j.layout.common.text);
	flush(&j);
	compare(&printed, &whole);
	compare(&said, &messages);
	return 0;
}
