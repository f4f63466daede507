/* SPDX-License-Identifier: MIT */
#include "job.h"

#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* The totals of all chunks that were answered. One thread at a time uses them. */
static struct {
	struct place next; /* of the next line of the source */
	bool unended;      /* the last byte printed is no newline */
	size_t bad;        /* lines */
	bool bad_scene;
	bool of_points;     /* the last bad lines are binary points */
	size_t imageless;   /* points without image */
	struct place where; /* of the first point without image */
} answer;

/* Seconds before progress is first shown, and from one display to the next. */
#define PROGRESS_BEGINS 0.5
#define PROGRESS_STEP 0.2

static struct {
	bool on, asked;
	bool terminal;      /* a line of a terminal is overwritten each time */
	bool shown;         /* the terminal's line shows progress */
	double start, last; /* times of the first call and the last display */
	long long lines;    /* done, of all sources */
	long long bytes;    /* done, of this source */
	long long size;     /* all bytes of this source; 0: unknown */
} progress;

/* Returns the time in seconds. */
static double now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

void answer_progress(bool asked)
{
	if (progress.start > 0)
		return;
	progress.asked = asked;
	progress.terminal = isatty(STDERR_FILENO) && !message_state.json;
	progress.on = asked || (progress.terminal && !isatty(STDOUT_FILENO));
	progress.start = progress.last = now();
}

void answer_source(const struct job *j, const struct point_source *s)
{
	answer.next = (struct place){ .file = s->name,
		.line = 1,
		.scene = message_state.scene,
		.of_points = is_binary(j->layout.in.format) };
	progress.bytes = 0;
	progress.size = s->size;
}

/* Clears the line of progress before a message. */
static void clear_progress(void)
{
	if (progress.shown)
		fputs("\r\033[K", stderr);
	progress.shown = false;
}

static void show_progress(double time)
{
	double rate = (double)progress.lines / (time - progress.start);
	char text[96], share[16] = "";

	if (progress.size > 0)
		snprintf(share, sizeof share, ", %.0f %%",
		    100 * (double)progress.bytes / (double)progress.size);
	snprintf(text, sizeof text, "%lld lines, %.3g a second%s",
	    progress.lines, rate, share);
	if (progress.terminal)
		fprintf(stderr, "\r\033[Kprojcalc: %s", text);
	else
		say_at(EXIT_OK, NULL, "%s", text);
	progress.shown = progress.terminal;
	progress.last = time;
}

static void add_progress(const struct chunk *c)
{
	progress.lines += (long long)c->n_lines;
	progress.bytes += (long long)c->piece.whole;
	if (!progress.on)
		return;
	double time = now();

	if (time - progress.start > PROGRESS_BEGINS &&
	    time - progress.last > PROGRESS_STEP)
		show_progress(time);
}

static void end_line(void)
{
	if (answer.unended)
		output_write("\n", 1);
	answer.unended = false;
}

void answer_no_scene(enum format out)
{
	answer.bad_scene = true;
	if (out != FORMAT_JSON)
		return;
	end_line();
	output_write("null\n", 5);
}

static void print_chunk(const struct job *j, const struct chunk *c)
{
	if (c->size == 0)
		return;
	end_line();
	answer.unended = !is_binary(j->layout.out.format) &&
	    c->out[c->size - 1] != '\n';
	output_write(c->out, c->size);
}

/* Returns the place of a line of the chunk, counted from 0. */
static struct place place_of(const struct chunk *c, size_t line)
{
	struct place p = c->place;

	p.line += (long long)line;
	return p;
}

static void report_imageless(void)
{
	answer.where.join = answer.imageless == 1 ? ": " : ", the first in ";
	if (answer.imageless == 1)
		say_at(EXIT_OK, &answer.where, "1 point has no image");
	else if (answer.imageless > 1)
		say_at(EXIT_OK, &answer.where, "%zu points have no image",
		    answer.imageless);
}

/* Reports the chunk's bad lines and the error that ended its source. Ends the program
 * after such an error, or if the job does not keep going. */
static void report_bad_lines(const struct job *j, const struct chunk *c)
{
	bool refused = c->refused || (c->n_complaints > 0 && !j->keep_going);
	bool ends = refused || c->piece.state > PIECE_LAST;
	struct place end = place_of(c, c->n_lines);

	if (ends && j->flush != NULL)
		j->flush(j);
	clear_progress();
	for (size_t i = 0; i < c->n_complaints && i < COMPLAINTS_MAX; i++) {
		struct place p = place_of(c, c->complaint[i].line);

		if (answer.bad + i < COMPLAINTS_MAX || refused)
			say_at(EXIT_INPUT, &p, "%s", c->complaint[i].reason);
	}
	answer.bad += c->n_complaints;
	answer.of_points = end.of_points;
	if (!ends)
		return;
	report_imageless();
	if (refused) {
		output_close();
		quit(EXIT_INPUT);
	}
	if (c->piece.state == PIECE_TOO_LONG)
		die_at(EXIT_INPUT, &end, "a line of more than 64 MiB");
	end.line = 0;
	die_at(EXIT_SYSTEM, &end, "%s", strerror(c->piece.error));
}

void answer_chunk(const struct job *j, struct chunk *c)
{
	c->place = answer.next;
	if (j->collect != NULL)
		j->collect(j, c);
	else if (!c->refused)
		print_chunk(j, c);
	if (answer.imageless == 0)
		answer.where = place_of(c, c->first_imageless);
	if (j->count_imageless)
		answer.imageless += c->imageless;
	if (c->n_complaints > 0 || c->piece.state > PIECE_LAST)
		report_bad_lines(j, c);
	answer.next.line += (long long)c->n_lines;
	add_progress(c);
}

int answer_end(void)
{
	if (progress.asked)
		show_progress(now());
	if (progress.asked && progress.shown)
		fputc('\n', stderr);
	else
		clear_progress();
	report_imageless();
	if (answer.bad > 0)
		say_at(EXIT_INPUT, NULL, "%zu bad %s%s", answer.bad,
		    answer.of_points ? "point" : "line",
		    answer.bad == 1 ? "" : "s");
	output_close();
	return answer.bad > 0 || answer.bad_scene ? EXIT_INPUT : EXIT_OK;
}
