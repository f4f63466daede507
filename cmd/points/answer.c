#include "answer.h"

#include <stdio.h>
#include <string.h>

#include "progress.h"
#include "../talk.h"

/* Of all chunks so far. It needs no lock, as no two are answered at a time. */
static struct {
	size_t next_line;         /* of the source, from 1 */
	bool unended;             /* the last line printed has no newline yet */
	size_t bad;               /* lines */
	bool keeps_going, points; /* of binary, not lines */
	size_t imageless;         /* points */
	char where[400];          /* the first of them: scene, source:line */
} answer;

void answer_source(void)
{
	answer.next_line = 1;
}

static void print(const struct job *j, const struct chunk *c)
{
	if (c->size > 0 && answer.unended)
		put_all("\n", 1);
	if (c->size > 0)
		answer.unended = !is_binary(j->layout.out.format) &&
		    c->out[c->size - 1] != '\n';
	put_all(c->out, c->size);
}

/* What the numbers of lines count, after the name of the source. */
static const char *unit(const struct job *j)
{
	return is_binary(j->layout.in.format) ? ": point " : ":";
}

static void count_imageless(const struct job *j, const struct chunk *c)
{
	if (c->imageless > 0 && answer.imageless == 0)
		snprintf(answer.where, sizeof answer.where, "%s%.250s%s%zu",
		    said_scene(), c->name, unit(j),
		    answer.next_line + c->first_imageless);
	answer.imageless += c->imageless;
}

static void say_imageless(void)
{
	if (answer.imageless == 1)
		say("1 point has no image: %s", answer.where);
	else if (answer.imageless > 1)
		say("%zu points have no image, the first in %s",
		    answer.imageless, answer.where);
}

/* Of more bad lines than that only the number is told. */
enum { TOLD = 10 };

static void complain(const struct job *j, const struct chunk *c)
{
	if (!j->keep_going && j->flush != NULL)
		j->flush(j);
	progress_clear();
	for (size_t i = 0; i < c->n_complaints && answer.bad + i < TOLD; i++)
		say("%s%s%zu: %s", c->name, unit(j),
		    answer.next_line + c->complaints[i].line,
		    c->reasons + c->complaints[i].reason);
	answer.bad += c->n_complaints;
	answer.keeps_going = j->keep_going;
	answer.points = is_binary(j->layout.in.format);
	if (!j->keep_going) {
		say_imageless();
		close_output();
		quit(EXIT_INPUT);
	}
}

static _Noreturn void stop(const struct job *j, const struct chunk *c)
{
	if (j->flush != NULL)
		j->flush(j);
	progress_clear();
	if (c->state == PIECE_TOO_LONG)
		die(EXIT_INPUT, "%s:%zu: a line of more than 64 MiB", c->name,
		    answer.next_line);
	die(EXIT_SYSTEM, "%s: %s", c->name, strerror(c->error));
}

void answer_chunk(const struct job *j, const struct chunk *c)
{
	if (j->collect != NULL)
		j->collect(j, c, answer.next_line);
	else
		print(j, c);
	if (j->count_imageless)
		count_imageless(j, c);
	if (c->n_complaints > 0)
		complain(j, c);
	answer.next_line += c->n_lines;
	progress_add(c->n_lines, c->bytes);
	if (c->state == PIECE_TOO_LONG || c->state == PIECE_FAILED)
		stop(j, c);
}

int answer_end(void)
{
	progress_end();
	say_imageless();
	if (answer.keeps_going)
		say("%zu bad %s%s", answer.bad,
		    answer.points ? "point" : "line",
		    answer.bad == 1 ? "" : "s");
	close_output();
	return answer.bad > 0 ? EXIT_INPUT : EXIT_OK;
}
