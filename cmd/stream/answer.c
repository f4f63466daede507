/* SPDX-License-Identifier: MIT */
#include "answer.h"

#include <stdio.h>
#include <string.h>

#include "progress.h"
#include "../message/message.h"

/* Of all chunks so far. It needs no lock, as no two are answered at a time. */
static struct {
	long long next_line; /* of the source, from 1 */
	bool unended;        /* the last line printed has no newline yet */
	size_t bad;          /* lines */
	bool bad_scene;
	bool of_points; /* of binary ones, that is */
	bool keeps_going;
	size_t imageless;   /* points */
	struct place where; /* the first of them */
} answer;

void answer_source(void)
{
	answer.next_line = 1;
}

static void end_line(void)
{
	if (answer.unended)
		put_all("\n", 1);
	answer.unended = false;
}

void answer_no_scene(enum format out)
{
	answer.bad_scene = true;
	if (out != FORMAT_JSON)
		return;
	end_line();
	put_all("null\n", 5);
}

static void print_chunk(const struct job *j, const struct chunk *c)
{
	if (c->size > 0)
		end_line();
	if (c->size > 0)
		answer.unended = !is_binary(j->layout.out.format) &&
		    c->out[c->size - 1] != '\n';
	put_all(c->out, c->size);
}

/* Of a line of the chunk, from 0. */
static struct place place_of(const struct job *j, const struct chunk *c,
    size_t line)
{
	return (struct place){ .file = c->name,
		.line = answer.next_line + (long long)line,
		.of_points = is_binary(j->layout.in.format) };
}

static void count_imageless(const struct job *j, const struct chunk *c)
{
	if (c->imageless > 0 && answer.imageless == 0) {
		answer.where = place_of(j, c, c->first_imageless);
		answer.where.scene = message_state.scene;
	}
	answer.imageless += c->imageless;
}

static void say_imageless(void)
{
	answer.where.join = answer.imageless == 1 ? ": " : ", the first in ";
	if (answer.imageless == 1)
		say_at(EXIT_OK, &answer.where, "1 point has no image");
	else if (answer.imageless > 1)
		say_at(EXIT_OK, &answer.where, "%zu points have no image",
		    answer.imageless);
}

/* Of more bad lines than that only the number is told. */
enum { TOLD = 10 };

static void complain(const struct job *j, const struct chunk *c)
{
	bool ends = !j->keep_going || c->refused;

	if (ends && j->flush != NULL)
		j->flush(j);
	progress_clear();
	for (size_t i = 0; i < c->n_complaints && answer.bad + i < TOLD; i++) {
		struct place p = place_of(j, c, c->complaints[i].line);

		say_at(EXIT_INPUT, &p, "%s",
		    c->reasons + c->complaints[i].reason);
	}
	answer.bad += c->n_complaints;
	answer.keeps_going = j->keep_going;
	answer.of_points = is_binary(j->layout.in.format);
	if (ends) {
		say_imageless();
		close_output();
		quit(EXIT_INPUT);
	}
}

static _Noreturn void stop(const struct job *j, const struct chunk *c)
{
	struct place p = place_of(j, c, 0);

	if (j->flush != NULL)
		j->flush(j);
	progress_clear();
	say_imageless();
	if (c->piece.state == PIECE_TOO_LONG)
		die_at(EXIT_INPUT, &p, "a line of more than 64 MiB");
	p.line = 0;
	die_at(EXIT_SYSTEM, &p, "%s", strerror(c->piece.error));
}

void answer_chunk(const struct job *j, const struct chunk *c)
{
	if (j->collect != NULL)
		j->collect(j, c, answer.next_line);
	else if (!c->refused)
		print_chunk(j, c);
	if (j->count_imageless)
		count_imageless(j, c);
	if (c->n_complaints > 0)
		complain(j, c);
	answer.next_line += (long long)c->n_lines;
	progress_add(c->n_lines, (size_t)(c->piece.got.end - c->piece.got.s));
	if (c->piece.state == PIECE_TOO_LONG || c->piece.state == PIECE_FAILED)
		stop(j, c);
}

int answer_end(void)
{
	progress_end();
	say_imageless();
	if (answer.keeps_going)
		say_at(EXIT_INPUT, NULL, "%zu bad %s%s", answer.bad,
		    answer.of_points ? "point" : "line",
		    answer.bad == 1 ? "" : "s");
	close_output();
	return answer.bad > 0 || answer.bad_scene ? EXIT_INPUT : EXIT_OK;
}
