/* SPDX-License-Identifier: MIT */
#include "answer.h"

#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* The totals of all chunks that were answered. Only one thread at a time uses them. */
static struct {
	struct place next_line; /* the place of the source's next line */
	bool lacks_newline;     /* the last byte printed is no newline */
	size_t bad_lines;
	bool bad_scene;   /* a scene was refused */
	size_t imageless; /* points without image */
	size_t behind;    /* those of them whose w is not positive, up to others */
	enum behind of;   /* what they may come of */
	struct place first_imageless;
} answer;

static struct {
	bool on, asked;               /* see answer_start_progress */
	bool to_terminal;             /* each display overwrites the last */
	bool on_screen;               /* the terminal's line shows progress */
	double start_time, last_time; /* of counting; of the last display */
	long long lines;              /* answered, of all sources */
	long long bytes;              /* answered, of this source */
	long long size;               /* bytes of this source; 0: unknown */
} progress;

static double seconds_now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

void answer_start_progress(bool asked)
{
	if (progress.start_time > 0)
		return;
	progress.asked = asked;
	progress.to_terminal = isatty(STDERR_FILENO) && !message_state.json;
	progress.on = asked || (progress.to_terminal && !isatty(STDOUT_FILENO));
	progress.start_time = progress.last_time = seconds_now();
}

void answer_begin_source(const struct job *j, const struct point_source *s)
{
	answer.next_line = (struct place){ .file = s->name,
		.line = 1,
		.scene = message_state.scene,
		.of_points = format_is_binary(j->layout.in.format) };
	progress.bytes = 0;
	progress.size = s->size;
}

static void clear_progress(void)
{
	if (progress.on_screen)
		fputs("\r\033[K", stderr);
	progress.on_screen = false;
}

static void show_progress(double time)
{
	double rate = (double)progress.lines / (time - progress.start_time);
	char line[96], share[16] = "";

	if (progress.size > 0)
		snprintf(share, sizeof share, ", %.0f %%",
		    100 * (double)progress.bytes / (double)progress.size);
	snprintf(line, sizeof line, "%lld lines, %.3g a second%s", progress.lines, rate,
	    share);
	if (progress.to_terminal)
		fprintf(stderr, "\r\033[Kprojcalc: %s", line);
	else
		say_at(EXIT_OK, NULL, line, NULL);
	progress.on_screen = progress.to_terminal;
	progress.last_time = time;
}

static void add_progress(const struct chunk *c)
{
	progress.lines += (long long)c->n_lines;
	progress.bytes += (long long)c->piece.whole_size;
	if (!progress.on)
		return;
	double time = seconds_now();

	if (time - progress.start_time > 0.5 && time - progress.last_time > 0.2)
		show_progress(time);
}

static void print_newline(void)
{
	if (answer.lacks_newline)
		output_write("\n", 1);
	answer.lacks_newline = false;
}

void answer_refused_scene(bool prints_null)
{
	answer.bad_scene = true;
	if (!prints_null)
		return;
	print_newline();
	output_write("null\n", 5);
}

void answer_text(const struct job *j, struct span text)
{
	if (text.s == text.end)
		return;
	print_newline();
	answer.lacks_newline = !format_is_binary(j->layout.out.format) &&
	    text.end[-1] != '\n';
	output_write(text.s, span_size(text));
}

/* Returns the place of a line of the chunk. */
static struct place line_place(const struct chunk *c, size_t line)
{
	struct place p = c->place;

	p.line = chunk_line(c, line);
	return p;
}

static void report_imageless(void)
{
	/* what to look at if all points without image come of the same; or NULL */
	static const char *const remedies[] = {
		[BEHIND_DEPTH] = "z is a depth: of a distance say \"depth\": "
				 "\"distance\" in \"viewport\"",
		[BEHIND_AXES] = "the camera may have another program's axes (\"axes\")",
		[BEHIND_ORDER] = "the camera may have another program's axes "
				 "(\"axes\"), or w first in its \"orientation\"",
	};
	const size_t n = answer.imageless;
	const enum behind of = answer.behind == n ? answer.of : BEHIND_NOTHING;
	struct place *p = &answer.first_imageless;

	if (n == 0 || message_state.quiet)
		return;
	p->before_place = n == 1 ? ": " : ", the first in ";
	say_at(EXIT_OK, p,
	    text("%zu point%s %s%s no image", n, n == 1 ? "" : "s",
		of < BEHIND_CAMERA ? "" :
		    n == 1         ? "is behind the camera and " :
				     "are behind the camera and ",
		n == 1 ? "has" : "have"),
	    remedies[of]);
}

/* Says what is wrong at a place, and in which column if the refusal has one. */
static void say_refusal(struct place p, const struct refusal *r)
{
	p.column = r->column;
	say_at(EXIT_INPUT, &p, r->what, r->remedy);
}

static _Noreturn void end_refused(void)
{
	report_imageless();
	output_close();
	end_program(EXIT_INPUT);
}

void answer_refuse(const struct job *j, const struct point_source *s,
    const struct refusal *r)
{
	answer_begin_source(j, s);
	if (j->flush != NULL)
		j->flush(j);
	clear_progress();
	say_refusal(answer.next_line, r);
	end_refused();
}

/* Ends the program after an error, or a bad line if the job does not keep going. */
static void report_bad_lines(const struct job *j, const struct chunk *c)
{
	bool refused = c->refused || (c->n_complaints > 0 && !j->keep_going);
	bool ends = refused || c->piece.state > PIECE_LAST;
	struct place end = c->place;

	if (ends && j->flush != NULL)
		j->flush(j);
	clear_progress();
	for (size_t i = 0; i < c->n_complaints && i <= COMPLAINTS_MAX; i++) {
		struct place p = line_place(c, (size_t)c->complaint[i].line);
		bool last = i == COMPLAINTS_MAX || i + 1 == c->n_complaints;

		if (answer.bad_lines + i < COMPLAINTS_MAX || (refused && last))
			say_refusal(p, &c->complaint[i]);
	}
	answer.bad_lines += c->n_complaints;
	if (!ends)
		return;
	end.line = c->piece.state == PIECE_BROKEN ?
	    c->piece.fault.line :
	    c->place.line + (long long)c->n_lines;
	if (!refused && c->piece.state == PIECE_BROKEN)
		say_refusal(end, &c->piece.fault);
	if (refused || c->piece.state == PIECE_BROKEN)
		end_refused();
	report_imageless();
	if (c->piece.state == PIECE_TOO_LONG)
		die_at(EXIT_INPUT, &end, "a line of more than 64 MiB", NULL);
	end.line = 0;
	die_at(EXIT_SYSTEM, &end, strerror(c->piece.error), NULL);
}

void answer_chunk(struct job *j, struct chunk *c)
{
	c->place = answer.next_line;
	if (j->collect_chunk != NULL)
		j->collect_chunk(j, c);
	else
		answer_text(j, (struct span){ c->out, c->out + c->size });
	if (j->count_imageless && c->imageless > 0) {
		if (answer.imageless == 0)
			answer.first_imageless = line_place(c, c->first_imageless);
		answer.imageless += c->imageless;
		answer.behind += c->behind;
		if (c->behind > 0 && j->behind > answer.of)
			answer.of = j->behind;
	}
	if (c->n_complaints > 0 || c->piece.state > PIECE_LAST)
		report_bad_lines(j, c);
	answer.next_line.line += (long long)c->n_lines;
	add_progress(c);
}

int answer_end(int status)
{
	if (status != EXIT_OK) {
		output_close();
		return status;
	}
	if (progress.asked)
		show_progress(seconds_now());
	if (progress.asked && progress.on_screen)
		fputc('\n', stderr);
	else
		clear_progress();
	report_imageless();
	if (answer.bad_lines > 0)
		say_at(EXIT_INPUT, NULL,
		    text("%zu bad %s%s", answer.bad_lines,
			answer.next_line.of_points ? "point" : "line",
			answer.bad_lines == 1 ? "" : "s"),
		    NULL);
	output_close();
	return answer.bad_lines > 0 || answer.bad_scene ? EXIT_INPUT : EXIT_OK;
}
